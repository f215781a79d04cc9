#pragma once
#include <Eigen/Dense>

#include "ir/space/vector.h"

namespace arelem::scenes {

/// p -> scale * turn * p + shift, with an orthogonal `turn`; a determinant of -1 mirrors.
struct Similarity {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();
  double scale = 1.0;

  [[nodiscard]] Vec3 direction(const Vec3& v) const { return turn * v; }
  [[nodiscard]] Vec3 point(const Vec3& p) const { return scale * (turn * p) + shift; }
  [[nodiscard]] double length(double x) const { return scale * x; }
  [[nodiscard]] bool mirrors() const { return turn.determinant() < 0.0; }
  /// Where a moved place came from.
  [[nodiscard]] Vec3 before(const Vec3& p) const { return turn.transpose() * (p - shift) / scale; }
};

}  // namespace arelem::scenes
