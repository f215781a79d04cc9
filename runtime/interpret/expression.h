#pragma once
#include <optional>

#include "runtime/interpret/state.h"

namespace arelem::runtime::interpret {

/// The value of a scalar expression; none when it has none, which is then reported (or was, where a
/// poisoned name is used). A result is always finite.
[[nodiscard]] std::optional<double> scalar(State& state, ir::ExprId expr);

/// The value on which an IF decides. A difference that only rounding keeps from zero
/// (tolerance::decimalStep) is zero, so that a loop of decimal steps ends as it does on paper: ten
/// steps of .03 from .2 reach .5.
[[nodiscard]] std::optional<double> compared(State& state, ir::ExprId expr);

/// Stores a value under a scalar name; none where the name cannot take it.
bool assign(State& state, const ir::Target& target, std::optional<double> value);

/// base ** exponent (spec 2.1): a whole exponent (within tolerance::wholeExponent) by
/// multiplication.
[[nodiscard]] Result<double> power(double base, double exponent);

}  // namespace arelem::runtime::interpret
