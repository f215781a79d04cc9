#pragma once
#include "runtime/interpret/spray_words.h"

namespace arelem::runtime::interpret {

/// The work of a job as its words give it: a patch or a mesh, between the planes of LIMITS, and,
/// for PAST, what lies as far beyond them. `unit` in mm. Errors: E0357, E0377, E0378.
[[nodiscard]] std::optional<Failure> setWork(spray::SurfaceJob& job,
                                             const SprayWords& words,
                                             double unit);

}  // namespace arelem::runtime::interpret
