#pragma once
#include "runtime/motion/course.h"

namespace arelem::motion {

/// Why a motion that has been followed to its end met no check surface: what was measured on the
/// way, of the first of them.
[[nodiscard]] Failure missed(const Course& course);
/// The motion has so many cut vectors, which is the limit; or its check surfaces are such that it
/// never meets them, however many it may have.
[[nodiscard]] Failure tooMany(const Course& course, const PathPoint& last, double cutVectors);

/// Where the surfaces next to `last`, ahead on the path, leave no axis at the angle of the rule:
/// why. An axis that does not settle there may do so round a corner.
[[nodiscard]] std::optional<Failure> axisEnds(Course& course, const PathPoint& last);

/// Why the path goes no farther than `last`.
[[nodiscard]] Failure lost(Course& course, const PathPoint& last);

/// Why no cut vector leads from `a` to `b`: drive and part surface, one of them of triangles, are
/// parallel at both ends but for the rounding of a file, and the path could as well lead anywhere
/// else.
[[nodiscard]] std::optional<Failure> parallelBetween(const Course& course,
                                                     const PathPoint& a,
                                                     const PathPoint& b);

/// The same where the path took more than `gaps` gaps for each of its cut vectors: that it does not
/// get on, or that there is an axis between two contacts only.
[[nodiscard]] Failure tooMuch(Course& course,
                              const PathPoint& last,
                              std::uint64_t gaps,
                              std::uint64_t cutVectors);

/// True of messages that name the nearest approach to a check surface.
[[nodiscard]] bool tellsNearest(const Failure& failure);

/// A path that went on to its end because the tool stood at the check surface from the start on:
/// the fault is not with the surface that ended it, and the help says so.
[[nodiscard]] Failure withStart(Failure failure, const Course& course);

/// A cutter that is higher than a hollow in which only its lower end cuts: the help says so.
[[nodiscard]] Failure withHeight(Failure failure,
                                 const Course& course,
                                 const tool::Profile& cutter);

}  // namespace arelem::motion
