#include "runtime/certify/stop_count.h"

#include <algorithm>
#include <cmath>

namespace arelem::certify {

namespace {
/// Looks at a cut vector that is within the tolerance all along.
constexpr double stepsWithin = 1000.0;
/// Share of the tolerance that is one step there, and to which a gap need be known.
constexpr double stepShare = 0.5;
}  // namespace

StopCount::StopCount(const surface::AnySurface& surface,
                     const StopWanted& wanted,
                     const Location& first)
    : wanted_(wanted),
      plus_(makeProbe(surface, {wanted.cutter, 1.0, wanted.thick})),
      minus_(isPoint() ? nullptr : makeProbe(surface, {wanted.cutter, -1.0, wanted.thick})),
      last_(first),
      tolerance_(wanted.allowed.inner + wanted.allowed.outer + wanted.allowed.slack),
      near_(tolerance_ + wanted.pathBand),
      reach_(isPoint() ? 0.0 : std::hypot(wanted.cutter->maxRadius(), wanted.cutter->h)) {}

int StopCount::possible() const {
  // The visit with which the path ends may be TO and PAST at one place.
  return isPoint() ? sure_ + visited_ : sure_ + 2 * visited_ + 1;
}

double StopCount::gapOf(Probe& probe, double s) const {
  Node node = probe.at(s);
  const double aim = node.high - stepShare * tolerance_;
  if (node.low < aim) {
    probe.settle(node, aim);
  }
  return node.high;
}

double StopCount::measure(double s) {
  const double plus = gapOf(*plus_, s);
  return isPoint() ? plus : std::max(plus, gapOf(*minus_, s));
}

void StopCount::note(double value, const Vec3& place) {
  const double size = std::abs(value);
  const bool positive = value > 0.0;
  if (!armed_) {
    if (size > tolerance_) {
      armed_ = true;
      startedClear_ = isPoint() || positive;
      positive_ = positive;
      isSettled_ = size > near_;
    }
    return;
  }
  if (size > tolerance_ && positive != positive_) {
    positive_ = positive;
    isSettled_ = visits_ = false;
    if (++sure_ == before() + 1) {
      passedAt_ = place;
      passedVector_ = vectors_;
    }
  }
  if (size > near_) {
    visited_ += visits_ ? 1 : 0;
    visits_ = false;
    isSettled_ = true;
  } else {
    visits_ = visits_ || isSettled_;
  }
}

void StopCount::add(const Location& next) {
  const Chord chord(last_.toolEnd, next.toolEnd, last_.axis, next.axis);
  last_ = next;
  const double turn = reach_ * chord.turn();
  const double way = chord.length() + turn;
  begins_ = begins_ && turn > chord.length();
  if (begins_) {
    ++vectors_;
    return;
  }
  if (free_ > way || way == 0.0) {
    free_ -= way;
    ++vectors_;
    return;
  }
  for (Probe* probe : {plus_.get(), minus_.get()}) {
    if (probe != nullptr) {
      probe->take(chord);
      probe->widen();
    }
  }
  const double finest = std::max(stepShare * tolerance_, way / stepsWithin);
  double along = free_;
  double clear = 0.0;
  while (along <= way) {
    const double s = along / way;
    const double value = measure(s);
    note(value, chord.toolEnd(s));
    clear = std::abs(value) - near_;
    const double step = std::max(clear, finest);
    // Near the surface the end counts as well.
    along = clear < finest && along < way ? std::min(along + step, way) : along + step;
  }
  free_ = std::min(along - way, std::max(clear, stepShare * tolerance_));
  ++vectors_;
}

}  // namespace arelem::certify
