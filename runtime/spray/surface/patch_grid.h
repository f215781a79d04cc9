#pragma once
#include "runtime/spray/surface/mesh_surface.h"
#include "runtime/spray/surface/surface_lines.h"

namespace arelem::spray {

/// A grid over the parameters of a patch, finer where the surface bends: along its lines the
/// surface lies within the chord tolerance of what is straight between neighboring nodes.
class PatchGrid {
 public:
  /// Error E0358: more nodes than `most`.
  [[nodiscard]] static Result<PatchGrid> of(const Patch& patch,
                                            double chord,
                                            std::uint64_t most = arelem::Limits{}.points);

  [[nodiscard]] std::size_t columns() const { return u_.size() - 1; }
  [[nodiscard]] std::size_t rows() const { return v_.size() - 1; }
  [[nodiscard]] Vec2 node(std::size_t column, std::size_t row) const {
    return {u_[column], v_[row]};
  }
  [[nodiscard]] const Vec3& place(std::size_t column, std::size_t row) const {
    return places_[column * v_.size() + row];
  }

 private:
  std::vector<double> u_, v_;
  std::vector<Vec3> places_;
};

/// The section of a patch by a plane, cut off by the planes of the patch. Its points follow each
/// other by the chord tolerance.
[[nodiscard]] std::vector<SurfaceLine> sectionOf(const Patch& patch,
                                                 const PatchGrid& grid,
                                                 const CuttingPlane& plane,
                                                 double chord);

}  // namespace arelem::spray
