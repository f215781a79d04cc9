#pragma once
#include <cstddef>
#include <vector>

#include "runtime/motion/facets/section.h"

namespace arelem::motion {

/// The part of a section in which the tool end keeps its tolerance: between two lines of straight
/// pieces, each given by its corners with s ascending. It is built from one end while it is used.
class Tunnel {
 public:
  /// What is seen straight ahead.
  struct Reach {
    SectionPoint end;   ///< the farthest place
    double from = 0.0;  ///< on the ray to it, from this s on, the path may bend and see no less
    int edge = 0;       ///< 1: the ray ends at the top, -1: at the bottom, 0: where the tunnel ends
  };

  void clear();
  void addBottom(const SectionPoint& corner) { bottom_.push_back(corner); }
  void addTop(const SectionPoint& corner) { top_.push_back(corner); }
  /// The last corner of the top may turn out lower.
  void lowerTop(double z);
  [[nodiscard]] bool empty() const { return bottom_.empty() || top_.empty(); }
  [[nodiscard]] double begin() const { return bottom_.front().s; }
  [[nodiscard]] double end() const { return bottom_.back().s; }

  /// The farthest place that a straight way from `eye`, a place inside, reaches.
  [[nodiscard]] Reach farthest(const SectionPoint& eye) const;
  /// Heights of both lines at `s`, between begin and end.
  [[nodiscard]] double bottomAt(double s) const;
  [[nodiscard]] double topAt(double s) const;
  /// What lies before `s` is not looked at any more.
  void forget(double s);

 private:
  std::vector<SectionPoint> bottom_, top_;
};

}  // namespace arelem::motion
