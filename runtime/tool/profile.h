#pragma once
#include <algorithm>
#include <span>

#include "ir/diag/result.h"
#include "ir/space/vector.h"

namespace arelem::tool {

/// A point of the half-profile: distance from the axis and height above the tool end.
struct ProfilePoint {
  double rho = 0.0;
  double z = 0.0;
};

/// The cutter of CUTTER/d,r,e,f,alpha,beta,h: a convex body of revolution. From the tool end
/// upwards a bottom line (rising outwards at alpha from the horizontal), a corner arc and a side
/// line (widening at beta from the axis) up to height h; the top face does not cut.
struct Profile {
  double d = 0.0, r = 0.0, e = 0.0, f = 0.0;
  double alpha = 0.0, beta = 0.0;  ///< radians
  double h = 0.0;
  bool ring = false;  ///< CUTTER/OPTION: only the circle of radius e at height f
  double sinAlpha = 0.0, cosAlpha = 1.0, sinBeta = 0.0, cosBeta = 1.0;
  ProfilePoint bottomEnd;  ///< where the bottom line meets the arc
  ProfilePoint sideStart;  ///< where the arc meets the side line
  ProfilePoint sideEnd;    ///< upper end

  /// Largest distance from the axis.
  [[nodiscard]] double maxRadius() const {
    return std::max({bottomEnd.rho, sideStart.rho, sideEnd.rho});
  }
  [[nodiscard]] bool isBall() const { return e == 0.0 && alpha == 0.0; }
  [[nodiscard]] bool isPoint() const { return d == 0.0 && r == 0.0 && e == 0.0; }
};

/// Checks the ranges of the values as written (angles in degrees, lengths in the part unit), 1, 2
/// or 7 of them, and completes them. Where corner radius and center are zero the lines meet in a
/// sharp corner. Whether the parts join is for shapeFault to say.
[[nodiscard]] Result<Profile> makeProfile(std::span<const double> values);
/// Works out the sines and the ends of the lines from the seven values.
void completeProfile(Profile& profile);
/// The ring of CUTTER/OPTION,n,radius,height.
[[nodiscard]] Profile makeRing(double radius, double height);

/// max of -n.p over the profile turned about the axis: how far the cutter reaches against the unit
/// normal n, where nz is n's component along the axis.
[[nodiscard]] double reach(const Profile& profile, double nz);
/// Where on the profile that is; of several points the lowest.
[[nodiscard]] ProfilePoint reachPoint(const Profile& profile, double nz);
/// Least distance of a point (rho, z) to the body, negative inside, and the nearest profile point.
[[nodiscard]] double distanceTo(const Profile& profile, ProfilePoint c, ProfilePoint& nearest);
/// The same, but a point inside the body is no deeper in it than below its top: that does not cut,
/// but a way through it leads out.
[[nodiscard]] double distanceUnderTop(const Profile& profile,
                                      ProfilePoint c,
                                      ProfilePoint& nearest);
/// Greatest distance of a point (rho, z) to the body, and that profile point (on the far side of
/// the axis).
[[nodiscard]] double farthestFrom(const Profile& profile, ProfilePoint c, ProfilePoint& farthest);

}  // namespace arelem::tool
