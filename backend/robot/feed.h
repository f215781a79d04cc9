#pragma once
#include <optional>

#include "ir/cl/record.h"
#include "ir/diag/result.h"

namespace arelem::robot {

/// The number at a place of a postprocessor word; null where there is none.
[[nodiscard]] const double* numberAt(const cl::Post& post, std::size_t place);
/// Whether the word stands in it.
[[nodiscard]] bool hasWord(const cl::Post& post, Word word);

/// The speed of a FEDRAT in mm/s: without a unit its number is lengths of `millimeters` per minute.
/// None where it is not positive or per revolution.
[[nodiscard]] std::optional<double> speedOf(const cl::Post& feedRate, double millimeters);
/// The same for a robot that must have one. Errors: E0621.
[[nodiscard]] Result<double> neededSpeed(const cl::Post& feedRate, double millimeters);

}  // namespace arelem::robot
