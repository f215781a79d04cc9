#include "ir/hole/steps.h"

#include <algorithm>

#include "ir/diag/ngc.h"

namespace arelem::hole {

Result<std::vector<Step>> stepsOf(const Cycle& cycle) {
  if (cycle.kind == Cycle::Kind::tap) {
    return fail(diag::NgcCycle,
                std::string("/TAP turns the spindle back at the bottom, which only a canned cycle "
                            "along z does"));
  }
  return timedStepsOf(cycle);
}

std::vector<Step> timedStepsOf(const Cycle& cycle) {
  const bool pecks = cycle.kind == Cycle::Kind::peck || cycle.kind == Cycle::Kind::chip;
  const double step = pecks ? cycle.step : cycle.depth;
  std::vector<Step> steps;
  const auto go = [&](Step::Kind kind, double height) { steps.push_back({kind, height, 0.0}); };
  go(Step::Kind::rapid, cycle.clearance);
  for (double depth = 0.0; depth < cycle.depth;) {
    if (depth > 0.0) {
      // Back into the hole as far above its bottom as the clearance, if the hole is that deep.
      go(Step::Kind::rapid, cycle.clearance);
      go(Step::Kind::rapid, std::min(cycle.clearance - depth, cycle.clearance));
    }
    depth = std::min(depth + step, cycle.depth);
    go(Step::Kind::feed, -depth);
  }
  if (cycle.kind == Cycle::Kind::dwell || cycle.kind == Cycle::Kind::boreDwell) {
    steps.push_back({Step::Kind::dwell, -cycle.depth, cycle.dwell});
  }
  const bool feedsOut = cycle.kind == Cycle::Kind::bore || cycle.kind == Cycle::Kind::boreDwell ||
                        cycle.kind == Cycle::Kind::tap;
  go(feedsOut ? Step::Kind::feed : Step::Kind::rapid, cycle.clearance);
  if (cycle.retract > cycle.clearance) {
    go(Step::Kind::rapid, cycle.retract);
  }
  return steps;
}

std::vector<Vec3> wayOver(const Vec3& from, const Vec3& clear, const Vec3& axis) {
  const double above = (from - clear).dot(axis);
  std::vector<Vec3> way;
  if (above < 0.0) {
    way.emplace_back(from - above * axis);
  }
  way.emplace_back(clear + std::max(above, 0.0) * axis);
  return way;
}

}  // namespace arelem::hole
