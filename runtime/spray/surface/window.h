#pragma once
#include "runtime/spray/surface/patch.h"

namespace arelem::spray {

/// What planes leave of a surface without ends.
enum class WindowBetween : std::uint8_t { bounded, endless, empty };

/// Sets v0 and v1 of a patch that is straight along v, from its planes: the widest stretch between
/// them at any u of its range, not below `lowest`. Of a plane u0 and u1 too.
[[nodiscard]] WindowBetween windowBetween(Patch& patch, double lowest, bool isPlane);

}  // namespace arelem::spray
