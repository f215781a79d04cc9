#pragma once
#include <optional>
#include <vector>

#include "runtime/geometry/kinds/mesh.h"
#include "runtime/tool/mesh_contact.h"

namespace arelem::tool {

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
  /// The lesser of `aim` and what no gap is below while the tool end goes straight from one place
  /// to the other.
  [[nodiscard]] double lowest(const surface::MeshShape& shape,
                              const Profile& cutter,
                              const Vec3& from,
                              const Vec3& to,
                              const Vec3& axis,
                              double aim);

 private:
  /// The gap with the tool end at te is at least base + slope.te.
  struct Candidate {
    double base = 0.0;
    Vec3 slope = Vec3::Zero();
    std::uint32_t triangle = 0;

    [[nodiscard]] double below(const Vec3& te) const { return base + slope.dot(te); }
    void raise(const TriangleGap& gap, const Vec3& te) {
      base = gap.low - gap.slope.dot(te);
      slope = gap.slope;
    }
  };
  class Collect;

  void takeCutter(const surface::MeshShape& shape, const Profile& cutter);
  /// Distance of a tool end to the piece of way.
  [[nodiscard]] double toWay(const Vec3& te) const;
  /// How much a gap may have changed by the turn of the axis.
  [[nodiscard]] double turnedBy(const Vec3& axis) const;
  /// No triangle outside the list is nearer than this.
  [[nodiscard]] double beyond(const Vec3& te, const Vec3& axis) const;
  [[nodiscard]] TriangleGap scan(const PlacedBody& body, std::size_t& triangle);
  [[nodiscard]] bool collect(
      const Vec3& from, const Vec3& to, const Vec3& axis, double ceiling, std::size_t limit);
  [[nodiscard]] bool collectAround(const Vec3& te, const Vec3& axis, double gap);
  [[nodiscard]] double lowestOf(Candidate& c, const PlacedBody& a, const PlacedBody& b, double aim);

  const surface::MeshShape* shape_ = nullptr;
  std::optional<Body> body_;
  double arm_ = 0.0;  ///< from the tool end to the farthest place of the cutter
  std::vector<Candidate> near_;
  bool valid_ = false;
  Vec3 from_ = Vec3::Zero(), to_ = Vec3::Zero(), axis_ = Vec3::UnitZ();
  double ceiling_ = 0.0;
  double ahead_ = 0.0;  ///< length of the piece of way that is looked at next
};

}  // namespace arelem::tool
