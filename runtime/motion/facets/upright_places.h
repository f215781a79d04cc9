#pragma once
#include <vector>

#include "runtime/geometry/normal_cones.h"
#include "runtime/motion/facets/upright_frame.h"

namespace arelem::motion {

/// Which triangles an upright cutter that comes down on a mesh can touch first, by the normals that
/// the mesh has there: with one normal it touches with one place of its own, and so stands in one
/// place beside what it touches.
class UprightPlaces {
 public:
  struct Found {
    tool::UprightFacet facet;
    UprightBounds::Range range;  ///< nowhere else is it touched first
    std::uint32_t number = 0;
  };

  explicit UprightPlaces(const UprightFrame& frame) : frame_(frame) {}

  /// All that may be touched first between two places of the way, by where they begin to be; false
  /// where there are more than `limit`.
  bool find(double from, double to, std::size_t limit, std::vector<Found>& found) const;

 private:
  class Search;
  /// Where the tool end stands seen from what it touches with normals in a cone: a rectangle.
  struct Foot {
    double x = 0.0, y = 0.0, halfX = 0.0, halfY = 0.0;
  };
  [[nodiscard]] Foot footOf(const geometry::NormalCones::Cone& cone) const;

  const UprightFrame& frame_;
};

}  // namespace arelem::motion
