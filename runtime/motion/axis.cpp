#include "runtime/motion/axis.h"

namespace arelem::motion {

namespace {
/// Step of the differences, relative to the size of the coordinates: large against rounding, small
/// against radii of curvature.
constexpr double differenceStep = 1e-6;
}  // namespace

Eigen::Matrix3d AxisRule::change(const Vec3& toolEnd) {
  Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
  if (isFixed()) {
    return result;
  }
  const double step = differenceStep * (1.0 + toolEnd.cwiseAbs().maxCoeff());
  for (int i = 0; i < 3; ++i) {
    const Vec3 shift = step * Vec3::Unit(i);
    const Vec3 ahead = at(toolEnd + shift);
    const bool settled = settles();
    const Vec3 behind = at(toolEnd - shift);
    if (!settled || !settles()) {
      return Eigen::Matrix3d::Zero();
    }
    result.col(i) = (ahead - behind) / (2.0 * step);
  }
  return result;
}

}  // namespace arelem::motion
