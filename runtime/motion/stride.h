#pragma once
#include "runtime/motion/path.h"

namespace arelem::motion {

/// Chooses cut vectors along a path: as long as both bands allow.
class Stride {
 public:
  /// `longest` is MAXDP; it does not bind where both surfaces are planes.
  Stride(Path& path, double longest) : path_(path), longest_(longest) {}

  /// The end of the next cut vector from `a`, not farther than `cap`. None where the path ends or
  /// has a corner; a cut vector towards a corner ends in it.
  [[nodiscard]] std::optional<PathPoint> next(const PathPoint& a, double cap);
  /// Where `next` found none: aims at another pair of edges of the bands. False after all pairs.
  bool tryOtherEdges();
  /// Behind a corner nothing is known of the curvatures.
  void forget();
  /// Takes the curvatures of a finished cut vector as those of the next.
  void learn(const PathPoint& a, const PathPoint& b);

 private:
  [[nodiscard]] double planned(const PathPoint& a) const;
  bool learnTurn(const PathPoint& a, const PathPoint& b);

  Path& path_;
  double longest_;
  std::size_t edges_ = 0;  ///< pairs of edges tried without success
};

}  // namespace arelem::motion
