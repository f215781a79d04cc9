#pragma once
#include <optional>

#include "runtime/certify/probe.h"

namespace arelem::motion {

/// A gap on a chord that is above a limit, at this share of its length.
struct Bulge {
  double share = 0.0, gap = 0.0;
};

/// Looks for a gap above `limit` on a chord whose ends are below: by the second derivatives of the
/// gaps of those places of the cutter that touch, which bound it between the places measured.
/// None: there is no such gap, or it takes too long to tell.
[[nodiscard]] std::optional<Bulge> bulgeOver(certify::Probe& probe,
                                             const certify::Chord& chord,
                                             double limit);

}  // namespace arelem::motion
