#pragma once
#include "runtime/motion/facets/facet_stride.h"
#include "runtime/motion/kept_share.h"

namespace arelem::motion {

/// Chooses cut vectors along a path: as long as both bands allow.
class Stride {
 public:
  /// `longest` is MAXDP; it does not bind where both surfaces are planes.
  Stride(Path& path, double longest) : path_(path), longest_(longest), facets_(path) {}
  Stride(const Stride&) = delete;  ///< it points into itself
  Stride& operator=(const Stride&) = delete;

  /// The end of the next cut vector from `a`, not farther than `cap`; it stays until the next call.
  /// Null where the path ends or has a corner; a cut vector towards a corner ends in it.
  [[nodiscard]] const PathPoint* next(const PathPoint& a, double cap);
  /// Takes the curvatures of a finished cut vector as those of the next.
  void learn(const PathPoint& a, const PathPoint& b);

 private:
  [[nodiscard]] bool nextAlongCurves(const PathPoint& a, double cap);
  [[nodiscard]] bool longestAlongCurves(const PathPoint& a, double cap);
  [[nodiscard]] bool takeBest(const PathPoint& a, bool triedMore);
  [[nodiscard]] std::optional<PathPoint> nextAlongMesh(const PathPoint& a, double cap);
  [[nodiscard]] std::optional<PathPoint> nextAlongFacets(const PathPoint& a, double cap);
  /// How far from the gap aimed at a cut vector may end.
  [[nodiscard]] double accepted() const;
  [[nodiscard]] double planned(const PathPoint& a);
  [[nodiscard]] std::array<double, 2> aimedGaps(const PathPoint& a, double length) const;
  [[nodiscard]] static double plannedBy(Guide& guide, double from);
  struct Trials;
  void shorten(Trials& t, double factor, double cap, const PathPoint& a, const PathPoint& b);
  [[nodiscard]] double behindRidge(const PathPoint& a) const;
  [[nodiscard]] std::array<double, 2> slopes(std::size_t role,
                                             const PathPoint& a,
                                             const PathPoint& b,
                                             double length) const;
  bool turnAims();
  bool learnTurn(const PathPoint& a, const PathPoint& b);
  bool learnSwerve();
  bool learnCurvature(std::size_t role, const PathPoint& a, const PathPoint& b);

  Path& path_;
  double longest_;
  FacetStride facets_;
  KeptShare keptShare_;
  double usual_ = 0.0;  ///< length of the last cut vector along facets
  /// Ends of cut vectors: the one that is tried, and the best so far. They change places.
  std::array<PathPoint, 2> ends_;
  PathPoint* trial_ = &ends_[0];
  PathPoint* best_ = &ends_[1];
  Path::Middle middle_;  ///< of the best, where longer ones were tried
};

}  // namespace arelem::motion
