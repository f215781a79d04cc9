#pragma once
#include <memory>

#include "runtime/geometry/kinds/mesh.h"
#include "runtime/tool/triangle_gap.h"

namespace arelem::tool {

/// A part of a cut vector: the tool end goes straight, the axis turns evenly.
struct Passage {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< of the tool end
  Vec3 axisFrom = Vec3::UnitZ(), axisTo = Vec3::UnitZ();
  double turn = 0.0;  ///< between the axes. Radians
};

/// The triangles of a mesh that a convex cutter may touch along a piece of its way, found once for
/// many positions.
///
/// The gap to each triangle is a convex function of the tool end (with a fixed axis), so each
/// measured one bounds it from below everywhere by its tangent. Most triangles are excluded by
/// such tangents, which cost next to nothing. What the piece of way leaves out is farther off than
/// `ceiling_` all along it, and elsewhere by no less than the distance from it: whether the nearest
/// triangle of the list is the nearest of all shows in its own gap. One belongs to one mesh and one
/// cutter, which must stay where they are.
class NearTriangles {
 public:
  /// The least gap of all triangles. `triangle` is one that is likely to be near, and becomes the
  /// nearest.
  [[nodiscard]] TriangleGap least(const surface::MeshShape& shape,
                                  const Profile& cutter,
                                  const Vec3& te,
                                  const Vec3& axis,
                                  std::size_t& triangle);
  /// The lesser of `aim` and what no gap is below all the way.
  [[nodiscard]] double lowest(const surface::MeshShape& shape,
                              const Profile& cutter,
                              const Passage& way,
                              double aim);

 private:
  class List;
  std::shared_ptr<List> list_;
};

}  // namespace arelem::tool
