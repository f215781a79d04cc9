#include "backend/g97/pose.h"

#include <cmath>
#include <numbers>

#include "ir/diag/robot.h"
#include "ir/space/spray_tolerance.h"

namespace arelem::g97 {

namespace {
using robot::Matrix3;
using robot::Pose;

constexpr double radian = std::numbers::pi / 180.0;
constexpr double farthest = 9999.994;  // rounds to 9999.99

Matrix3 about(const Vec3& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * radian, axis).toRotationMatrix();
}

double degrees(double y, double x) {
  return std::atan2(y, x) / radian;
}

double rounded(double value) {
  const double hundredths = std::round(value * 100.0) / 100.0;
  return hundredths == 0.0 ? 0.0 : hundredths;  // not -0
}

/// In (-180, 180] after rounding.
double roundedTurn(double value) {
  const double turn = rounded(std::remainder(value, 360.0));
  return turn <= -180.0 ? turn + 360.0 : turn;
}

Angles anglesOfFrame(bool fixedAxes, const Matrix3& m) {
  if (fixedAxes) {
    const double level = std::hypot(m(0, 0), m(1, 0));
    const double q = degrees(-m(2, 0), level);
    return level < tolerance::uprightAxis
               ? Angles{degrees(-m(1, 2), m(1, 1)), q, 0.0}
               : Angles{degrees(m(2, 1), m(2, 2)), q, degrees(m(1, 0), m(0, 0))};
  }
  const double level = std::hypot(m(0, 0), m(0, 1));
  const double q = degrees(m(0, 2), level);
  return level < tolerance::uprightAxis
             ? Angles{degrees(m(2, 1), m(1, 1)), q, 0.0}
             : Angles{degrees(-m(1, 2), m(2, 2)), q, degrees(-m(0, 1), m(0, 0))};
}

Angles anglesOfAxis(const robot::G97Style& style, const Vec3& n) {
  if (style.fixedAxes) {
    const double q =
        std::hypot(n.x(), n.z()) < tolerance::uprightAxis ? 0.0 : degrees(n.x(), n.z());
    const double p = degrees(-n.y(), std::hypot(n.x(), n.z()));
    // The same direction with Q on this side of 90 degrees.
    return std::abs(q) <= 90.0 ? Angles{p, q, 0.0}
                               : Angles{p + 180.0, std::remainder(180.0 - q, 360.0), 180.0};
  }
  const double level = std::hypot(n.y(), n.z());
  Angles angles{level < tolerance::uprightAxis ? 0.0 : degrees(-n.y(), n.z()),
                degrees(n.x(), level), 0.0};
  if (style.uprightRoll && std::hypot(n.x(), n.y()) >= tolerance::uprightAxis) {
    angles.r = degrees(-std::sin(angles.p * radian),
                       std::cos(angles.p * radian) * std::sin(angles.q * radian));
  }
  return angles;
}
}  // namespace

Matrix3 matrixOf(const robot::G97Style& style, const Angles& a) {
  const Matrix3 p = about(Vec3::UnitX(), a.p);
  const Matrix3 q = about(Vec3::UnitY(), a.q);
  const Matrix3 r = about(Vec3::UnitZ(), a.r);
  return style.fixedAxes ? Matrix3(r * q * p) : Matrix3(p * q * r);
}

Angles anglesOf(const robot::G97Style& style, const Pose& pose) {
  const Vec3 z = pose.axis.normalized();
  if (!pose.side) {
    return anglesOfAxis(style, z);
  }
  const Vec3 x = (*pose.side - pose.side->dot(z) * z).normalized();
  Matrix3 frame;
  frame << x, z.cross(x), z;
  return anglesOfFrame(style.fixedAxes, frame);
}

Angles robopaintAngles(const Vec3& axis) {
  const bool alongX = std::hypot(axis.y(), axis.z()) < tolerance::uprightAxis;
  return {alongX ? 0.0 : degrees(-axis.y(), axis.z()), degrees(axis.x(), std::abs(axis.z())), 0.0};
}

Result<BlockPose> blockOf(const robot::Machine& machine,
                          const Pose& given,
                          std::string_view place) {
  const robot::G97Style& style = machine.g97;
  const Pose pose = style.inBase ? robot::inBase(machine.frame, given) : given;
  const Angles angles =
      style.robopaint ? robopaintAngles(pose.axis.normalized()) : anglesOf(style, pose);
  const Vec3 point = pose.point - matrixOf(style, angles) * style.tool;
  BlockPose block;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (!(std::abs(point[i]) <= farthest)) {
      return fail(diag::G97Place, place, point[i]);
    }
    block.point[i] = rounded(point[i]);
  }
  block.angles = {roundedTurn(angles.p), rounded(angles.q), roundedTurn(angles.r)};
  return block;
}

Pose poseOf(const robot::Machine& machine, const BlockPose& block) {
  const Matrix3 frame = matrixOf(machine.g97, block.angles);
  Pose pose = {block.point + frame * machine.g97.tool, frame.col(2), Vec3(frame.col(0))};
  if (machine.g97.inBase) {
    const auto& [yaw, pitch, roll] = machine.frame.angles;
    const Matrix3 back = robot::matrixOf({yaw, pitch, roll}).transpose();
    pose = {back * (pose.point - machine.frame.shift), back * pose.axis, Vec3(back * *pose.side)};
  }
  return pose;
}

}  // namespace arelem::g97
