#include "runtime/motion/convex_inset.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ir/space/tolerance.h"

namespace arelem::motion {

namespace {
/// Halvings in the search for the depth: down to the rounding of a double.
constexpr int halvings = 60;

Vec2 leftOf(const Vec2& v) {
  return {-v.y(), v.x()};
}
}  // namespace

ConvexInset::ConvexInset(std::span<const Vec2> vertices) {
  double low = 0.0;
  double high = 0.0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2& next = vertices[(i + 1) % vertices.size()];
    const Vec2 normal = leftOf(next - vertices[i]).normalized();
    sides_.push_back({normal, normal.dot(vertices[i])});
    high = std::max(high, (next - vertices[i]).norm());
  }
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (at(middle) ? low : high) = middle;
  }
  depth_ = low;
}

/// Each side's line is cut by all other sides; what is left of it is a side of the smaller polygon.
std::optional<std::vector<Vec2>> ConvexInset::at(double distance) const {
  std::vector<Vec2> vertices;
  for (const Side& s : sides_) {
    const Vec2 along = -leftOf(s.normal);
    const Vec2 foot = (s.offset + distance) * s.normal;
    double from = -std::numeric_limits<double>::infinity();
    double to = -from;
    for (const Side& other : sides_) {
      const double rate = other.normal.dot(along);
      const double room = other.normal.dot(foot) - other.offset - distance;
      if (&other == &s) {
        continue;
      }
      if (std::abs(rate) <= tolerance::parallel) {
        to = room < 0.0 ? -std::numeric_limits<double>::infinity() : to;
      } else if (rate > 0.0) {
        from = std::max(from, -room / rate);
      } else {
        to = std::min(to, -room / rate);
      }
    }
    if (to - from > tolerance::sameSide) {
      vertices.emplace_back(foot + from * along);
    }
  }
  return vertices.size() >= 3 ? std::optional(std::move(vertices)) : std::nullopt;
}

double distanceTo(std::span<const Vec2> polygon, const Vec2& p) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = true;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2 side = polygon[(i + 1) % polygon.size()] - a;
    inside = inside && leftOf(side).dot(p - a) >= 0.0;
    const double share = std::clamp((p - a).dot(side) / side.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - share * side).norm());
  }
  return inside ? 0.0 : nearest;
}

}  // namespace arelem::motion
