#include "backend/robot/pose.h"

#include <cmath>
#include <numbers>

#include "ir/space/robot_tolerance.h"

namespace arelem::robot {

namespace {
constexpr double radian = std::numbers::pi / 180.0;

Matrix3 about(const Vec3& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * radian, axis).toRotationMatrix();
}
double degrees(double y, double x) {
  const double angle = std::atan2(y, x) / radian;
  return angle == 0.0 ? 0.0 : angle;  // not -0
}
}  // namespace

std::vector<Pose> posesOf(const cl::Motion& motion, double millimeters) {
  const std::size_t stride = motion.stride();
  std::vector<Pose> poses;
  for (std::size_t i = 0; i + stride <= motion.coordinates.size(); i += stride) {
    const double* c = motion.coordinates.data() + i;
    Pose pose;
    pose.point = millimeters * Vec3(c[0], c[1], c[2]);
    if (motion.withAxis) {
      pose.axis = Vec3(c[3], c[4], c[5]);
    }
    if (motion.withSide) {
      pose.side = Vec3(c[6], c[7], c[8]);
    }
    poses.push_back(pose);
  }
  return poses;
}

Matrix3 matrixOf(const Euler& e) {
  return about(Vec3::UnitZ(), e.yaw) * about(Vec3::UnitY(), e.pitch) * about(Vec3::UnitZ(), e.roll);
}

Euler eulerOf(const Matrix3& r) {
  const double s = std::hypot(r(0, 2), r(1, 2));
  if (s < tolerance::singularPitch) {
    const bool up = r(2, 2) > 0.0;
    return {0.0, up ? 0.0 : 180.0, degrees(r(1, 0), up ? r(0, 0) : -r(0, 0))};
  }
  return {degrees(r(1, 2), r(0, 2)), std::atan2(s, r(2, 2)) / radian, degrees(r(2, 1), -r(2, 0))};
}

Matrix3 toolFrame(const Pose& pose) {
  const Vec3 z = -pose.axis.normalized();
  if (!pose.side) {
    const double lean = std::hypot(z.x(), z.y());
    return matrixOf({lean < tolerance::singularPitch ? 0.0 : degrees(z.y(), z.x()),
                     std::atan2(lean, z.z()) / radian, 0.0});
  }
  const Vec3 x = (*pose.side - pose.side->dot(z) * z).normalized();
  Matrix3 frame;
  frame << x, z.cross(x), z;
  return frame;
}

Pose poseOf(const Vec3& point, const Matrix3& frame) {
  return {point, -frame.col(2), Vec3(frame.col(0))};
}

std::optional<Upright> uprightOf(const Pose& pose) {
  const Vec3 axis = pose.axis.normalized();
  if (!pose.side) {
    return std::hypot(axis.x(), axis.y()) < tolerance::singularPitch && axis.z() > 0.0
               ? std::optional<Upright>({0.0, 0.0})
               : std::nullopt;
  }
  const Vec3 side = pose.side->normalized();
  const double across = axis.cross(side).z();  // the third axis must be level
  if (axis.z() <= 0.0 || std::abs(across) > tolerance::sideOfTilt) {
    return std::nullopt;
  }
  const double level = std::hypot(side.x(), side.y());
  if (level < tolerance::singularPitch) {
    return std::nullopt;
  }
  return Upright{degrees(-side.z(), level), degrees(side.y(), side.x())};
}

Pose inBase(const Frame& frame, const Pose& pose) {
  const Matrix3 turn = matrixOf({frame.angles[0], frame.angles[1], frame.angles[2]});
  Pose moved{turn * pose.point + frame.shift, turn * pose.axis, std::nullopt};
  if (pose.side) {
    moved.side = turn * *pose.side;
  }
  return moved;
}

}  // namespace arelem::robot
