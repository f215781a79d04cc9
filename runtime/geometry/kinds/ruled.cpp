#include "runtime/geometry/kinds/ruled.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Dense>

#include "runtime/geometry/kinds.h"

namespace arelem::surface {

namespace {
constexpr int newtonLimit = 50;
/// Rulings kept for each curve distance.
constexpr int rulingsOfASpan = 64;
/// How far beyond its end points a curve is followed, in chords.
constexpr double reachOfACurve = 1.0;
/// A curve that leaves its base line steeper than this (a section that turns back) ends there.
constexpr double steepest = 8.0;

/// A place of a curve with its derivatives by the fraction.
struct CurvePlace {
  Vec3 place = Vec3::Zero(), first = Vec3::Zero(), second = Vec3::Zero();
};

/// One section curve on its carrier surface.
class Curve {
 public:
  explicit Curve(const geometry::SectionCurve& section) : section_(section) {
    if (section.isPoint()) {
      low_ = -reachOfACurve;
      high_ = 1.0 + reachOfACurve;
      return;
    }
    if (auto carrier = surfaceOf(section.surface)) {
      carrier_ = std::make_unique<AnySurface>(*std::move(carrier));
    }
    const int middle = rulingsOfASpan / 2;
    low_ = extent(middle, -1);
    high_ = extent(middle, 1);
  }

  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }

  /// Within [low, high].
  [[nodiscard]] CurvePlace at(double f) const {
    if (section_.isPoint()) {
      return {section_.start, Vec3::Zero(), Vec3::Zero()};
    }
    const auto place = section_.at(f);
    return place ? derived(*place) : CurvePlace{section_.base(f)};
  }

 private:
  /// From n . C' = 0 and C' . H C' + n . C'' = 0, with n and H gradient and Hessian of the distance
  /// to the carrier; C' = chord + s' heading, C'' = s'' heading.
  [[nodiscard]] CurvePlace derived(const Vec3& place) const {
    return std::visit(
        [&]<class S>(const S& s) {
          typename S::Hint hint{};
          const Foot foot = s.foot(place, hint);
          const Vec3 chord = section_.finish - section_.start;
          const double rise = foot.normal.dot(section_.heading);
          CurvePlace c{place, chord - foot.normal.dot(chord) / rise * section_.heading,
                       Vec3::Zero()};
          c.second = -s.bend(place, foot, c.first, hint) / rise * section_.heading;
          return c;
        },
        *carrier_);
  }

  /// The last fraction, walking from the middle of the base line, at which the curve goes on
  /// smoothly.
  [[nodiscard]] double extent(int middle, int way) const {
    const double length = (section_.finish - section_.start).norm();
    const int last = way < 0 ? -rulingsOfASpan : 2 * rulingsOfASpan;
    Vec3 before = section_.at(0.5).value_or(section_.base(0.5));
    double good = 0.5;
    for (int i = middle; i != last + way; i += way) {
      const double f = static_cast<double>(i) / rulingsOfASpan;
      const auto place = section_.at(f);
      if (!place || !(derived(*place).first.norm() <= steepest * length) ||
          (*place - before).norm() > 2.0 * steepest * length / rulingsOfASpan) {
        break;
      }
      before = *place;
      good = f;
    }
    return good;
  }

  geometry::SectionCurve section_;
  std::unique_ptr<AnySurface> carrier_;
  double low_ = 0.0, high_ = 1.0;
};

/// A place of the sheet with all derivatives that the search for a foot needs.
struct SheetPlace {
  Vec3 place, byF, byG, byFF, byFG;
};
}  // namespace

class Ruled::Sheet {
 public:
  explicit Sheet(const geometry::RuledSurface& s) : first_(s.first), second_(s.second) {
    low_ = std::max(first_.low(), second_.low());
    high_ = std::min(first_.high(), second_.high());
    atLow_ = {first_.at(low_), second_.at(low_)};
    atHigh_ = {first_.at(high_), second_.at(high_)};
    const int count = std::max(2, static_cast<int>((high_ - low_) * rulingsOfASpan) + 1);
    for (int i = 0; i < count; ++i) {
      const double f = low_ + (high_ - low_) * i / (count - 1);
      rulings_.push_back({f, first_.at(f).place, second_.at(f).place});
    }
  }

  [[nodiscard]] SheetPlace at(double f, double g) const {
    CurvePlace a, b;
    curves(f, a, b);
    return {(1.0 - g) * a.place + g * b.place, (1.0 - g) * a.first + g * b.first, b.place - a.place,
            (1.0 - g) * a.second + g * b.second, b.first - a.first};
  }

