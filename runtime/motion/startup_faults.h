#pragma once
#include <span>

#include "runtime/motion/settle.h"
#include "runtime/motion/state.h"

namespace arelem::motion {

/// One surface of the startup: where it is, on which side the tool ends up, and the gap field
/// there.
struct StartupGoal {
  NamedSurface surface;
  ir::Condition condition = ir::Condition::to;
  Role role = driveRole;
  double side = 1.0;
  std::unique_ptr<Field> field;
};

/// Why no position was found from a place: surfaces that are parallel, a hollow that is too narrow
/// for the cutter, or nothing better to say.
[[nodiscard]] Failure noPosition(const tool::Profile& cutter,
                                 std::span<const StartupGoal> goals,
                                 const Settled& found,
                                 const Vec3& from);
/// Why a position is none: the tool touches a surface behind an end of it there.
[[nodiscard]] std::optional<Failure> behindEnd(std::span<const StartupGoal> goals,
                                               const Vec3& toolEnd,
                                               const Vec3& axis);
/// The direction of OFFSET passes beside the drive surface, or leads away from it.
[[nodiscard]] Failure offsetMisses(const NamedSurface& drive,
                                   const Vec3& toolEnd,
                                   const Vec3& axis,
                                   const Vec3& along);
/// Where a search ended, and what is missed there.
[[nodiscard]] Failure diverged(std::span<const StartupGoal> goals, const Settled& found);

}  // namespace arelem::motion
