#include "runtime/certify/prove.h"

#include <algorithm>
#include <cmath>

#include "runtime/certify/patience.h"

namespace arelem::certify {

namespace {
/// Extremes are told to this share of the band.
constexpr double figureShare = 0.01;
/// Parts of a cut vector that are not halved any more.
constexpr double smallestPart = 1e-9;
constexpr std::uint64_t nodeLimit = 4096;
/// Figures are told exactly as long as that takes no more; the limits themselves come first.
constexpr std::uint64_t figureLimit = nodeLimit / 4;

class Proof {
 public:
  Proof(Probe& probe, const Allowed& allowed)
      : probe_(probe),
        patient_(dynamic_cast<const Patient*>(&probe)),
        floor_(-allowed.inner - allowed.slack),
        ceiling_(allowed.outer + allowed.slack),
        figure_(allowed.figures ? figureShare * (allowed.inner + allowed.outer) + allowed.slack
                                : unbounded),
        figures_(allowed.figures) {}

  Verdict run(Node& first) {
    Node last = probe_.at(1.0);
    verdict_.least = {unbounded, unbounded, 0.0};
    verdict_.greatest = {-unbounded, -unbounded, 0.0};
    see(first);
    see(last);
    decide(first, last, {});
    finish();
    first = last;
    return verdict_;
  }

 private:
  /// What is measured too far off may have another place that is not, which then counts.
  void see(Node& n) {
    ++verdict_.nodes;
    if (n.high > std::max(ceiling_, verdict_.greatest.measured)) {
      probe_.settle(n, std::nextafter(ceiling_, unbounded));
    }
    if (n.high < verdict_.least.measured) {
      verdict_.least.measured = n.high;
      verdict_.least.at = n.s;
    }
    blind_ = blind_ || n.high == unbounded;
    if (n.high > verdict_.greatest.measured) {
      verdict_.greatest.measured = n.high;
      verdict_.greatest.at = n.s;
      farthest_ = n;
    }
  }

  [[nodiscard]] bool refuted() const {
    return !blind_ && (verdict_.least.measured < floor_ || verdict_.greatest.measured > ceiling_);
  }

  /// The bound that a part must reach: near what was measured, so that the figures mean something,
  /// and within the limit as long as that was kept.
  [[nodiscard]] double lowAim() const {
    const double measured = verdict_.least.measured;
    return measured < floor_ ? measured - figure_ : std::max(floor_, measured - figure());
  }
  [[nodiscard]] double highAim() const {
    const double measured = verdict_.greatest.measured;
    return measured > ceiling_ ? measured + figure_ : std::min(ceiling_, measured + figure());
  }
  [[nodiscard]] double figure() const { return verdict_.nodes < figureLimit ? figure_ : unbounded; }

  /// Parts are halved at most as often as smallestPart allows, so this goes 30 deep. `known` holds
  /// for the whole part: aims only fall, so a lower bound that reached its aim is not looked for
  /// again.
  void decide(const Node& a, const Node& b, const Range& known) {
    if (!figures_ && refuted()) {
      return;
    }
    if (blind_ || (patient_ != nullptr && patient_->givesUp())) {
      take(blind_ ? Range{} : known);
      return;
    }
    Stretch range = probe_.over(a, b, known.low >= lowAim() ? -unbounded : lowAim());
    range.low = std::max(range.low, known.low);
    range.high = std::min(range.high, known.high);
    if (range.sample < verdict_.least.measured) {
      verdict_.least.measured = range.sample;
      verdict_.least.at = range.sampleAt;
    }
    if (range.low >= lowAim() && range.high <= highAim()) {
      take(range);
      return;
    }
    if (b.s - a.s <= smallestPart || verdict_.nodes >= nodeLimit) {
      take(range);
      return;
    }
    Node middle = probe_.at(0.5 * (a.s + b.s));
    see(middle);
    decide(middle, b, range);
    decide(a, middle, range);
  }

  void take(const Range& range) {
    verdict_.least.proven = std::min(verdict_.least.proven, range.low);
    verdict_.greatest.proven = std::max(verdict_.greatest.proven, range.high);
  }

  void finish() {
    using State = Verdict::State;
    if (verdict_.least.measured < floor_) {
      verdict_.inner = State::refuted;
    } else if (!(verdict_.least.proven >= floor_)) {
      verdict_.inner = State::undecided;
    }
    if (verdict_.greatest.measured > ceiling_) {
      // A measured point of the cutter is too far off; is the nearest one?
      verdict_.outer = farthest_.low > ceiling_ ? State::refuted : State::undecided;
    } else if (!(verdict_.greatest.proven <= ceiling_)) {
      verdict_.outer = State::undecided;
    }
  }

  Probe& probe_;
  const Patient* patient_;
  double floor_, ceiling_, figure_;
  bool figures_;
  bool blind_ = false;  ///< at a place nothing was measured: no parts of the chord help
  Verdict verdict_;
  Node farthest_;
};
}  // namespace

Verdict prove(Probe& probe, const Allowed& allowed, Node& first) {
  const Verdict verdict = Proof(probe, allowed).run(first);
  if (verdict.good() || !probe.widen()) {
    return verdict;
  }
  first = probe.at(0.0);
  return Proof(probe, allowed).run(first);
}

}  // namespace arelem::certify
