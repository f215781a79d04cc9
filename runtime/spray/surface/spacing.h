#pragma once
#include <vector>

#include "runtime/spray/surface/section_planes.h"

namespace arelem::spray {

/// How far apart the lines of a surface lie, place by place, as a share of where they lie farthest
/// apart. The gun moves faster where they are closer, so that the film stays the same.
class Spacing {
 public:
  virtual ~Spacing() = default;
  /// In (0, 1]; at least `nearest`. 1 within rounding where the lines are parallel.
  [[nodiscard]] virtual double share(std::size_t line, const LinePoint& point) const = 0;

  static constexpr double nearest = 1.0 / 3.0;
};

/// Lines of u or of v: the neighbor's nearest place is looked for from the same parameter on.
class LineSpacing : public Spacing {
 public:
  /// `lines` must outlive it. `step`: how far apart the lines were laid; chords may seem farther.
  LineSpacing(const std::vector<SurfaceLine>& lines, double step);
  [[nodiscard]] double share(std::size_t line, const LinePoint& point) const override;

 private:
  [[nodiscard]] double distance(std::size_t line, const LinePoint& point) const;

  const std::vector<SurfaceLine>& lines_;
  double widest_ = 0.0;
};

/// Sections by planes: as much as the surface leans there against the planes.
class SectionSpacing : public Spacing {
 public:
  /// `sections` must outlive it.
  explicit SectionSpacing(const SectionPlanes& sections) : sections_(sections) {}
  [[nodiscard]] double share(std::size_t line, const LinePoint& point) const override;

 private:
  const SectionPlanes& sections_;
};

[[nodiscard]] LinePoint middleOf(const LinePoint& a, const LinePoint& b);

/// A stretch of a line in pieces over which the spacing changes by a tenth at most.
[[nodiscard]] SurfaceLine divided(const Spacing& spacing,
                                  std::size_t line,
                                  const LinePoint& from,
                                  const LinePoint& to);

}  // namespace arelem::spray
