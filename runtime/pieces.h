#pragma once
#include <functional>

#include "runtime/run.h"

/// Section 1 of programs whose actions are too many to be kept: loops of tens of thousands of
/// motions.
namespace arelem::runtime {

/// Actions of a piece. Longer programs are handed over in pieces of about that size.
inline constexpr std::size_t pieceSize = 40000;

/// Takes the actions up to a place over which the meaning of none of them reaches: what it clears
/// is not in the evaluation's result. Where it keeps them it is not called again.
using PieceCall = std::function<void(std::vector<Action>&)>;

/// The same as `evaluate` but for the actions that `piece` takes away. Programs in which motions go
/// on at labels are never divided.
[[nodiscard]] Evaluation evaluateInPieces(const ir::Program& program,
                                          const Options& options,
                                          DiagnosticSink& sink,
                                          const PieceCall& piece);

}  // namespace arelem::runtime
