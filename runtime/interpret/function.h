#pragma once
#include <optional>
#include <vector>

#include "runtime/interpret/state.h"

namespace arelem::runtime::interpret {

/// The value of a function call (spec 2.2), its arguments evaluated; failures are reported.
[[nodiscard]] std::optional<double> callFunction(State& state, const ir::Expr& call);

/// The functions of numbers. Angles in degrees.
[[nodiscard]] Result<double> functionOfNumbers(Word function, const std::vector<double>& x);
/// The functions of entities: DOTF, LNTHF, ANGLF, NUMF, DISTF.
[[nodiscard]] Result<double> functionOfEntities(Word function, const std::vector<EntityPtr>& e);

}  // namespace arelem::runtime::interpret
