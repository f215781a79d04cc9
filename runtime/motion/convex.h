#pragma once
#include <optional>
#include <vector>

#include "ir/diag/result.h"
#include "ir/space/vector.h"

namespace arelem::motion {

/// A convex polygon in space, and what is left of it when its sides move inwards.
class ConvexPolygon {
 public:
  /// Errors: coinciding corners, three in a line, corners out of one plane, a corner of more than
  /// 180 degrees inside.
  [[nodiscard]] static Result<ConvexPolygon> make(std::vector<Vec3> corners);

  [[nodiscard]] const std::vector<Vec3>& corners() const { return corners_; }
  /// Sides turn counter-clockwise about it.
  [[nodiscard]] const Vec3& normal() const { return normal_; }

  /// The polygon whose sides are `distance` further in; sides that vanish are left out. The first
  /// corner belongs to the first one of this polygon. None where nothing is left.
  [[nodiscard]] std::optional<std::vector<Vec3>> inset(double distance) const;
  /// What is at least `distance` from walls on the sides that stand along `up` (unit, not along the
  /// polygon). None where nothing is.
  [[nodiscard]] std::optional<ConvexPolygon> between(double distance, const Vec3& up) const;

 private:
  [[nodiscard]] std::optional<std::vector<Vec3>> clipped(double distance, const Vec3& up) const;

  std::vector<Vec3> corners_;
  Vec3 normal_ = Vec3::UnitZ();
};

/// The least sine of half an inner angle.
[[nodiscard]] double sharpestSine(const std::vector<Vec3>& corners);

/// Whether all corners are within `distance` of the line of one of the sides.
[[nodiscard]] bool isNarrow(const std::vector<Vec3>& corners, double distance);

/// The side from which all corners are within `distance`, by the number of its first corner.
[[nodiscard]] std::optional<std::size_t> coveringSide(const std::vector<Vec3>& corners,
                                                      double distance);

/// How far a place of its plane is outside of a convex polygon whose sides turn counter-clockwise
/// about `normal`; 0 inside.
[[nodiscard]] double outside(const std::vector<Vec3>& corners,
                             const Vec3& normal,
                             const Vec3& place);

}  // namespace arelem::motion
