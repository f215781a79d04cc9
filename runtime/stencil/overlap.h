#pragma once
#include <span>

#include "runtime/stencil/plan.h"

namespace arelem::stencil {

/// The area on which the paint of tracks lies more than once: what their cells have together over
/// what they cover, mm2.
[[nodiscard]] double overlapOf(std::span<const Track> tracks);

}  // namespace arelem::stencil
