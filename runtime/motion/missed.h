#pragma once
#include "runtime/motion/course.h"

namespace arelem::motion {

/// Why a motion that has been followed to its end met no check surface: what was measured on the
/// way, of the first of them.
[[nodiscard]] Failure missed(const Course& course);

/// Why the path goes no farther than `last`.
[[nodiscard]] Failure lost(Course& course, const PathPoint& last);

/// A path that went on to its end because the tool stood at the check surface from the start on:
/// the fault is not with the surface that ended it, and the help says so.
[[nodiscard]] Failure withStart(Failure failure, const Course& course);

}  // namespace arelem::motion
