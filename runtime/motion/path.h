#pragma once
#include <array>

#include "runtime/motion/check_watch.h"
#include "runtime/motion/chord.h"
#include "runtime/motion/settle.h"

namespace arelem::motion {

/// One of the two surfaces that guide a motion, with its tolerance band.
struct Guide {
  std::unique_ptr<Field> field;
  NamedSurface surface;
  double inner = 0.0, outer = 0.0;        ///< the gap may lie in [-inner, outer]
  double rest = 0.0;                      ///< gap at stops
  double bend = 0.0;                      ///< present estimate of the curvature along the path
  double gapInner = 0.0, gapOuter = 0.0;  ///< extreme gaps of the cut vectors so far

  [[nodiscard]] bool flat() const { return field->flat(); }
  /// Gap at which the next cut vector should end: the edge that leaves the chord most room.
  [[nodiscard]] double vertexGap() const { return flat() ? rest : bend >= 0.0 ? outer : -inner; }
};

/// A place on the path: tool position, contacts with part (0) and drive (1) surface, and the
/// direction.
struct PathPoint {
  Vec3 toolEnd = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  std::array<tool::Contact, 2> contacts;
  Vec3 tangent = Vec3::UnitX();
};

/// The curve on which both gaps keep given values.
class Path {
 public:
  std::array<Guide, 2> guides;  ///< part, drive
  AxisRule axis;

  /// Contacts and tangent at a tool position; the tangent goes with `towards`.
  [[nodiscard]] PathPoint look(const Vec3& toolEnd, const Vec3& towards);
  /// The place at distance `along` from `from`, measured on its tangent, with the given gaps. None
  /// where the path cannot be followed so far.
  [[nodiscard]] std::optional<PathPoint> step(const PathPoint& from,
                                              double along,
                                              const std::array<double, 2>& gaps,
                                              double accept);
  [[nodiscard]] std::array<double, 2> rests() const { return {guides[0].rest, guides[1].rest}; }
  [[nodiscard]] bool flat() const { return guides[0].flat() && guides[1].flat(); }
  /// Factor by which the chord may grow, or must shrink, to fit both bands.
  [[nodiscard]] double fit(const PathPoint& a, const PathPoint& b);

 private:
  /// Half of a chord with the gap of one guide, and what it may be.
  struct Half {
    const Vec3& start;
    const tool::Contact& from;
    const ChordProfile& profile;
    double inner, outer;
  };
  [[nodiscard]] bool aim(PathPoint& point, const Vec3& towards) const;
  [[nodiscard]] double ridge(std::size_t guide,
                             const Half& half,
                             const Vec3& end,
                             const tool::Contact& to);
};

/// Where on the path a check surface is met, from a bracket on the chord after `from`.
[[nodiscard]] std::optional<PathPoint> meet(Path& path,
                                            const PathPoint& from,
                                            const Segment& segment,
                                            const CheckWatch& watch,
                                            const CheckWatch::Hit& hit,
                                            double checkRest);

}  // namespace arelem::motion
