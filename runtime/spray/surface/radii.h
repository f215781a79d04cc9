#pragma once
#include <functional>
#include <optional>

#include "runtime/spray/surface/patch.h"

namespace arelem::spray {

/// Smallest radii of curvature of a patch two ways, and the smallest where the surface bends
/// towards the normal, either way, along u or along v; none where flat. mm.
struct Radii {
  std::optional<double> along, across, hollow;
};

/// Along u, and across these along v. Sampled over the patch.
[[nodiscard]] Radii smallestRadii(const Patch& patch);

/// The normal of the cutting plane through a place of the work; 0 where there is none.
using PlaneNormal = std::function<Vec3(const Vec3& place)>;
/// Along the sections by planes, and on the surface square to them. Where the surface leans less
/// than tolerance::leastLean against a plane no section runs, and only its hollow counts.
[[nodiscard]] Radii smallestRadii(const Patch& patch, const PlaneNormal& planes);

}  // namespace arelem::spray
