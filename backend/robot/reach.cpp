#include "backend/robot/reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "ir/diag/robot.h"
#include "ir/space/robot_tolerance.h"

namespace arelem::robot {

namespace {
constexpr double radian = std::numbers::pi / 180.0;

std::optional<Objection> outside(const Range& range,
                                 double value,
                                 int joint,
                                 std::string_view place) {
  if (value >= range.low - tolerance::jointLimit && value <= range.high + tolerance::jointLimit) {
    return std::nullopt;
  }
  const double excess = std::max(value - range.high, range.low - value);
  return Objection{fail(diag::JointRange, place, joint, value, range.low, range.high, excess),
                   excess};
}

/// Joints 1 and 2 of a place in the reach. A right arm has its elbow at the right of the way out:
/// from there joint 2 turns to the left.
ScaraJoints armAt(const Scara& s, const Vec3& point) {
  const double square = point.head<2>().squaredNorm();
  const double cosine =
      (square - s.link1 * s.link1 - s.link2 * s.link2) / (2.0 * s.link1 * s.link2);
  const double bend = (s.lefty ? -1.0 : 1.0) * std::acos(std::clamp(cosine, -1.0, 1.0));
  const double first = std::atan2(point.y(), point.x()) -
                       std::atan2(s.link2 * std::sin(bend), s.link1 + s.link2 * std::cos(bend));
  constexpr double turn = 360.0;
  ScaraJoints joints;
  joints.joint1 = std::remainder(first / radian, turn);
  joints.joint2 = bend / radian;
  joints.height = point.z();
  return joints;
}

/// The arm may have to pass a limit between two places that it can take.
std::optional<Objection> objectionOnTheWay(const Scara& s,
                                           const Vec3& from,
                                           const Vec3& to,
                                           std::string_view place) {
  constexpr double step = 10.0;  // mm
  constexpr double mostSteps = 1000.0;
  const int steps = static_cast<int>(std::min(mostSteps, std::ceil((to - from).norm() / step)));
  const std::string way = "the straight move to " + std::string(place);
  double before = armAt(s, from).joint1;
  for (int i = 1; i <= steps; ++i) {
    ScaraJoints joints = armAt(s, from + (to - from) * i / steps);
    // The joint goes on from where it is: behind +-180 degrees it does not begin anew.
    constexpr double turn = 360.0;
    joints.joint1 += turn * std::round((before - joints.joint1) / turn);
    before = joints.joint1;
    if (auto objection = outside(s.joint1, joints.joint1, 1, way)) {
      return objection;
    }
    if (auto objection = outside(s.joint2, joints.joint2, 2, way)) {
      return objection;
    }
  }
  return std::nullopt;
}
}  // namespace

Range reachOf(const Scara& s) {
  const double fold = std::min(std::max(std::abs(s.joint2.low), std::abs(s.joint2.high)), 180.0);
  const double inner =
      s.link1 * s.link1 + s.link2 * s.link2 + 2.0 * s.link1 * s.link2 * std::cos(fold * radian);
  return {std::sqrt(std::max(0.0, inner)), s.stretch * (s.link1 + s.link2)};
}

ScaraJoints jointsOf(const Scara& s, const Vec3& point, double heading, double joint4Before) {
  ScaraJoints joints = armAt(s, point);
  const double plain = heading - joints.joint1 - joints.joint2;
  constexpr double turn = 360.0;
  joints.joint4 = plain + turn * std::round((joint4Before - plain) / turn);
  return joints;
}

std::optional<Objection> objectionToPlace(const Scara& s,
                                          const Vec3& point,
                                          double heading,
                                          double joint4Before,
                                          std::string_view place) {
  const double radius = std::hypot(point.x(), point.y());
  const Range reach = reachOf(s);
  if (!reach.has(radius)) {
    const bool far = radius > reach.high;
    const double excess = far ? radius - reach.high : reach.low - radius;
    return Objection{fail(diag::OutOfReach, place, point.x(), point.y(), radius, excess,
                          far ? "outside" : "inside", far ? reach.high : reach.low),
                     excess};
  }
  if (!s.height.has(point.z())) {
    const bool high = point.z() > s.height.high;
    const double excess = high ? point.z() - s.height.high : s.height.low - point.z();
    return Objection{
        fail(diag::HeightRange, place, point.z(), excess,
             high ? "above the highest" : "below the lowest", s.height.low, s.height.high),
        excess};
  }
  const ScaraJoints joints = jointsOf(s, point, heading, joint4Before);
  for (const auto& [number, range, value] : {std::tuple{1, s.joint1, joints.joint1},
                                             {2, s.joint2, joints.joint2},
                                             {4, s.joint4, joints.joint4}}) {
    if (std::optional<Objection> objection = outside(range, value, number, place)) {
      return objection;
    }
  }
  return std::nullopt;
}

Vec3 pointOf(const Scara& s, const ScaraJoints& j) {
  const double a = j.joint1 * radian;
  const double b = a + j.joint2 * radian;
  return {s.link1 * std::cos(a) + s.link2 * std::cos(b),
          s.link1 * std::sin(a) + s.link2 * std::sin(b), j.height};
}

std::optional<Objection> objectionToLine(const Scara& s,
                                         const Vec3& from,
                                         const Vec3& to,
                                         std::string_view place) {
  const Eigen::Vector2d a = from.head<2>();
  const Eigen::Vector2d way = to.head<2>() - a;
  const double square = way.squaredNorm();
  const double t = square > 0.0 ? std::clamp(-a.dot(way) / square, 0.0, 1.0) : 0.0;
  const double nearest = (a + t * way).norm();
  const Range reach = reachOf(s);
  if (nearest >= reach.low - tolerance::jointLimit) {
    return objectionOnTheWay(s, from, to, place);
  }
  const double excess = reach.low - nearest;
  return Objection{fail(diag::LineThroughBase, place, nearest, reach.low, excess), excess};
}

}  // namespace arelem::robot
