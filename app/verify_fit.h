#pragma once
#include <optional>
#include <string>

#include "app/verify_path.h"

namespace arelem::app {

/// How far apart two paths of different locations may be.
struct FitAllowed {
  double share = 0.0;  ///< of INTOL + OUTTOL
  Allowed rounding;    ///< what is added to it
};

/// Compares paths and not locations: every place of either is within the allowed distance of the
/// other, in the order in which the tool comes there. Each location of `found` has its foot on the
/// program's path, behind the one before; between two feet the program's locations lie in the tube
/// about the line between the two found ones, and with them, as a tube is convex, the way. The axis
/// is that at the foot.
[[nodiscard]] std::optional<Diagnostic> firstDeparture(const Path& wanted,
                                                       const Path& found,
                                                       const std::string& name,
                                                       const FitAllowed& allowed);

}  // namespace arelem::app
