#pragma once
#include <span>
#include <vector>

#include <Eigen/Core>

#include "ir/cl/record.h"
#include "ir/space/vector.h"

namespace arelem::path {

/// p' = linear p + shift, made from the twelve numbers of a MATRIX (rows a b c t).
struct Affine {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();

  [[nodiscard]] static Affine fromRows(std::span<const double> rows);
  [[nodiscard]] static Affine translation(const Vec3& by);
  /// Rotation about the Z axis, X towards Y.
  [[nodiscard]] static Affine rotation(double degrees);
  [[nodiscard]] Affine after(const Affine& first) const {
    return {linear * first.linear, linear * first.shift + shift};
  }
  [[nodiscard]] Vec3 point(const Vec3& p) const { return linear * p + shift; }
  /// A direction of unit length (the axis of a tool or a cylinder).
  [[nodiscard]] Vec3 direction(const Vec3& v) const;
};

/// Moves what a record says about places: locations with their axes, the control points of a path
/// spline, and the circle of a 3000 record, whose radius grows by the cube root of the determinant.
/// All else stays.
void move(cl::Record& record, const Affine& by);

}  // namespace arelem::path
