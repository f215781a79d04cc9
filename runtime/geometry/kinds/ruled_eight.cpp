#include <cmath>
#include <limits>

#include "runtime/geometry/kinds/ruled_sheet.h"

/// Distances from strips of a ruled surface, eight by eight: most of what its feet cost.
namespace arelem::surface {

void Ruled::Sheet::Eight::set(std::size_t i, const Strip& strip) {
  for (int k = 0; k < 3; ++k) {
    from[static_cast<std::size_t>(k)][i] = strip.from[k];
    along[static_cast<std::size_t>(k)][i] = strip.along[k];
  }
  first[i] = strip.first;
  second[i] = strip.second;
  twist[i] = strip.twist;
  perSquared[i] = strip.perSquared;
  kept[i] = strip.kept;
  low[i] = strip.proper.low;
  high[i] = strip.proper.high;
}

void Ruled::Sheet::Eight::properLinesTo(const Vec3& p, Numbers& g, Numbers& away) const {
  for (std::size_t i = 0; i < rowsOfABlock; ++i) {
    const double x = p.x() - from[0][i], y = p.y() - from[1][i], z = p.z() - from[2][i];
    double share = (x * along[0][i] + (y * along[1][i] + z * along[2][i])) * perSquared[i];
    share = share < low[i] ? low[i] : share;
    share = share > high[i] ? high[i] : share;
    const double dx = x - share * along[0][i], dy = y - share * along[1][i],
                 dz = z - share * along[2][i];
    g[i] = share;
    away[i] = std::sqrt(dx * dx + (dy * dy + dz * dz));
  }
}

void Ruled::Sheet::Eight::leastFrom(const Vec3& p, Numbers& least) const {
  for (std::size_t i = 0; i < rowsOfABlock; ++i) {
    const double x = p.x() - from[0][i], y = p.y() - from[1][i], z = p.z() - from[2][i];
    const double g = (x * along[0][i] + (y * along[1][i] + z * along[2][i])) * perSquared[i];
    const double dx = x - g * along[0][i], dy = y - g * along[1][i], dz = z - g * along[2][i];
    const double away = std::sqrt(dx * dx + (dy * dy + dz * dz));
    const double a = first[i] + std::abs(g) * twist[i];
    const double b = second[i] + std::abs(1.0 - g) * twist[i];
    const double bound = away * kept[i] - (a < b ? a : b);
    least[i] = kept[i] > 0.0 ? bound : -std::numeric_limits<double>::infinity();
  }
}

}  // namespace arelem::surface
