#pragma once
#include <vector>

#include "runtime/spray/surface/surface_lines.h"

namespace arelem::spray {

/// How far apart the lines of a surface lie, place by place, as a share of where they lie farthest
/// apart. The gun moves faster where they are closer, so that the film stays the same. Lines of u
/// or of v: the neighbor's nearest place is looked for from the same parameter on.
class Spacing {
 public:
  explicit Spacing(const std::vector<SurfaceLine>& lines);

  /// In (0, 1]; at least `nearest`. 1 within rounding where the lines are parallel.
  [[nodiscard]] double share(std::size_t line, const LinePoint& point) const;

  static constexpr double nearest = 1.0 / 3.0;

 private:
  [[nodiscard]] double distance(std::size_t line, const LinePoint& point) const;

  const std::vector<SurfaceLine>& lines_;
  double widest_ = 0.0;
};

[[nodiscard]] LinePoint middleOf(const LinePoint& a, const LinePoint& b);

/// A stretch of a line in pieces over which the spacing changes by a tenth at most.
[[nodiscard]] SurfaceLine divided(const Spacing& spacing,
                                  std::size_t line,
                                  const LinePoint& from,
                                  const LinePoint& to);

}  // namespace arelem::spray
