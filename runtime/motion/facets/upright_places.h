#pragma once
#include <array>
#include <memory>
#include <vector>

#include "runtime/geometry/normal_cones.h"
#include "runtime/motion/facets/upright_frame.h"

namespace arelem::motion {

/// Which triangles an upright cutter that comes down on a mesh can touch first, by the normals that
/// the mesh has there: with one normal it touches with one place of its own, and so stands in one
/// place beside what it touches. For each triangle, and for each few neighbors, that is a rectangle
/// seen from above in which the axis must be, for all motions of a cutter with the same axis.
class UprightPlaces final : public surface::KeptWithMesh {
 public:
  struct Found {
    std::uint32_t triangle = 0;
    UprightBounds::Range range;  ///< of the way; nowhere else is the triangle touched first
  };

  /// Made once for each axis and each shape of cutter; `radius`: its greatest.
  static std::shared_ptr<const UprightPlaces> of(const surface::MeshShape& mesh,
                                                 const tool::UprightProfile& cutter,
                                                 double radius,
                                                 const Vec3& up);

  /// All that may be touched first between two places of a way in a section; false where there are
  /// more than `limit`.
  bool find(const Section& section,
            const UprightBounds::Range& way,
            std::size_t limit,
            std::vector<Found>& found) const;

 private:
  /// Seen from above.
  struct Place {
    double x = 0.0, y = 0.0;
  };
  struct Rectangle {
    Place low, high;

    void cover(const Rectangle& other);
  };
  /// The same in single precision, no smaller.
  struct Box {
    std::array<float, 2> low, high;
  };
  class Search;
  static constexpr std::size_t parts = 4;  ///< of a box

  UprightPlaces(const surface::MeshShape& mesh,
                const tool::UprightProfile& cutter,
                double radius,
                const Vec3& up);

  [[nodiscard]] Place placeOf(const Vec3& v) const { return {right_.dot(v), ahead_.dot(v)}; }
  [[nodiscard]] Rectangle footOf(const geometry::NormalCone& cone) const;
  [[nodiscard]] static Box outside(const Rectangle& rectangle);
  void addLevel();

  tool::UprightProfile cutter_;
  double radius_;
  Vec3 up_, right_, ahead_;
  Vec3 center_;  ///< about the middle of the mesh
  std::vector<std::uint32_t> order_;
  std::vector<std::vector<Box>> levels_;  ///< the first: of each triangle in this order
};

}  // namespace arelem::motion
