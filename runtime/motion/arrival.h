#pragma once
#include <optional>

#include "runtime/motion/stop.h"
#include "runtime/motion/trail.h"

namespace arelem::motion {

/// A cut vector whose chord leaves the band by this share of the length's square is taken.
inline constexpr double fitShare = 1e-6;

/// The last cut vectors of a motion, to a stop that was found.
class Arrival {
 public:
  /// `longest`: of a cut vector (MAXDP), in part units.
  Arrival(Course& course, StopFinder& stops, Trail& trail, const Limits& limits, double longest)
      : course_(course), stops_(stops), trail_(trail), limits_(limits), longest_(longest) {}

  /// The stop, if one cut vector from `a`, where the segment begins, reaches it within the bands;
  /// otherwise shortens `cap` so that the rest is shared evenly and no tiny vector remains.
  [[nodiscard]] std::optional<PathPoint> fittingStop(const PathPoint& a,
                                                     const Segment& segment,
                                                     const Found& found,
                                                     double& cap);

  /// Goes from `last` to the stop. A cut vector that ends there but for rounding is enough. One
  /// that ends beyond it within the tolerance shall end at the stop instead: the way back would be
  /// for nothing, and how far it went beyond is not the same for the same motion elsewhere. So
  /// shall one from which the stop is aside: the last cut vector is the direction of what follows.
  /// False where that takes more than one: then `last` is where that cut vector began, `cap`
  /// shortened.
  [[nodiscard]] bool arrive(
      PathPoint& last, const PathPoint& stop, const Segment& segment, const Met& met, double& cap);

  /// The cut vector to `to`; it is held back where a stop may take the place of its end.
  void put(PathPoint& last, const PathPoint& to);

 private:
  [[nodiscard]] std::optional<PathPoint> fitting(const PathPoint& from,
                                                 const PathPoint& a,
                                                 const Segment& segment,
                                                 const Met& met,
                                                 const PathPoint& end);
  [[nodiscard]] bool reaches(const PathPoint& from, const PathPoint& end);
  [[nodiscard]] double shared(const PathPoint& from, const PathPoint& end);
  [[nodiscard]] double nearStop() const;

  Course& course_;
  StopFinder& stops_;
  Trail& trail_;
  const Limits& limits_;
  double longest_;
  bool hasMoved_ = false;      ///< a cut vector along the path was put out
  bool hasWithdrawn_ = false;  ///< a cut vector beyond the stop: once is enough
};

}  // namespace arelem::motion
