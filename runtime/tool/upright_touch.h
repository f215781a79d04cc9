#pragma once
#include <array>
#include <cmath>
#include <optional>

#include "runtime/tool/profile.h"

namespace arelem::tool {

/// The lower side of a cutter with level bottom and tangent corner arc, thickened by a gap
/// (negative: pared): level up to e, an arc around (e, f) of radius r, and a side that goes on for
/// ever.
struct UprightProfile {
  double e = 0.0, f = 0.0, r = 0.0;
  double sinBeta = 0.0, cosBeta = 1.0;
  double highest = 0.0;  ///< above this the cutter has ended

  /// None for cutters of another shape, and those that are pared to less than their axis.
  [[nodiscard]] static std::optional<UprightProfile> of(const Profile& cutter, double gap);
  /// The most of -n.p over its places p, for a unit normal n that is not steeper than the side.
  [[nodiscard]] double support(double nz, double nxy) const { return e * nxy + r - f * nz; }
};

/// A triangle in the frame of an upright cutter.
struct UprightFacet {
  std::array<Vec3, 3> corners;
  Vec3 up = Vec3::UnitZ();  ///< unit normal, z not negative
};

/// The height of the tool end at which a cutter that comes down touches, with the unit normal of
/// contact, from the triangle to the cutter.
struct Touch {
  double z = 0.0;
  Vec3 normal = Vec3::UnitZ();
  bool beyond = false;  ///< by the side above where the cutter ends
};

/// Touches of an upright cutter by its facet, edges and corners, each a closed form but for edges
/// against a corner arc that does not end in the axis: one root of a function that is concave and
/// rises. Literature: the drop cutter of Hwang (1992) and Chuang et al. (2002).
class UprightTouch {
 public:
  explicit UprightTouch(const UprightProfile& profile) : p_(profile) {}

  /// With the axis through (s, 0); none where it does not touch.
  [[nodiscard]] std::optional<Touch> of(const UprightFacet& facet, double s) const;
  /// How far above a place that is `beside` its axis a cutter touches it with its bottom or arc;
  /// none where it would with its side.
  [[nodiscard]] std::optional<double> over(double beside) const;
  [[nodiscard]] const UprightProfile& profile() const { return p_; }

 private:
  /// Sides of a triangle on which the contact with its plane lies, one bit for each edge; 0 where
  /// it is inside, all where there is none.
  struct PlaneTouch {
    unsigned outside = 7;
    Touch touch;
  };
  [[nodiscard]] PlaneTouch onPlane(const UprightFacet& facet, double s) const;
  [[nodiscard]] std::optional<Touch> onEdge(const Vec3& from, const Vec3& to, double s) const;
  [[nodiscard]] std::optional<Touch> onCorner(const Vec3& corner, double s) const;
  [[nodiscard]] double lean(double level, double beside) const;

  UprightProfile p_;
};

}  // namespace arelem::tool
