#include "runtime/spray/outline.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "runtime/geometry/exact_polygon.h"

namespace arelem::spray {

double areaOf(const Outline& outline) {
  return geometry::signedArea(outline.loops);
}

Outline turned(const Outline& outline, double angle) {
  const Eigen::Rotation2Dd rotation(angle);
  Outline result = outline;
  for (Loop& loop : result.loops) {
    for (Vec2& p : loop) {
      p = rotation * p;
    }
  }
  return result;
}

Extent extentOf(const Outline& outline) {
  Extent extent;
  bool first = true;
  for (const Loop& loop : outline.loops) {
    for (const Vec2& p : loop) {
      extent.low = first ? p : extent.low.cwiseMin(p).eval();
      extent.high = first ? p : extent.high.cwiseMax(p).eval();
      first = false;
    }
  }
  return extent;
}

std::vector<double> hits(const Loop& loop, double height) {
  std::vector<double> places;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2& p = loop[i];
    const Vec2& q = loop[(i + 1) % loop.size()];
    if ((p.y() <= height) != (q.y() <= height)) {
      places.push_back(p.x() + (height - p.y()) * (q.x() - p.x()) / (q.y() - p.y()));
    }
  }
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace arelem::spray
