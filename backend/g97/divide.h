#pragma once
#include "backend/g97/block.h"

namespace arelem::g97 {

/// A block and whether the gun sprays on the way to it.
struct Step {
  Block block;
  bool spraying = false;
};

/// Programs of at most style.blocks blocks, divided at moves that the gun makes switched off. A
/// program begins with a P block: of a traverse, or, where the move is straight, to the last
/// location of the program before. With a code for S63 each begins with a block of its own that
/// carries it. Error E0643: a pass that no program holds.
[[nodiscard]] Result<std::vector<Program>> divided(std::vector<Step> steps,
                                                   const robot::G97Style& style);

}  // namespace arelem::g97
