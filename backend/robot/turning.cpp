#include "backend/robot/turning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "ir/diag/ngc.h"
#include "ir/space/tolerance.h"

namespace arelem::robot {

namespace {

constexpr double degrees = 180.0 / std::numbers::pi;
constexpr double wholeTurn = 360.0;

Eigen::Matrix3d rotation(const TurningAxis& axis, double angle) {
  return Eigen::AngleAxisd(angle / degrees, axis.direction).toRotationMatrix();
}
Vec3 about(const TurningAxis& axis, double angle, const Vec3& place) {
  return rotation(axis, angle) * (place - axis.point) + axis.point;
}

/// The angle that turns a to b about a unit axis; none matters where both lie on it.
std::optional<double> angleBetween(const Vec3& axis, const Vec3& a, const Vec3& b) {
  const Vec3 from = a - axis.dot(a) * axis;
  const Vec3 to = b - axis.dot(b) * axis;
  if (from.norm() <= tolerance::nullDirection || to.norm() <= tolerance::nullDirection) {
    return std::nullopt;
  }
  return std::atan2(axis.dot(from.cross(to)), from.dot(to)) * degrees;
}

/// All angles that bring p to q: first about v by the second of them, then about u by the first.
std::vector<Angles> twoTurns(
    const Vec3& u, const Vec3& v, const Vec3& p, const Vec3& q, const Angles& before) {
  const double c = u.dot(v);
  const double square = 1.0 - c * c;
  const double a = (u.dot(q) - c * v.dot(p)) / square;
  const double b = (v.dot(p) - c * u.dot(q)) / square;
  const double rest = (1.0 - a * a - b * b - 2.0 * a * b * c) / square;
  if (rest < -tolerance::nullDirection) {
    return {};
  }
  const double side = std::sqrt(std::max(rest, 0.0));
  std::vector<Angles> all;
  for (const double g : {side, -side}) {
    const Vec3 between = (a * u + b * v + g * u.cross(v)).normalized();
    all.push_back({angleBetween(u, between, q).value_or(before[0]),
                   angleBetween(v, p, between).value_or(before[1])});
    if (side == 0.0) {
      break;
    }
  }
  return all;
}

/// The angle of whole turns more or less that is in the range, and next to `before`.
std::optional<double> inRange(const TurningAxis& axis, double angle, double before) {
  double turned = angle + wholeTurn * std::round((before - angle) / wholeTurn);
  while (turned > axis.high + tolerance::nullDirection) {
    turned -= wholeTurn;
  }
  while (turned < axis.low - tolerance::nullDirection) {
    turned += wholeTurn;
  }
  const bool inside = turned <= axis.high + tolerance::nullDirection;
  return inside ? std::optional(std::clamp(turned, axis.low, axis.high)) : std::nullopt;
}

double way(const Angles& a, const Angles& b) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]);
}

}  // namespace

std::vector<Angles> anglesFor(const Turning& turning, const Vec3& toolAxis, const Angles& before) {
  const Vec3& first = turning.axes[0].direction;
  const Vec3& second = turning.axes[1].direction;
  const Vec3 up = Vec3::UnitZ();
  switch (turning.kind) {
    case Turning::Kind::tableTable:  // first second axis = z
      return twoTurns(first, second, toolAxis, up, before);
    case Turning::Kind::headHead:  // first second z = axis
      return twoTurns(first, second, up, toolAxis, before);
    case Turning::Kind::headTable: {  // table axis = head z
      std::vector<Angles> all = twoTurns(first, second, toolAxis, up, {-before[0], before[1]});
      for (Angles& one : all) {
        one[0] = -one[0];
      }
      return all;
    }
  }
  return {};
}

Result<Angles> nextAngles(const Turning& turning, const Vec3& toolAxis, const Angles& before) {
  const std::vector<Angles> all = anglesFor(turning, toolAxis, before);
  if (all.empty()) {
    return fail(diag::TurningReach, toolAxis.x(), toolAxis.y(), toolAxis.z(),
                turning.axes[0].letter, turning.axes[1].letter);
  }
  std::optional<Angles> best;
  std::optional<Failure> outside;
  for (const Angles& one : all) {
    Angles inside{};
    bool good = true;
    for (std::size_t i = 0; i < 2; ++i) {
      const TurningAxis& axis = turning.axes[i];
      const std::optional<double> angle = inRange(axis, one[i], before[i]);
      good = good && angle;
      inside[i] = angle.value_or(0.0);
      if (!angle && !outside) {
        outside = fail(diag::TurningRange, toolAxis.x(), toolAxis.y(), toolAxis.z(), axis.letter,
                       one[i], axis.low, axis.high);
      }
    }
    if (good && (!best || way(inside, before) < way(*best, before))) {
      best = inside;
    }
  }
  return best ? Result<Angles>(*best) : Result<Angles>(*std::move(outside));
}

Vec3 linearAxes(const Turning& turning, const Vec3& toolEnd, const Angles& angles) {
  const auto& [first, second] = turning.axes;
  const Vec3 end = Vec3::Zero();  // of the tool, where the points of a head are seen from
  switch (turning.kind) {
    case Turning::Kind::tableTable:
      return about(first, angles[0], about(second, angles[1], toolEnd));
    case Turning::Kind::headHead:
      return toolEnd - about(first, angles[0], about(second, angles[1], end));
    case Turning::Kind::headTable:
      return about(second, angles[1], toolEnd) - about(first, angles[0], end);
  }
  return toolEnd;
}

ToolPose toolPose(const Turning& turning, const Vec3& linear, const Angles& angles) {
  const auto& [first, second] = turning.axes;
  const Vec3 end = Vec3::Zero();
  const Eigen::Matrix3d one = rotation(first, angles[0]);
  const Eigen::Matrix3d two = rotation(second, angles[1]);
  switch (turning.kind) {
    case Turning::Kind::tableTable:
      return {about(second, -angles[1], about(first, -angles[0], linear)),
              (one * two).transpose() * Vec3::UnitZ()};
    case Turning::Kind::headHead:
      return {linear + about(first, angles[0], about(second, angles[1], end)),
              one * two * Vec3::UnitZ()};
    case Turning::Kind::headTable:
      return {about(second, -angles[1], linear + about(first, angles[0], end)),
              two.transpose() * one * Vec3::UnitZ()};
  }
  return {linear, Vec3::UnitZ()};
}

}  // namespace arelem::robot
