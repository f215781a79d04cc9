#pragma once
#include <optional>

#include "runtime/tool/profile.h"

namespace arelem::tool {

/// Whether the values of CUTTER, in their written order and completed to seven, are in their
/// ranges (401 to 407, 417 of the old system).
[[nodiscard]] std::optional<Failure> rangeFault(const Profile& profile);
/// Whether bottom line, corner arc and side line join (405, 408 to 416 of the old system). In
/// CL text only a cutter that moves along surfaces must pass; others are but written again.
[[nodiscard]] std::optional<Failure> shapeFault(const Profile& profile);
/// The center of a corner arc of the profile's radius that touches both lines, wherever e and f are:
/// from where the lines meet, inwards and up to a place at that distance from both.
[[nodiscard]] ProfilePoint cornerCenter(const Profile& profile);
/// The same cutter with its corner moved to where it touches both lines, if shapeFault takes it as
/// touching: of written numbers the last decimal is rounded, and a bend that is none would make a
/// cutter hollow. A corner on the axis stays there, and the diameter follows.
[[nodiscard]] Profile joined(const Profile& profile);

}  // namespace arelem::tool
