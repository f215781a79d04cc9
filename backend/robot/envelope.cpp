#include "backend/robot/envelope.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/diag/robot.h"

namespace arelem::robot {

namespace {
Objection beyond(std::string_view place, std::string_view what, double value, const Range& range) {
  const double excess = std::max(value - range.high, range.low - value);
  return {fail(diag::OutsideEnvelope, place, what, value, range.low, range.high, excess), excess};
}
}  // namespace

std::optional<Objection> objectionToPlace(const Envelope& envelope,
                                          const Pose& inBase,
                                          std::string_view place) {
  constexpr std::array names = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = inBase.point[static_cast<Eigen::Index>(i)];
    const Range& side = envelope.sides[i];
    if (!side.has(value)) {
      return beyond(place, names[i], value, side);
    }
  }
  const double distance = (inBase.point - envelope.center).norm();
  if (!envelope.reach.has(distance)) {
    return beyond(place, "the distance from the center of the reach", distance, envelope.reach);
  }
  const Vec3 axis = inBase.axis.normalized();
  const double lean =
      std::atan2(std::hypot(axis.x(), axis.y()), axis.z()) * 180.0 / std::numbers::pi;
  if (lean > envelope.lean) {
    return beyond(place, "the angle of the tool axis from the vertical", lean,
                  {0.0, envelope.lean});
  }
  return std::nullopt;
}

}  // namespace arelem::robot
