#include "runtime/stencil/cell.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ir/space/tolerance.h"

namespace arelem::stencil {

namespace {
double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Paint up to the share s is s / below(s).
double below(double s, double steepness) {
  return s + steepness * (1.0 - s);
}

/// The film of strip k is steepness over this: paint m w / (below(low) below(high)) lies on the
/// area w (1 + lean (2 middle - 1)), w the width of a strip.
double underFilm(int k, double lean, double steepness) {
  constexpr double strip = 1.0 / stripsOfACell;
  const double low = strip * k;
  return below(low, steepness) * below(low + strip, steepness) *
         std::abs(1.0 + lean * (2.0 * low + strip - 1.0));
}
}  // namespace

double Spread::worst() const {
  return std::max(most - 1.0, 1.0 - least);
}

void Spread::add(const Spread& other) {
  least = std::min(least, other.least);
  most = std::max(most, other.most);
}

Balance balanceOf(const Line& from, const Line& to) {
  // Place at the shares s along the lines and t from one to the other: bilinear. Its Jacobian is
  // linear in s where it is taken over all t.
  const Vec2 along = 0.5 * (from.second - from.first + to.second - to.first);
  const double atFirst = cross(along, to.first - from.first);
  const double atSecond = cross(along, to.second - from.second);
  const double sum = atFirst + atSecond;
  const double size = std::abs(atFirst) + std::abs(atSecond);
  const bool thin = std::abs(sum) <= tolerance::rounding * size || size == 0.0;
  return {0.5 * std::abs(sum), thin ? 0.0 : (atSecond - atFirst) / sum};
}

double areaOf(const Line& from, const Line& to) {
  return balanceOf(from, to).area;
}

double steepnessOf(double tilt, double fan) {
  const double share = shareOf(tilt, fan);
  return share / (1.0 - share);
}

double paintUpTo(double s, double fan, double tilt) {
  return s / below(s, steepnessOf(tilt, fan));
}

double paintAt(double s, double steepness) {
  const double b = below(s, steepness);
  return steepness / (b * b);
}

std::array<double, stripsOfACell> filmOf(double lean, double steepness) {
  std::array<double, stripsOfACell> film{};
  for (int k = 0; k < stripsOfACell; ++k) {
    const double under = underFilm(k, lean, steepness);
    film[static_cast<std::size_t>(k)] = under > 0.0 ? steepness / under : 1.0;
  }
  return film;
}

Spread spreadOf(double lean, double steepness) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (int k = 0; k < stripsOfACell; ++k) {
    const double under = underFilm(k, lean, steepness);
    least = std::min(least, under);
    most = std::max(most, under);
  }
  return {most > 0.0 ? steepness / most : 1.0, least > 0.0 ? steepness / least : 1.0};
}

Spread spreadOf(const Line& from, const Line& to, double fan, double tilt) {
  return spreadOf(balanceOf(from, to).lean, steepnessOf(tilt, fan));
}

}  // namespace arelem::stencil
