#pragma once
#include <optional>
#include <string>

#include "ir/space/vector.h"

namespace arelem::motion {

/// The angles of TLAXIS/ATANGL, in radians.
struct Tilt {
  double alpha = 0.0;          ///< from the normal of the controlling surface
  std::optional<double> lead;  ///< CUTANG: towards the motion (+) or away from it (-)
  std::optional<Vec3> across;  ///< four axes: the tool axis stays square to this unit vector
  double turn = 0.0;           ///< four axes: the sense about that, from the normal; 0: by alpha
  Vec3 turnedFrom = Vec3::Zero();  ///< the normal from which `turn` is told; for those that point
                                   ///< the other way it is the other sense
};

/// The tool axis at the angles (spec 4.10). `normal` and `other` are the unit normals of the
/// controlling and of the other surface, `forward` the unit direction of the motion. A positive
/// alpha tilts the axis from `normal` towards `other`; with four axes towards the motion where the
/// plane of the axis holds the motion rather than the other normal, unless the sense is given. None
/// where no axis has these angles.
[[nodiscard]] std::optional<Vec3> tilted(const Tilt& tilt,
                                         const Vec3& normal,
                                         const Vec3& other,
                                         const Vec3& forward);

/// What of a vector lies in the plane square to the unit vector `across`.
[[nodiscard]] inline Vec3 withinPlane(const Vec3& across, const Vec3& v) {
  return v - v.dot(across) * across;
}

/// The sense in which a tool axis square to `across` is turned from the normal about that: 1 or -1,
/// 0 where it is not turned.
[[nodiscard]] double turnAbout(const Vec3& across, const Vec3& normal, const Vec3& axis);

/// What is in the way where `tilted` finds none, with the angles.
[[nodiscard]] std::string whyNotTilted(const Tilt& tilt, const Vec3& normal, const Vec3& other);

}  // namespace arelem::motion
