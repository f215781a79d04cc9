#pragma once
#include "runtime/interpret/action.h"
#include "runtime/motion/records.h"
#include "runtime/motion/state.h"

namespace arelem::motion {

/// The passes of POCKET, from the innermost to the wall. Each but the innermost is a closed polygon
/// that begins and ends in the image of the first point; the innermost may be a line.
struct PocketPath {
  std::vector<std::vector<Vec3>> passes;
  double length = 0.0;  ///< from where the tool stands, part unit
};

/// Re, c, f, f1, f2, f3, o, p and the points of the statement, with cutter, tool axis and part
/// surface of the state. Passes are c (the last one f) times the cutter's radius apart; with o = 0
/// less where corners are so sharp that material would stay, c R <= Re (1 + sin(angle / 2)). They
/// end where one half a step further in would find no material farther than Re away.
/// Source: APT part programming manual, POCKET.
[[nodiscard]] Result<PocketPath> pocketPath(const runtime::Pocket& pocket, const State& state);

/// Writes the passes: the way to the first place with feed f1, the last pass with f3, all else with
/// f2. Returns the number of cut vectors.
std::uint64_t putPocket(const PocketPath& path,
                        const runtime::Pocket& pocket,
                        State& state,
                        RecordWriter& writer);

}  // namespace arelem::motion
