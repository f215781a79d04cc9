#pragma once
#include <span>
#include <vector>

#include "runtime/geometry/triangle_mesh.h"

namespace arelem::geometry {

/// With which normals something convex that stays on one side of a mesh can touch it at a vertex,
/// or at what lies around it.
///
/// What lies on one side of a plane through a vertex has the plane's normal among those that the
/// normals of the triangles around it span, where these surround the vertex and all look to one
/// side: else a direction would lie above all these triangles and below one of them.
struct NormalCone {
  Vec3 axis = Vec3::Zero();  ///< unit
  double radius = any;       ///< no normal of the triangles around is farther from the axis

  /// With this radius nothing is known: at borders, and where triangles look to both sides.
  static constexpr double any = 0.9;
  [[nodiscard]] bool isAny() const { return radius >= any; }
};

/// Of each vertex. `atBorder`: those that triangles do not surround.
[[nodiscard]] std::vector<NormalCone> normalCones(const TriangleMesh& mesh,
                                                  std::span<const Vec3> normals,
                                                  const std::vector<bool>& atBorder);

}  // namespace arelem::geometry
