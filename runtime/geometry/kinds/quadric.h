#pragma once
#include <optional>

#include <Eigen/Core>

#include "runtime/geometry/surface.h"

namespace arelem::surface {

/// F(p) = p.Q p + 2 q.p + c = 0, positive where F is.
///
/// The foot of p is q = (I + 2 m Q)^-1 (p - 2 m q) with F = 0; it is the nearest point of all if
/// I + 2 m Q has no negative eigenvalue, as the Lagrange function is then convex. Newton from the
/// hint keeps to the m in which that holds; where it leads near their end, F is solved by the
/// eigenvalue that vanishes there.
class Quadric {
 public:
  struct Hint {
    bool valid = false;
    /// The last foot, the unit normal there and half the length of the gradient, in the basis of
    /// the axes.
    Vec3 foot = Vec3::Zero(), normal = Vec3::Zero();
    double half = 0.0;
  };

  Quadric(const Eigen::Matrix3d& matrix, const Vec3& linear, double constant);

  [[nodiscard]] double value(const Vec3& p) const {
    return p.dot(matrix_ * p) + 2.0 * linear_.dot(p) + constant_;
  }
  [[nodiscard]] Vec3 gradient(const Vec3& p) const { return 2.0 * (matrix_ * p + linear_); }
  [[nodiscard]] Foot foot(const Vec3& p, Hint& hint) const;
  [[nodiscard]] Vec3 turn(const Vec3& p, const Foot& foot, const Vec3& t, Hint& hint) const;
  [[nodiscard]] double bend(const Vec3& p, const Foot& foot, const Vec3& t, Hint& hint) const {
    return t.dot(turn(p, foot, t, hint));
  }
  [[nodiscard]] Bends bends(const Vec3& p, const Foot& foot, double radius) const;
  /// The direction along which the surface is a cylinder, or zero.
  [[nodiscard]] const Vec3& generatrix() const { return wall_; }
  /// True where F <= 0 is a convex solid.
  [[nodiscard]] bool isConvex() const { return roots_[0] >= -flat_; }

 private:
  [[nodiscard]] std::optional<Bends> curvatures(const Vec3& at, double reach) const;

  Eigen::Matrix3d matrix_;
  Vec3 linear_;
  double constant_;
  Eigen::Matrix3d axes_;  ///< columns: eigenvectors of Q
  Vec3 roots_;            ///< eigenvalues of Q, ascending
  Vec3 alongAxes_;        ///< q in the basis of the axes
  double flat_ = 0.0;     ///< an eigenvalue of at most this is 0
  Vec3 wall_ = Vec3::Zero();
};

}  // namespace arelem::surface
