#include "runtime/stencil/overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace arelem::stencil {

namespace {
double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Half of a cell, counter-clockwise.
struct Triangle {
  std::array<Vec2, 3> corner;
  Vec2 low, high;

  Triangle(const Vec2& a, const Vec2& b, const Vec2& c) : corner{a, b, c} {
    if (cross(b - a, c - a) < 0.0) {
      std::swap(corner[1], corner[2]);
    }
    low = a.cwiseMin(b).cwiseMin(c);
    high = a.cwiseMax(b).cwiseMax(c);
  }
};

/// What of a convex polygon lies to the left of the line from `a` to `b`.
std::vector<Vec2> leftOf(const std::vector<Vec2>& polygon, const Vec2& a, const Vec2& b) {
  std::vector<Vec2> left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& p = polygon[i];
    const Vec2& q = polygon[(i + 1) % polygon.size()];
    const double sideOfP = cross(b - a, p - a);
    const double sideOfQ = cross(b - a, q - a);
    if (sideOfP >= 0.0) {
      left.push_back(p);
    }
    if ((sideOfP > 0.0 && sideOfQ < 0.0) || (sideOfP < 0.0 && sideOfQ > 0.0)) {
      left.emplace_back(p + sideOfP / (sideOfP - sideOfQ) * (q - p));
    }
  }
  return left;
}

double commonArea(const Triangle& s, const Triangle& t) {
  std::vector<Vec2> common(s.corner.begin(), s.corner.end());
  for (std::size_t i = 0; i < 3 && !common.empty(); ++i) {
    common = leftOf(common, t.corner[i], t.corner[(i + 1) % 3]);
  }
  double twice = 0.0;
  for (std::size_t i = 2; i < common.size(); ++i) {
    twice += cross(common[i - 1] - common[0], common[i] - common[0]);
  }
  return 0.5 * twice;
}

std::vector<Triangle> trianglesOf(std::span<const Track> tracks) {
  std::vector<Triangle> triangles;
  for (const Track& track : tracks) {
    for (std::size_t i = track.first; i + 1 < track.poses.size(); ++i) {
      const Line& a = track.poses[i].line;
      const Line& b = track.poses[i + 1].line;
      triangles.emplace_back(a.first, a.second, b.second);
      triangles.emplace_back(a.first, b.second, b.first);
    }
  }
  return triangles;
}
}  // namespace

double overlapOf(std::span<const Track> tracks) {
  std::vector<Triangle> triangles = trianglesOf(tracks);
  std::sort(triangles.begin(), triangles.end(),
            [](const Triangle& a, const Triangle& b) { return a.low.x() < b.low.x(); });
  double area = 0.0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& s = triangles[i];
    for (std::size_t k = i + 1; k < triangles.size(); ++k) {
      const Triangle& t = triangles[k];
      if (t.low.x() >= s.high.x()) {
        break;
      }
      if (t.low.y() < s.high.y() && t.high.y() > s.low.y()) {
        area += commonArea(s, t);
      }
    }
  }
  return area;
}

}  // namespace arelem::stencil
