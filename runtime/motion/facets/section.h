#pragma once
#include "ir/space/vector.h"

namespace arelem::motion {

/// A place of the tool end in the plane in which it moves: along the way, and up from the facets.
struct SectionPoint {
  double s = 0.0;
  double z = 0.0;
};

/// The plane in which a tool end moves that keeps its gap to a plane, with a fixed axis.
struct Section {
  Vec3 origin = Vec3::Zero();
  Vec3 along = Vec3::UnitX(), up = Vec3::UnitZ();  ///< unit, square to each other

  [[nodiscard]] Vec3 at(const SectionPoint& p) const { return origin + p.s * along + p.z * up; }
  [[nodiscard]] SectionPoint pointOf(const Vec3& toolEnd) const {
    return {along.dot(toolEnd - origin), up.dot(toolEnd - origin)};
  }
};

/// Height at `s` of the straight line through two places.
[[nodiscard]] inline double heightOn(const SectionPoint& a, const SectionPoint& b, double s) {
  return a.z + (b.z - a.z) / (b.s - a.s) * (s - a.s);
}

}  // namespace arelem::motion
