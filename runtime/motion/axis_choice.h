#pragma once
#include <functional>

#include "runtime/motion/axis.h"
#include "runtime/motion/state.h"

namespace arelem::motion {

/// A surface as TLAXIS sees it.
struct AxisParty {
  const NamedSurface* surface = nullptr;
  double side = 1.0;                                ///< to which its normal points as an axis
  bool on = false;                                  ///< the tool end is on it
  std::function<std::unique_ptr<Field>()> contact;  ///< makes the gap field of the cutter
};

/// The rule that TLAXIS asks for. `part` is null where a startup has none; `forward` gives the
/// sense of the motion, zero where none is known yet.
[[nodiscard]] Result<AxisRule> chooseAxis(const State& state,
                                          const AxisParty* part,
                                          const AxisParty& drive,
                                          const Vec3& forward);

}  // namespace arelem::motion
