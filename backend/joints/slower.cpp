#include "backend/joints/slower.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "ir/diag/told_factor.h"

namespace arelem::joints {

namespace {
constexpr double mostLooks = 1.5e6;  // at one path
constexpr int betweenRows = 4;

/// Whether all joints keep their limits on a way with these speeds and this acceleration.
bool keepsLimits(const Arm& arm,
                 std::vector<Knot> knots,
                 const robot::Machine& machine,
                 double factor,
                 double acceleration) {
  constexpr double spare = 0.97;  // peaks may lie between two looks
  for (Knot& knot : knots) {
    knot.speed *= factor;
  }
  const Trajectory path(knots, acceleration, machine.blend);
  const double step = machine.interval / betweenRows;
  const double looks = std::ceil(path.duration() / step);
  if (!(looks < mostLooks)) {
    return false;
  }
  double turn = 0.0;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(looks); ++i) {
    const double time = std::min(static_cast<double>(i) * step, path.duration());
    const JointState joints = arm.jointsOf(path.at(time), turn);
    turn = joints.place[1];
    for (std::size_t j = 0; j < 2; ++j) {
      if (!(std::abs(joints.speed[j]) <= spare * arm.mostSpeed(j)) ||
          !(std::abs(joints.acceleration[j]) <= spare * arm.mostAcceleration(j))) {
        return false;
      }
    }
  }
  return true;
}

/// The largest factor that does, within a five hundredth, rounded down; none below 1 / 64.
std::optional<double> largest(const std::function<bool(double)>& does) {
  constexpr double least = 1.0 / 64.0;
  constexpr double enough = 1.002;
  double high = 1.0;
  double low = 0.5;
  while (!does(low)) {
    high = low;
    low *= 0.5;
    if (low < least) {
      return std::nullopt;
    }
  }
  while (high > enough * low) {
    const double middle = std::sqrt(low * high);
    (does(middle) ? low : high) = middle;
  }
  const double told = diag::toldFactor(low);
  return does(told) ? told : low;
}
}  // namespace

std::string slowerThatDoes(const Arm& arm,
                           const std::vector<Knot>& knots,
                           const robot::Machine& machine) {
  const auto softer = [&](double f) { return diag::toldFactor(f * f * machine.acceleration); };
  const auto speeds =
      largest([&](double f) { return keepsLimits(arm, knots, machine, f, machine.acceleration); });
  const auto both =
      largest([&](double f) { return keepsLimits(arm, knots, machine, f, softer(f)); });
  constexpr double muchFaster = 1.1;
  const bool better = both && (!speeds || *both > muchFaster * *speeds);
  const std::string with =
      better ? fmt::format("{:.4g} times with acceleration = {:.4g}", *both, softer(*both)) : "";
  if (speeds) {
    return fmt::format("speeds, `rapid` among them, {:.4g} times as large would do{}{}", *speeds,
                       better ? ", or " : "", with);
  }
  if (better) {
    return "speeds, `rapid` among them, would do " + with;
  }
  return "no speeds would do that are 1/64 as large or more: the path comes too near to a place "
         "where the joints have to be fast";
}

}  // namespace arelem::joints
