// Canned cycles, and their moves one by one where the control cannot do them.
#include <algorithm>
#include <array>
#include <cmath>

#include "backend/ngc/moves.h"
#include "ir/diag/ngc.h"
#include "ir/hole/steps.h"
#include "ir/limits.h"
#include "ir/space/tolerance.h"

namespace arelem::backend::ngc {

namespace {
using robot::ToolPose;

using hole::Cycle;
using hole::Cycles;

constexpr int secondsDecimals = 3;
}  // namespace

void Moves::closeCycle() {
  if (cycleOpen_) {
    block_.code("G80");
    block_.end();
    block_.forget('m');
    block_.forgetAxes();
  }
  cycleOpen_ = false;
}

/// The cycle is over, and so is its feed.
void Moves::endCycle() {
  closeCycle();
  feed_.endCycle();
}

void Moves::cycle(const cl::Post& post) {
  const Result<Cycles::Change> change = cycles_.read(post);
  if (!change) {
    return report(change.failure());
  }
  if (*change == Cycles::Change::none) {
    return;
  }
  endCycle();
  const Cycle* begun = cycles_.now();
  if (const auto own = begun != nullptr ? hole::feedOf(*begun) : std::nullopt) {
    if (const auto feed = readFeed(*own)) {
      feed_.beginCycle(*feed);
    }
  }
}

/// One location under a cycle: drilled along the tool axis, back to the height of RTRCTO or else
/// the clearance, not higher.
void Moves::drill(const ToolPose& at) {
  if (compensation_.isOn()) {
    return report(fail(diag::NgcCycle, std::string("stands while CUTCOM is on; CUTCOM/OFF first")));
  }
  compensation_.finish();
  const bool along = placed_ && (now_.pose.axis - at.axis).norm() <= tolerance::symmetric;
  const std::optional<double> height =
      along ? std::optional((now_.pose.end - at.end).dot(at.axis) / unit_) : std::nullopt;
  drill(at, hole::cycleFrom(*cycles_.now(), height));
}

void Moves::drill(const ToolPose& at, const Cycle& cycle) {
  if (!feedIsKnown(at.end)) {
    return;
  }
  if (feed_.now().per == cl::Feed::Per::move) {
    return report(fail(diag::NgcCycle, std::string("needs a feed; an inverse time is none")));
  }
  const bool turned = (at.axis - now_.pose.axis).norm() > tolerance::symmetric;
  const ToolPose between{at.end + cycle.retract * unit_ * at.axis, at.axis};
  // G98 goes back to the height where the cycle began, which is that of its first hole.
  const bool other = cycle.retract > cycle.clearance && cycleOpen_ &&
                     std::abs((between.end - now_.pose.end).dot(at.axis)) > tolerance::coincidence;
  if (turned || other) {
    closeCycle();
  }
  if (!cycleOpen_) {
    approach(between, cycle);
  }
  const Vec3 upwards = onMachine(at.end + at.axis) - onMachine(at.end);
  const bool upright = (upwards - Vec3::UnitZ()).norm() <= tolerance::symmetric;
  const bool canned = control_.cycles && upright;
  if (!cycleAllowed(canned)) {
    return;
  }
  if (canned) {
    cannedHole(at, cycle);
  } else {
    drilledHole(at, cycle);
  }
}

/// At the bottom of a thread the spindle turns back with the feed: only the control can do that.
bool Moves::cycleAllowed(bool canned) {
  const Cycle& cycle = *cycles_.now();
  if (cycle.kind != Cycle::Kind::tap || (canned && spindle_ != Spindle::off)) {
    return true;
  }
  report(
      spindle_ == Spindle::off
          ? fail(diag::NgcCycle, std::string("/TAP needs a spindle that turns; SPINDL starts it"))
          : hole::stepsOf(cycle).takeFailure());
  return false;
}

/// The way to the first hole: across at the height where the tool is, or at the clearance if that
/// is higher; straight where the tool turns.
void Moves::approach(const ToolPose& clear, const Cycle& cycle) {
  const bool wasRapid = std::exchange(rapid_, true);
  if (placed_ && (now_.pose.axis - clear.axis).norm() <= tolerance::symmetric) {
    for (const Vec3& end : hole::wayOver(now_.pose.end, clear.end, clear.axis)) {
      line({end, clear.axis});
    }
    if (cycle.retract > cycle.clearance) {
      line(clear);  // where G98 comes back to
    }
  } else {
    line(clear);
  }
  rapid_ = wasRapid;
}

void Moves::cannedHole(const ToolPose& at, const Cycle& cycle) {
  const bool counter = spindle_ == Spindle::counterclockwise;
  const std::array codes = {"G81", "G82", "G83", "G73", "G85", "G89", counter ? "G74" : "G84"};
  const Vec3 place = onMachine(at.end);
  const double clear = place.z() + cycle.clearance * unit_;
  block_.modal('p', "G17");
  block_.end();
  const bool higher = cycle.retract > cycle.clearance;
  block_.code(higher ? "G98" : "G99");
  block_.code(codes.at(static_cast<std::size_t>(cycle.kind)));
  block_.length('X', place.x());
  block_.length('Y', place.y());
  block_.length('Z', place.z() - cycle.depth * unit_);
  block_.length('R', clear);
  if (cycle.kind == Cycle::Kind::dwell || cycle.kind == Cycle::Kind::boreDwell) {
    block_.number('P', cycle.dwell, secondsDecimals);
  } else if (cycle.kind == Cycle::Kind::peck || cycle.kind == Cycle::Kind::chip) {
    block_.length('Q', cycle.step * unit_);
  }
  putFeed(0.0);
  block_.end();
  block_.forget('m');
  block_.forgetAxes();
  cycleOpen_ = true;
  now_.pose = {at.end + cycle.retract * unit_ * at.axis, at.axis};
  placed_ = sure_ = true;
}

void Moves::drilledHole(const ToolPose& at, const Cycle& cycle) {
  const Result<std::vector<hole::Step>> steps = hole::stepsOf(cycle);
  if (!steps) {
    return report(steps.failure());
  }
  for (const hole::Step& step : *steps) {
    if (step.kind == hole::Step::Kind::dwell) {
      block_.code("G4");
      block_.number('P', step.seconds, secondsDecimals);
      block_.end();
      continue;
    }
    const bool before = std::exchange(rapid_, step.kind == hole::Step::Kind::rapid);
    line({at.end + step.height * unit_ * at.axis, at.axis});
    rapid_ = before;
  }
}

}  // namespace arelem::backend::ngc
