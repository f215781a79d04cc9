#include "runtime/geometry/polyconic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ir/space/tolerance.h"

namespace arelem::geometry {

namespace {
constexpr std::size_t matrixAt = 1;
constexpr std::size_t thicknessAt = 13;
constexpr std::size_t originAt = 14;
constexpr std::size_t lengthAt = 15;
constexpr std::size_t coefficientsAt = 16;
constexpr std::size_t rootsAt = 72;
constexpr std::size_t inPowers = 8;
/// Places at which the functions are looked at.
constexpr int looks = 1024;
}  // namespace

Polyconic Polyconic::of(std::span<const double> canon) {
  Polyconic s;
  if (canon[matrixAt] != 0.0 || canon[matrixAt + 1] != 0.0 || canon[matrixAt + 2] != 0.0) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        const double value = canon[matrixAt + static_cast<std::size_t>(4 * row + column)];
        (column < 3 ? s.rows(row, column) : s.shift[row]) = value;
      }
    }
  }
  s.thickness = canon[thicknessAt];
  const bool roots = canon[0] == 2.0;
  s.low_ = roots ? -1.0 : 0.0;
  const std::size_t each = roots ? 2 : 1;
  s.x_.set(0, canon[originAt]);
  s.x_.set(each, canon[lengthAt]);
  for (std::size_t f = 0; f < functions; ++f) {
    for (std::size_t i = 0; i < inPowers; ++i) {
      s.curves_[f].set(each * i, canon[coefficientsAt + inPowers * f + i]);
    }
    if (roots) {
      s.curves_[f].set(1, canon[rootsAt + f]);
    }
  }
  s.nose_ = roots;
  for (const Function f : {a, b, c, d}) {
    s.nose_ = s.nose_ && s.curves_[f].of[0] == 0.0;
  }
  return s;
}

double Polyconic::value(Function which, double s) const {
  return polynomial(curves_[which], s).value;
}

double Polyconic::area(double s) const {
  return value(a, s) * value(b, s) - value(c, s) * value(d, s);
}

double Polyconic::properEnd(Part beyond) const {
  const double end = beyond == Part::before ? low_ : high;
  const double way = beyond == Part::before ? -1.0 : 1.0;
  const auto line = [&](Function which) {
    const Jet<double> there = polynomial(curves_[which], end);
    return std::array{there.value, way * there.s};
  };
  // A B - C D by the way beyond the end: the functions go on along straight lines.
  const auto [a0, a1] = line(a);
  const auto [b0, b1] = line(b);
  const auto [c0, c1] = line(c);
  const auto [d0, d1] = line(d);
  const double square = a1 * b1 - c1 * d1;
  const double slope = a0 * b1 + a1 * b0 - c0 * d1 - c1 * d0;
  const double start = a0 * b0 - c0 * d0;
  constexpr double never = std::numeric_limits<double>::infinity();
  double least = never;
  const auto take = [&](double root) {
    least = std::isfinite(root) && root > 0.0 ? std::min(least, root) : least;
  };
  const double discriminant = slope * slope - 4.0 * square * start;
  // Conics that keep their form shrink to a point, at which the area only touches zero.
  if (discriminant >= -tolerance::rounding * slope * slope) {
    const double sum =
        -0.5 * (slope + std::copysign(std::sqrt(std::max(0.0, discriminant)), slope));
    take(start / sum);
    take(sum / square);
  }
  return end + way * least;
}

std::optional<PolyconicFault> faultOf(const Polyconic& surface) {
  double before = 0.0;
  for (int i = 0; i <= looks; ++i) {
    const double s = surface.low() + (Polyconic::high - surface.low()) * i / looks;
    const double top = surface.value(Polyconic::p, s);
    if (!(top > 0.5 && top < 1.0)) {
      return PolyconicFault{surface.hasRoots() ? s * s : s, true, top};
    }
    const double area = surface.area(s);
    const bool atNose = surface.hasNose() && std::abs(s) <= tolerance::rounding;
    if (!atNose && (area == 0.0 || area * before < 0.0)) {
      return PolyconicFault{surface.hasRoots() ? s * s : s, false, area};
    }
    before = area;
  }
  return std::nullopt;
}

}  // namespace arelem::geometry
