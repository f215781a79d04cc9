#include "runtime/motion/bulge.h"

namespace arelem::motion {

namespace {
/// Parts of a chord that are not halved any more, and places that are measured.
constexpr double smallestPart = 1.0 / 64.0;
constexpr int mostPlaces = 12;

class Search {
 public:
  Search(certify::Probe& probe, double limit) : probe_(probe), limit_(limit) {}

  void run(const certify::Node& a, const certify::Node& b) {
    if (found_ || places_ >= mostPlaces || b.s - a.s < smallestPart ||
        probe_.over(a, b, -certify::unbounded).high <= limit_) {
      return;
    }
    certify::Node middle = probe_.at(0.5 * (a.s + b.s));
    ++places_;
    // Where nothing was measured nothing is known; and one place of the cutter that is far off says
    // nothing if another may be nearer.
    if (middle.high > limit_ && middle.high < certify::unbounded) {
      probe_.settle(middle, limit_);
      if (middle.high > limit_ && middle.low >= limit_) {
        found_ = Bulge{middle.s, middle.high};
        return;
      }
    }
    // Chords start behind corners: there the contact changes.
    run(a, middle);
    run(middle, b);
  }
  [[nodiscard]] const std::optional<Bulge>& found() const { return found_; }

 private:
  certify::Probe& probe_;
  double limit_;
  int places_ = 0;
  std::optional<Bulge> found_;
};
}  // namespace

std::optional<Bulge> bulgeOver(certify::Probe& probe, const certify::Chord& chord, double limit) {
  probe.take(chord);
  const certify::Node first = probe.at(0.0);
  const certify::Node last = probe.at(1.0);
  Search search(probe, limit);
  search.run(first, last);
  // A ball end, which is measured alone, is far off where the shank touches.
  const auto& found = search.found();
  if (!found || !probe.widen() || probe.at(found->share).high > limit) {
    return found;
  }
  Search ofWhole(probe, limit);
  ofWhole.run(probe.at(0.0), probe.at(1.0));
  return ofWhole.found();
}

}  // namespace arelem::motion
