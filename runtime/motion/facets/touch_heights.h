#pragma once
#include <optional>
#include <span>

#include "runtime/motion/facets/section_triangles.h"

namespace arelem::motion {

/// The height at which the cutter touches one triangle, so that the gap is the task's low.
///
/// What a convex cutter touches of a triangle makes a convex body of tool ends; its upper border in
/// the section is a concave function of s, below its tangents and above its chords.
struct TouchHeight {
  std::uint32_t index = 0;  ///< of the triangle in the list
  double z = 0.0;
  SectionTriangles::Tangent tangent;  ///< of the gap there
  double top = 0.0;                   ///< not above where the gap is the task's high
  bool hasTop = false;

  [[nodiscard]] double slope() const { return -tangent.byS / tangent.byZ; }
  /// Where the tangent has the gap `low`.
  [[nodiscard]] double tangentHeight(double s, double low) const {
    return (low - tangent.base - tangent.byS * s) / tangent.byZ;
  }
};

/// One place of the way: the highest of all such heights, and some others that are known there.
class TouchNode {
 public:
  double s = 0.0;

  [[nodiscard]] const TouchHeight& highest() const { return known_[best_]; }
  [[nodiscard]] SectionPoint point() const { return {s, highest().z}; }
  [[nodiscard]] TouchHeight* of(std::uint32_t index);
  /// The highest is kept, others as far as there is room.
  const TouchHeight& add(const TouchHeight& height);

 private:
  std::array<TouchHeight, 6> known_;
  std::size_t count_ = 0, best_ = 0;
};

/// Finds heights of touch by Newton steps on the gaps, which from above do not go too far as gaps
/// are convex.
class TouchHeights {
 public:
  /// Heights are found to a gap of `rest`.
  TouchHeights(SectionTriangles& triangles, double rest) : list_(triangles), rest_(rest) {}

  /// None where the triangle is not touched at s, or the way is too steep there.
  [[nodiscard]] std::optional<TouchHeight> height(std::uint32_t index, const SectionPoint& guess);
  /// The highest of the triangles listed.
  [[nodiscard]] std::optional<TouchNode> node(const SectionPoint& guess,
                                              std::span<const std::uint32_t> among);
  /// The height of one triangle at a node, if it is not below the node's by more than `below`.
  [[nodiscard]] std::optional<TouchHeight> nearTop(TouchNode& node,
                                                   std::uint32_t index,
                                                   double below);
  /// Finds the top of a height.
  [[nodiscard]] double top(double s, TouchHeight& height);

 private:
  [[nodiscard]] std::optional<TouchHeight> likely(const SectionPoint& guess,
                                                  std::span<const std::uint32_t> among);
  [[nodiscard]] std::optional<TouchHeight> nearest(const SectionPoint& guess,
                                                   std::span<const std::uint32_t> among);

  SectionTriangles& list_;
  double rest_;
};

}  // namespace arelem::motion
