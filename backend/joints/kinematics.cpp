#include "backend/joints/kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arelem::joints {

namespace {
constexpr double radian = std::numbers::pi / 180.0;
constexpr double turn = 360.0;
}  // namespace

Arm::Arm(const robot::Machine& machine) : pantograph_(machine.pantograph) {
  if (machine.elbow) {
    elbow_ = *machine.elbow;
  }
}

std::string_view Arm::jointName(std::size_t joint) const {
  return joint == 1 ? "turn" : isPantograph() ? "actuator" : "elbow";
}
std::string_view Arm::unit(std::size_t joint) const {
  return joint == 0 && isPantograph() ? "mm" : "deg";
}
robot::Range Arm::range(std::size_t joint) const {
  return isPantograph() ? (joint == 0 ? pantograph_->actuator : pantograph_->turn)
                        : (joint == 0 ? elbow_.elbow : elbow_.turn);
}
double Arm::mostSpeed(std::size_t joint) const {
  return (isPantograph() ? pantograph_->speed : elbow_.speed)[joint];
}
double Arm::mostAcceleration(std::size_t joint) const {
  return (isPantograph() ? pantograph_->acceleration : elbow_.acceleration)[joint];
}
double Arm::counts(std::size_t joint) const {
  if (!isPantograph()) {
    return elbow_.countsPerTurn / turn;
  }
  return joint == 0 ? pantograph_->countsPerMillimeter : pantograph_->countsPerTurn / turn;
}

robot::Range Arm::reach() const {
  if (isPantograph()) {
    return {pantograph_->ratio * pantograph_->actuator.low,
            pantograph_->ratio * pantograph_->actuator.high};
  }
  const auto radius = [&](double phi) {
    return std::max(0.0, 2.0 * elbow_.link * std::cos(phi * radian));
  };
  return {radius(elbow_.elbow.high), radius(elbow_.elbow.low)};
}

JointState Arm::jointsOf(const State& tool, double turnBefore) const {
  const double x = tool.place[0], y = tool.place[1];
  const double vx = tool.speed[0], vy = tool.speed[1];
  const double ax = tool.acceleration[0], ay = tool.acceleration[1];
  // Polar coordinates and their derivatives.
  const double radius = std::hypot(x, y);
  const double angle = std::atan2(y, x) / radian;
  const double outward = (x * vx + y * vy) / radius;
  const double about = (x * vy - y * vx) / (radius * radius);
  const double outwardRate = (vx * vx + vy * vy + x * ax + y * ay - outward * outward) / radius;
  const double aboutRate = (x * ay - y * ax) / (radius * radius) - 2.0 * outward * about / radius;
  JointState joints;
  joints.place[1] = angle + turn * std::round((turnBefore - angle) / turn);
  joints.speed[1] = about / radian;
  joints.acceleration[1] = aboutRate / radian;
  if (isPantograph()) {
    joints.place[0] = radius / pantograph_->ratio;
    joints.speed[0] = outward / pantograph_->ratio;
    joints.acceleration[0] = outwardRate / pantograph_->ratio;
    return joints;
  }
  const double whole = 2.0 * elbow_.link;
  const double root = std::sqrt(std::max(0.0, whole * whole - radius * radius));
  joints.place[0] = std::acos(std::min(1.0, radius / whole)) / radian;
  joints.speed[0] = -outward / root / radian;
  joints.acceleration[0] =
      (-outwardRate / root - radius * outward * outward / (root * root * root)) / radian;
  return joints;
}

Eigen::Vector2d Arm::placeOf(const JointState& joints) const {
  const double radius = isPantograph() ? pantograph_->ratio * joints.place[0]
                                       : 2.0 * elbow_.link * std::cos(joints.place[0] * radian);
  const double angle = joints.place[1] * radian;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace arelem::joints
