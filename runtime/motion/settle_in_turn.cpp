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
/// With an axis that is held there may be no way to the position, though there is one with that at
/// which the way ends: so many ways in a row that end before it are gone on with.
constexpr int mostBlocked = 4;
}  // namespace

Settled settleInTurn(const Vec3& start,
                     const Vec3& held,
                     AxisRule& axis,
                     std::span<const Wanted> wanted,
                     std::span<const Constraint> constraints) {
  Settled out;
  out.toolEnd = start;
  Vec3 turned = held;
  int blocked = 0;
  for (int turns = 0; turns < turnLimit; ++turns) {
    AxisRule fixed(turned);
    const Settled there =
        settleEvenly(measured(out.toolEnd, fixed, wanted), fixed, wanted, constraints);
    blocked = there.ok ? 0 : blocked + 1;
    if (blocked > mostBlocked) {
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
      if (blocked > 0) {
        return out;
      }
      break;
    }
  }
  return settle(out.toolEnd, axis, wanted, constraints);
}

}  // namespace arelem::motion