  /// Fractions from which a search for the foot of p may start.
  [[nodiscard]] Hint seed(const Vec3& p) const {
    Hint best;
    double least = std::numeric_limits<double>::infinity();
    for (const Ruling& r : rulings_) {
      const Vec3 along = r.to - r.from;
      const double squared = along.squaredNorm();
      const double g = squared > 0.0 ? std::clamp((p - r.from).dot(along) / squared, -reachOfACurve,
                                                  1.0 + reachOfACurve)
                                     : 0.0;
      const double distance = (p - r.from - g * along).squaredNorm();
      if (distance < least) {
        least = distance;
        best = {true, r.f, g};
      }
    }
    return best;
  }

 private:
  struct Ruling {
    double f;
    Vec3 from, to;
  };

  static CurvePlace onTangent(const CurvePlace& end, double beyond) {
    return {end.place + beyond * end.first, end.first, Vec3::Zero()};
  }
  void curves(double f, CurvePlace& a, CurvePlace& b) const {
    if (f < low_ || f > high_) {
      const auto& end = f < low_ ? atLow_ : atHigh_;
      const double beyond = f - (f < low_ ? low_ : high_);
      a = onTangent(end[0], beyond);
      b = onTangent(end[1], beyond);
      return;
    }
    a = first_.at(f);
    b = second_.at(f);
  }

  Curve first_, second_;
  double low_, high_;
  std::array<CurvePlace, 2> atLow_, atHigh_;
  std::vector<Ruling> rulings_;
};

Ruled::Ruled(const geometry::RuledSurface& surface)
    : sheet_(std::make_shared<const Sheet>(surface)) {}

namespace {
/// One Newton step on half the squared distance, turned to Gauss-Newton where it is not convex.
Eigen::Vector2d descent(const SheetPlace& s, const Vec3& rest) {
  const Eigen::Vector2d slope(-rest.dot(s.byF), -rest.dot(s.byG));
  Eigen::Matrix2d h;
  h << s.byF.squaredNorm() - rest.dot(s.byFF), s.byF.dot(s.byG) - rest.dot(s.byFG), 0.0,
      s.byG.squaredNorm();
  h(1, 0) = h(0, 1);
  if (!(h.determinant() > 0.0) || !(h(0, 0) > 0.0)) {
    h << s.byF.squaredNorm(), s.byF.dot(s.byG), s.byF.dot(s.byG), s.byG.squaredNorm();
  }
  return -h.fullPivLu().solve(slope);
}
}  // namespace

Foot Ruled::foot(const Vec3& p, Hint& hint) const {
  Hint at = hint.valid ? hint : sheet_->seed(p);
  SheetPlace s = sheet_->at(at.f, at.g);
  for (int i = 0; i < newtonLimit; ++i) {
    const Eigen::Vector2d step = descent(s, p - s.place);
    if (!step.allFinite()) {
      break;
    }
    // A stride of at most a quarter of the strip keeps to the part of the sheet that is meant.
    const double stride = std::max(1.0, 4.0 * std::abs(step.x()));
    at.f += step.x() / stride;
    at.g += step.y() / stride;
    s = sheet_->at(at.f, at.g);
    if (step.cwiseAbs().maxCoeff() <= 1e-15) {
      break;
    }
  }
  at.valid = true;
  hint = at;
  const Vec3 across = s.byF.cross(s.byG);
  const double length = across.norm();
  const Vec3 normal = length > 0.0 ? Vec3(across / length) : Vec3(s.byG.unitOrthogonal());
  return {(p - s.place).dot(normal), normal};
}

double Ruled::bend(const Vec3&, const Foot& foot, const Vec3& t, Hint& hint) const {
  if (!hint.valid) {
    return 0.0;
  }
  const SheetPlace s = sheet_->at(hint.f, hint.g);
  // With first form I and second form L (towards the normal) the shape operator of the distance is
  // -I^-1 L, and that of the parallel surface at d is (I - d L)^-1 (-L), all in the basis byF, byG.
  Eigen::Matrix2d first, second;
  first << s.byF.squaredNorm(), s.byF.dot(s.byG), s.byF.dot(s.byG), s.byG.squaredNorm();
  second << foot.normal.dot(s.byFF), foot.normal.dot(s.byFG), foot.normal.dot(s.byFG), 0.0;
  const Eigen::Vector2d products(s.byF.dot(t), s.byG.dot(t));
  const Eigen::Vector2d components = first.fullPivLu().solve(products);
  const Eigen::Vector2d carried =
      (first - foot.distance * second).fullPivLu().solve(-second * components);
  return products.dot(carried);
}

Vec3 Ruled::ruling(const Vec3& p) const {
  Hint hint;
  (void)foot(p, hint);
  return sheet_->at(hint.f, hint.g).byG;
}

Bends Ruled::bends(const Vec3&, const Foot& foot, double radius) const {
  return bendsOfAnySet(foot.distance, radius);
}

}  // namespace arelem::surface
