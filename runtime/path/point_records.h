#pragma once
#include <span>

#include "ir/cl/record.h"
#include "ir/space/vector.h"

namespace arelem::path {

/// Coordinates in one record at most, as in the old system.
inline constexpr std::size_t numbersPerRecord = 240;

/// Sends locations on as records like the given motion: GOTO and its continuations. `axis` is used
/// where the motion has one. No record without a location.
void putPoints(cl::RecordSink& next,
               const cl::Record& like,
               std::span<const Vec3> points,
               const Vec3& axis);

}  // namespace arelem::path
