#pragma once
#include <optional>

#include "runtime/motion/course.h"

namespace arelem::motion {

/// A check surface that a chord meets, as an index into the course's watches.
struct Met {
  std::size_t check = 0;
  CheckWatch::Hit hit;
  double rest = 0.0;  ///< the gap to leave there, found with the stop
};

/// A check surface that is met, and the place of the stop: none where the path cannot be followed
/// that far.
struct Found {
  Met met;
  std::optional<PathPoint> end;
};

/// Finds where a motion stops.
class StopFinder {
 public:
  StopFinder(const State& state, Course& course) : state_(state), course_(course) {}

  /// The first stop on the segment that begins at `a`: none where no check surface is met. Keeps
  /// the watches' progress before the segment.
  [[nodiscard]] std::optional<Found> find(const PathPoint& a, const Segment& segment);
  /// The same at the band's edge instead of a tenth inside; exact stops have none.
  [[nodiscard]] std::optional<PathPoint> stopAtEdge(const PathPoint& a,
                                                    const Segment& segment,
                                                    const Met& met);

  /// True where a tool at rest at `a`, short of the surface but beyond the stop, is within the
  /// tolerance of the check surface.
  [[nodiscard]] bool isWithin(const PathPoint& a, const Met& met) const;

  /// True where the last segment may have ended within the tolerance of a check surface.
  [[nodiscard]] bool mayBeBeyond() const;

  /// True where the path along curved surfaces is a straight line on which no check surface is met;
  /// the watches know it then.
  [[nodiscard]] bool isEndless();

  /// From the start again, if a circle that meets nothing else met a surface at its start exactly.
  [[nodiscard]] bool beginForFirstZero();

  /// Puts the watches back to where they were before the last segment, to try it again.
  void restore() { restore(kept_); }
  /// Where the tool goes on over that segment all the same, what was free before it need not be.
  void forgetFree();
  /// Remembers how they were before the last segment, and puts them back to that later.
  void remember() { remembered_ = kept_; }
  void recall() { restore(remembered_); }

 private:
  void keep();
  void restore(const std::vector<CheckWatch::Progress>& kept);
  std::optional<Met> scan(const Segment& segment);
  std::optional<PathPoint> stop(const PathPoint& a, const Segment& segment, Met& met);
  PathPoint onCircle(const Met& met, const PathPoint& end);
  Vec3 withoutTolerances(const PathPoint& a, const Segment& segment, const Met& met);
  bool isContact(const Met& met, const PathPoint& end);
  [[nodiscard]] bool mayBegin(const Met& met, const PathPoint& end) const;
  std::optional<PathPoint> atRest(const PathPoint& a, const Segment& segment, const Met& met);
  PathPoint closer(const PathPoint& a,
                   const Segment& segment,
                   const Met& met,
                   const PathPoint& end);
  [[nodiscard]] Role roleOf(const Met& met) const {
    return met.check == 0 ? checkRole : secondCheckRole;
  }

  const State& state_;
  Course& course_;
  std::vector<CheckWatch::Progress> kept_, remembered_;
};

}  // namespace arelem::motion
