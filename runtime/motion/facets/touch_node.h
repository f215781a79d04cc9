#pragma once
#include <array>

#include "runtime/motion/facets/facet_task.h"

namespace arelem::motion {

/// The height at which the cutter touches one triangle, so that the gap is the task's low.
///
/// What a convex cutter touches of a triangle makes a convex body of tool ends; its upper border in
/// the section is a concave function of s, below its tangents and above its chords.
struct TouchHeight {
  std::uint32_t index = 0;  ///< of the triangle in the list
  double z = 0.0;
  Tangent tangent;   ///< of the gap there
  double top = 0.0;  ///< not above where the gap is the task's high
  bool hasTop = false;

  /// Steeper ways are looked at from another side.
  static constexpr double steepest = 3.0;
  static constexpr double leastRise = 0.25;

  [[nodiscard]] bool isSteep() const {
    return tangent.byZ < leastRise || std::abs(tangent.byS) > steepest * tangent.byZ;
  }
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
  /// Only the highest is left, by another number in another list.
  void renumber(std::uint32_t index);

 private:
  std::array<TouchHeight, 6> known_;
  std::size_t count_ = 0, best_ = 0;
};

}  // namespace arelem::motion
