#pragma once
#include "runtime/geometry/triangle_tree.h"
#include "runtime/motion/facets/upright_bounds.h"

namespace arelem::motion {

/// Triangles and boxes of a mesh in the frame of a section in which a cutter stands upright: along
/// the way, across it, up.
class UprightFrame {
 public:
  using Cover = geometry::TriangleTree::Cover;
  /// A box in the frame of the section: its middle, half its lengths, and a plane that is at most
  /// `beyond` from the middle.
  struct Box {
    Vec3 middle, half, plane;
    double beyond = 0.0;
    double out = 0.0;  ///< from the axis to where the cutter touches the plane, by how it leans
  };

  UprightFrame(const FacetTask& task, const tool::UprightProfile& profile);

  [[nodiscard]] const UprightBounds& bounds() const { return bounds_; }
  [[nodiscard]] const surface::MeshShape& mesh() const { return task_.mesh->shape(); }
  [[nodiscard]] Box boxOf(const Vec3& center, const Vec3& half, const Cover& cover) const;
  [[nodiscard]] bool meets(const Box& box, UprightBounds::Doubt& doubt) const;
  [[nodiscard]] UprightBounds::Line lineOf(const Box& box, double s) const;
  [[nodiscard]] tool::UprightFacet facetOf(std::size_t i) const;
  [[nodiscard]] const Section& section() const { return task_.section; }

 private:
  [[nodiscard]] Vec3 local(const Vec3& place) const;
  [[nodiscard]] Vec3 turned(const Vec3& direction) const;
  [[nodiscard]] UprightBounds::Normal normalFor(const Box& box, double s) const;

  const FacetTask task_;
  UprightBounds bounds_;
  Vec3 across_, share_;  ///< how far boxes reach along it
  bool upright_;         ///< up is z
};

}  // namespace arelem::motion
