#pragma once
#include <algorithm>

#include "ir/space/tolerance.h"
#include "runtime/certify/probe.h"

namespace arelem::certify {

/// What the gap may be along a cut vector.
struct Allowed {
  double inner = 0.0, outer = 0.0;  ///< the gap may lie in [-inner, outer]
  double slack = 0.0;               ///< and beyond by this: rounding of the coordinates
  bool figures = true;  ///< tell the extremes closely; if not, only decide, and end once refuted
};

/// One end of the range of the gap over a cut vector.
struct Extreme {
  double proven = 0.0;    ///< no gap of the cut vector lies beyond this
  double measured = 0.0;  ///< and this one occurs
  double at = 0.0;        ///< its s
};

/// What rounding may add to each side of a band of this width: less than would matter to it. Part
/// unit.
[[nodiscard]] inline double slackOf(double band) {
  return std::clamp(tolerance::certifiedShare * band, tolerance::certifiedLeast,
                    tolerance::certifiedSlack);
}

struct Verdict {
  enum class State : std::uint8_t { proven, refuted, undecided };
  State inner = State::proven;  ///< is the surface nowhere undercut by more than allowed
  State outer = State::proven;  ///< is the cutter nowhere farther off than allowed
  Extreme least, greatest;
  std::uint64_t nodes = 0;  ///< places at which the gap was measured

  [[nodiscard]] bool good() const { return inner == State::proven && outer == State::proven; }
};

/// Proves or refutes that the gap keeps its limits over the whole cut vector: halves it until every
/// part is decided, by the whole cutter where a part of it does not do. `first` is the probe's node
/// at s = 0, and becomes that at s = 1. The probe must have taken the cut vector.
[[nodiscard]] Verdict prove(Probe& probe, const Allowed& allowed, Node& first);

}  // namespace arelem::certify
