#pragma once
#include "runtime/geometry/kinds/mesh.h"
#include "runtime/motion/facets/section.h"
#include "runtime/tool/profile.h"

namespace arelem::motion {

/// A tool end that moves in a section along a mesh: a convex cutter with a fixed axis.
struct FacetTask {
  const surface::Mesh* mesh = nullptr;
  const tool::Profile* cutter = nullptr;
  Vec3 axis = Vec3::UnitZ();
  Section section;
  double low = 0.0, high = 0.0;  ///< the gap may lie between
};

/// A piece of way in a section: straight, or a parabola.
struct Way {
  SectionPoint from, to;
  double slab = 0.0;  ///< how far above and below it one may go
  double bow = 0.0;   ///< half the second derivative of its height

  [[nodiscard]] double heightAt(double s) const {
    return heightOn(from, to, s) + bow * (s - from.s) * (s - to.s);
  }
  [[nodiscard]] double beside(const SectionPoint& p) const { return std::abs(p.z - heightAt(p.s)); }
};

/// The gap is at least base + byS s + byZ z.
struct Tangent {
  double base = 0.0, byS = 0.0, byZ = 0.0;

  [[nodiscard]] double at(const SectionPoint& p) const { return base + byS * p.s + byZ * p.z; }
};

}  // namespace arelem::motion
