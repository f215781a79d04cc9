#pragma once
#include "runtime/motion/course.h"

namespace arelem::motion {

/// Why a motion that has been followed to its end met no check surface: what was measured on the
/// way, of the first of them.
[[nodiscard]] Failure missed(const Course& course);

}  // namespace arelem::motion
