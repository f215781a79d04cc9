#include "runtime/certify/stop_count.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::certify {

namespace {
/// Looks at a cut vector that is within the tolerance all along.
constexpr double stepsWithin = 1000.0;
/// Share of a gap that is to be proven for a place clear of the surface.
constexpr double clearShare = 0.75;
/// A tool that turns where it stands goes across the path, but for this share of its way: the path
/// is that of the tool before it turned.
constexpr double acrossShare = 0.1;
}  // namespace

StopCount::StopCount(const surface::AnySurface& surface,
                     const StopWanted& wanted,
                     const Location& first)
    : surface_(surface),
      wanted_(wanted),
      plus_(makeProbe(surface, {wanted.cutter, 1.0, wanted.thick})),
      minus_(isPoint() ? nullptr : makeProbe(surface, {wanted.cutter, -1.0, wanted.thick})),
      last_(first),
      tolerance_(wanted.allowed.inner + wanted.allowed.outer + wanted.allowed.slack),
      near_(tolerance_ + wanted.pathBand),
      reach_(isPoint() ? 0.0 : std::hypot(wanted.cutter->maxRadius(), wanted.cutter->h)),
      begin_(first.toolEnd) {}

int StopCount::inVisit() const {
  // A tool may come TO and PAST at one place; its end comes ON there.
  return isPoint() ? changes_ : std::max(changes_, 1);
}

/// Raises `low` of a place clear of the surface to what proves that.
void StopCount::prove(Probe& probe, Node& node) const {
  for (double before = unbounded; node.high < before && node.high > near_;) {
    const double aim = near_ + clearShare * (node.high - near_);
    if (node.low >= aim) {
      return;
    }
    before = node.high;
    probe.settle(node, aim);  // ends with the first smaller gap that it finds
  }
}

Range StopCount::gapOf(Probe& probe, double side, double s) const {
  Node node = probe.at(s);
  prove(probe, node);
  if (node.low <= near_ && node.high > near_) {
    // Contacts are looked for from those before; one that begins anew may find another.
    const auto anew = makeProbe(surface_, {wanted_.cutter, side, wanted_.thick});
    anew->take(chord_);
    anew->widen();
    Node again = anew->at(s);
    prove(*anew, again);
    return {std::max(node.low, again.low), std::min(node.high, again.high)};
  }
  return {node.low, node.high};
}

double StopCount::measure(double s) {
  Range gap = gapOf(*plus_, 1.0, s);
  if (!isPoint()) {
    const Range other = gapOf(*minus_, -1.0, s);
    gap = {std::max(gap.low, other.low), std::max(gap.high, other.high)};
  }
  if (gap.high <= near_) {
    return gap.high;
  }
  return gap.low > near_ ? gap.low : 0.0;
}

void StopCount::note(double value, const Vec3& place) {
  const double size = std::abs(value);
  const bool positive = value > 0.0;
  if (!armed_) {
    armed_ = size > tolerance_;
    startedClear_ = isPoint() || positive;
    positive_ = above_ = positive;
    return;
  }
  if (size > tolerance::sameSide && positive != above_) {
    above_ = positive;
    ++changes_;
  }
  if (size <= near_) {
    visits_ = true;
    return;
  }
  if (positive != positive_) {
    positive_ = positive;
    if (++sure_ == before() + 1) {
      passedAt_ = place;
      passedVector_ = vectors_;
    }
  } else if (visits_) {
    visited_ += isPoint() ? std::max(inVisit(), 1) : std::max(inVisit(), 2);
  }
  visits_ = false;
  changes_ = 0;
}

void StopCount::add(const Location& next) {
  chord_ = Chord(last_.toolEnd, next.toolEnd, last_.axis, next.axis);
  last_ = next;
  const double turn = reach_ * chord_.turn();
  const double way = chord_.length() + turn;
  const Vec3 gone = next.toolEnd - begin_;
  const bool across = std::abs(wanted_.path.dot(gone)) <= acrossShare * gone.norm();
  begins_ = begins_ && chord_.turn() > 0.0 && (across || turn > chord_.length());
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
      probe->take(chord_);
      probe->widen();
    }
  }
  const double finest = std::max(share(), way / stepsWithin);
  double along = free_;
  double clear = 0.0;
  while (along <= way) {
    const double s = along / way;
    const double value = measure(s);
    note(value, chord_.toolEnd(s));
    clear = std::abs(value) - near_;
    const double step = std::max(clear, finest);
    // Near the surface the end counts as well.
    along = clear < finest && along < way ? std::min(along + step, way) : along + step;
  }
  free_ = std::min(along - way, std::max(clear, share()));
  ++vectors_;
}

}  // namespace arelem::certify
