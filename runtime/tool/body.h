#pragma once
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/tool/rounded.h"

namespace arelem::tool {

/// The signed distance of places to the body of a cutter, with its gradient, where it is asked for
/// again and again. The body of a convex cutter with straight sides ends at its top face, which
/// makes the distance a convex function; sides that widen are open there. Cutters with a level
/// bottom and tangent corner arc, which is nearly all, are measured by which of bottom, arc and
/// side is nearest; the others by `distanceTo`.
class Body {
 public:
  struct Away {
    double distance = 0.0;          ///< negative inside
    double byRho = 0.0, byZ = 0.0;  ///< its gradient, of length 1
    double onRho = 0.0, onZ = 0.0;  ///< the nearest place of the profile
  };

  explicit Body(const Profile& cutter)
      : cutter_(cutter),
        convex_(tool::isConvex(cutter)),
        plain_(isRounded(cutter) && cutter.alpha == 0.0 && cutter.beta >= 0.0),
        sideLength_(std::hypot(cutter.sideEnd.rho - cutter.sideStart.rho,
                               cutter.sideEnd.z - cutter.sideStart.z)) {}

  [[nodiscard]] bool isConvex() const { return convex_; }
  /// Level bottom, tangent arc, sides that do not narrow upwards.
  [[nodiscard]] bool isPlain() const { return plain_; }
  [[nodiscard]] const Profile& cutter() const { return cutter_; }
  [[nodiscard]] Away away(double rho, double z) const;

 private:
  [[nodiscard]] Away byProfile(double rho, double z) const;
  [[nodiscard]] double distance(ProfilePoint place, ProfilePoint& nearest) const;
  /// Of a place to which the top is the nearest.
  [[nodiscard]] Away toTop(double rho, double z) const {
    return {z - cutter_.h, 0.0, 1.0, rho, cutter_.h};
  }

  const Profile& cutter_;
  bool convex_, plain_;
  double sideLength_;
};

inline Body::Away Body::away(double rho, double z) const {
  const Profile& p = cutter_;
  const double dx = rho - p.e;
  const double dz = z - p.f;
  const double along = dx * p.sinBeta + dz * p.cosBeta;  // the side, from its start
  if (!plain_ || along > sideLength_) {
    return byProfile(rho, z);
  }
  const double beside = dx * p.cosBeta - dz * p.sinBeta - p.r;
  if (dx <= 0.0 && (along < 0.0 || -z >= beside)) {
    return z - p.h > -z ? toTop(rho, z) : Away{-z, 0.0, -1.0, rho, 0.0};
  }
  if (along >= 0.0) {
    return z - p.h > beside ? toTop(rho, z)
                            : Away{beside, p.cosBeta, -p.sinBeta, rho - beside * p.cosBeta,
                                   z + beside * p.sinBeta};
  }
  const double length = std::sqrt(dx * dx + dz * dz);
  if (z - p.h > length - p.r) {
    return toTop(rho, z);
  }
  const double byRho = dx / length;
  const double byZ = dz / length;
  return {length - p.r, byRho, byZ, p.e + p.r * byRho, p.f + p.r * byZ};
}

}  // namespace arelem::tool
