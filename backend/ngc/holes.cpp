// Canned cycles, and their moves one by one where the control cannot do them.
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "backend/ngc/moves.h"
#include "ir/diag/ngc.h"
#include "ir/limits.h"
#include "ir/space/tolerance.h"

namespace arelem::backend::ngc {

namespace {
using robot::ToolPose;
using robot::TurnedPlace;

constexpr int secondsDecimals = 3;
/// A cycle written out has at most so many pecks a hole.
constexpr double mostPecks = 10000.0;
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
  cycle_.reset();
  if (outside_) {
    std::tie(feed_, feedMode_) = *outside_;
    outside_.reset();
  }
}

void Moves::beginCycle(const Cycle& cycle) {
  endCycle();
  cycle_ = lastCycle_ = cycle;
  if (cycle.feed) {
    cl::Post own{Word::FEDRAT, "", {*cycle.feed}};
    if (cycle.feedHasUnit) {
      own.arguments.emplace_back(cycle.feedUnit);
    }
    const auto before = std::pair(feed_, feedMode_);
    feed(own);
    outside_ = before;
  }
}

void Moves::cycle(const cl::Post& post) {
  const Word* first = post.arguments.empty() ? nullptr : std::get_if<Word>(&post.arguments[0]);
  if (first != nullptr && *first == Word::OFF) {
    return endCycle();
  }
  if (first != nullptr && *first == Word::ON) {
    return lastCycle_ ? beginCycle(*lastCycle_)
                      : report(fail(diag::NgcCycle, std::string("/ON has no cycle before it")));
  }
  const auto* text =
      post.arguments.empty() ? nullptr : std::get_if<std::string>(&post.arguments[0]);
  if (text != nullptr && *text == "INIT") {
    return;  // Fusion's head of a cycle that follows
  }
  if (text != nullptr && *text == "CLEAR" && post.arguments.size() == 1) {
    return endCycle();  // SolidWorks CAM, before a cycle
  }
  Result<Cycle> read = readCycle(post);
  if (!read) {
    return report(read.takeFailure());
  }
  if (read->kind == Cycle::Kind::peck && read->depth / read->step > mostPecks) {
    return report(fail(diag::NgcCycle, fmt::format("has {:.6g} pecks a hole; {:.6g} is the most",
                                                   read->depth / read->step, mostPecks)));
  }
  beginCycle(*read);
}

/// One location under a cycle: drilled along the tool axis, back to the height of RTRCTO or else
/// the clearance, not higher.
void Moves::hole(const ToolPose& at) {
  if (!feedIsKnown(at.end)) {
    return;
  }
  if (feedMode_ == FeedMode::inverseTime) {
    return report(fail(diag::NgcCycle, std::string("needs a feed; an inverse time is none")));
  }
  const bool turned = (at.axis - now_.pose.axis).norm() > tolerance::symmetric;
  const ToolPose between{at.end + cycle_->retract * unit_ * at.axis, at.axis};
  // G98 goes back to the height where the cycle began, which is that of its first hole.
  const bool other = cycle_->retract > cycle_->clearance && cycleOpen_ &&
                     std::abs((between.end - now_.pose.end).dot(at.axis)) > tolerance::coincidence;
  if (turned || other) {
    closeCycle();
  }
  if (!cycleOpen_) {
    approach(between);
  }
  const Vec3 along = onMachine(at.end + at.axis) - onMachine(at.end);
  const bool upright = (along - Vec3::UnitZ()).norm() <= tolerance::symmetric;
  const bool canned = control_.cycles && upright;
  if (!cycleAllowed(canned)) {
    return;
  }
  if (canned) {
    cannedHole(at);
  } else {
    drilledHole(at);
  }
}

/// At the bottom of a thread the spindle turns back with the feed: only the control can do that.
bool Moves::cycleAllowed(bool canned) {
  if (cycle_->kind != Cycle::Kind::tap) {
    return true;
  }
  if (spindle_ == Spindle::off) {
    report(fail(diag::NgcCycle, std::string("/TAP needs a spindle that turns; SPINDL starts it")));
    return false;
  }
  if (!canned) {
    report(fail(diag::NgcCycle,
                std::string("/TAP turns the spindle back at the bottom, which only a canned cycle "
                            "along z does")));
  }
  return canned;
}

/// The way to the first hole: across at the height where the tool is, or at the clearance if that
/// is higher; straight where the tool turns.
void Moves::approach(const ToolPose& clear) {
  const bool wasRapid = std::exchange(rapid_, true);
  const double above = (now_.pose.end - clear.end).dot(clear.axis);
  const bool same = placed_ && (now_.pose.axis - clear.axis).norm() <= tolerance::symmetric;
  if (same) {
    if (above < 0.0) {
      line({now_.pose.end - above * clear.axis, clear.axis});
    }
    line({clear.end + std::max(above, 0.0) * clear.axis, clear.axis});
    if (above > 0.0 && cycle_->retract > cycle_->clearance) {
      line(clear);  // where G98 comes back to
    }
  } else {
    line(clear);
  }
  rapid_ = wasRapid;
}

void Moves::cannedHole(const ToolPose& at) {
  const bool counter = spindle_ == Spindle::counterclockwise;
  const std::array codes = {"G81", "G82", "G83", "G73", "G85", "G89", counter ? "G74" : "G84"};
  const Vec3 place = onMachine(at.end);
  const double clear = place.z() + cycle_->clearance * unit_;
  block_.modal('p', "G17");
  block_.end();
  const bool higher = cycle_->retract > cycle_->clearance;
  block_.code(higher ? "G98" : "G99");
  block_.code(codes.at(static_cast<std::size_t>(cycle_->kind)));
  block_.length('X', place.x());
  block_.length('Y', place.y());
  block_.length('Z', place.z() - cycle_->depth * unit_);
  block_.length('R', clear);
  if (cycle_->kind == Cycle::Kind::dwell || cycle_->kind == Cycle::Kind::boreDwell) {
    block_.number('P', cycle_->dwell, secondsDecimals);
  } else if (cycle_->kind == Cycle::Kind::peck || cycle_->kind == Cycle::Kind::chip) {
    block_.length('Q', cycle_->step * unit_);
  }
  putFeed(0.0);
  block_.end();
  block_.forget('m');
  block_.forgetAxes();
  cycleOpen_ = true;
  now_.pose = {at.end + cycle_->retract * unit_ * at.axis, at.axis};
  placed_ = sure_ = true;
}

void Moves::drilledHole(const ToolPose& at) {
  const Vec3 clear = at.end + cycle_->clearance * unit_ * at.axis;
  const auto go = [&](const Vec3& end, bool rapid) {
    const bool before = std::exchange(rapid_, rapid);
    line({end, at.axis});
    rapid_ = before;
  };
  const bool pecks = cycle_->kind == Cycle::Kind::peck || cycle_->kind == Cycle::Kind::chip;
  const double step = pecks ? cycle_->step : cycle_->depth;
  go(clear, true);
  for (double depth = 0.0; depth < cycle_->depth;) {
    if (depth > 0.0) {
      // Back into the hole as far above its bottom as the clearance, if the hole is that deep.
      go(clear, true);
      go(at.end - std::max(depth - cycle_->clearance, -cycle_->clearance) * unit_ * at.axis, true);
    }
    depth = std::min(depth + step, cycle_->depth);
    go(at.end - depth * unit_ * at.axis, false);
  }
  const bool dwells = cycle_->kind == Cycle::Kind::dwell || cycle_->kind == Cycle::Kind::boreDwell;
  if (dwells) {
    block_.code("G4");
    block_.number('P', cycle_->dwell, secondsDecimals);
    block_.end();
  }
  const bool bores = cycle_->kind == Cycle::Kind::bore || cycle_->kind == Cycle::Kind::boreDwell;
  go(clear, !bores);
  if (cycle_->retract > cycle_->clearance) {
    go(at.end + cycle_->retract * unit_ * at.axis, true);
  }
}

}  // namespace arelem::backend::ngc
