#include "runtime/motion/settle.h"

namespace arelem::motion {

namespace {
/// Positions and axes in turn: how often, and the turn from which on both are sought at once.
constexpr int turnLimit = 40;
constexpr double turnedEnough = 1e-3;
/// An axis that follows may leave several places of the tool equally near the surface (a level
/// bottom along the normal): the share of each turn that is left out, so that the side from which
/// it turns tells which of them is the contact, not rounding.
constexpr double turnLeft = 1e-2;
}  // namespace

Settled settleInTurn(const Vec3& start,
                     const Vec3& held,
                     AxisRule& axis,
                     std::span<const Wanted> wanted,
                     std::span<const Constraint> constraints) {
  Settled out;
  out.toolEnd = start;
  Vec3 turned = held;
  for (int turns = 0; turns < turnLimit; ++turns) {
    AxisRule fixed(turned);
    const Settled there =
        settleEvenly(measured(out.toolEnd, fixed, wanted), fixed, wanted, constraints);
    if (!there.ok) {
      return out;
    }
    out = there;
    out.ok = false;
    if (axis.fault(out.toolEnd)) {
      return out;
    }
    const Vec3 next = axis.at(out.toolEnd);
    const double apart = (next - turned).norm();
    turned = (next + turnLeft * (turned - next)).normalized();
    if (apart <= turnedEnough) {
      break;
    }
  }
  return settle(out.toolEnd, axis, wanted, constraints);
}

}  // namespace arelem::motion
