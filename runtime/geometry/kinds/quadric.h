#pragma once
#include <Eigen/Core>

#include "runtime/geometry/surface.h"

namespace arelem::surface {

/// F(p) = p.Q p + 2 q.p + c = 0 with F scaled as given; positive where F is. The foot is found by
/// Newton on the Lagrange equations, from the hint where there is one.
struct Quadric {
  struct Hint {
    bool valid = false;
    Vec3 point = Vec3::Zero();  ///< the last foot
  };
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  Vec3 linear = Vec3::Zero();
  double constant = -1.0;

  [[nodiscard]] double value(const Vec3& p) const {
    return p.dot(matrix * p) + 2.0 * linear.dot(p) + constant;
  }
  [[nodiscard]] Vec3 gradient(const Vec3& p) const { return 2.0 * (matrix * p + linear); }
  [[nodiscard]] Foot foot(const Vec3& p, Hint& hint) const;
  [[nodiscard]] double bend(const Vec3& p, const Foot& foot, const Vec3& t, Hint& hint) const;
  [[nodiscard]] const Vec3& generatrix() const { return wall; }
  /// Finds the direction along which the surface is a cylinder, or zero.
  [[nodiscard]] Vec3 findGeneratrix() const;
  Vec3 wall = Vec3::Zero();  ///< findGeneratrix(), kept by surfaceOf for quick use
};

}  // namespace arelem::surface
