#pragma once
#include <optional>

#include "ir/cl/record.h"
#include "ir/diag/result.h"

namespace arelem::robot {

/// The number at a place of a postprocessor word; null where there is none.
[[nodiscard]] const double* numberAt(const cl::Post& post, std::size_t place);
/// The speed of a FEDRAT in mm/s: without a unit its number is lengths of `millimeters` per minute.
/// A feed per turn needs the spindle's `turns` a minute. None where it is not positive, per turn of
/// a spindle that stands, or an inverse time.
[[nodiscard]] std::optional<double> speedOf(const cl::Post& feedRate,
                                            double millimeters,
                                            double turns = 0.0);
/// The same for a robot that must have one. Errors: E0621.
[[nodiscard]] Result<double> neededSpeed(const cl::Post& feedRate,
                                         double millimeters,
                                         double turns = 0.0);
/// The seconds of a DELAY; with REV of a spindle with `turns` a minute. Error E0625: it has no
/// number, a negative one, or counts the turns of a spindle that stands.
[[nodiscard]] Result<double> secondsOf(const cl::Post& delay, double turns);

}  // namespace arelem::robot
