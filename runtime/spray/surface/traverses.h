#pragma once
#include "runtime/spray/surface/surface_job.h"

namespace arelem::spray {

class Walls;

/// Leads the gun from line to line, round the work where straight on it would come nearer than the
/// job's clearance, and measures the way. `walls` may be null: then all goes straight on. Error
/// E0599 where there is no way from line to line; with MINRAD, OFF, and to the first line, the gun
/// goes straight on there.
[[nodiscard]] std::optional<Failure> goRound(Sprayed& sprayed,
                                             const SurfaceJob& job,
                                             const Walls* walls);

}  // namespace arelem::spray
