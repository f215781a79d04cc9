#pragma once
#include <optional>

#include "ir/diag/result.h"
#include "runtime/geometry/directed_distance.h"

namespace arelem::geometry {

/// A curve of a ruled surface: the section of a surface by the plane through two end points and a
/// direction. Its place at fraction f lies `heading` away from the base line: base(f) + s heading.
struct SectionCurve {
  Entity surface;  ///< a degenerate curve is a POINT; then only `start` counts
  Vec3 start = Vec3::Zero(), finish = Vec3::Zero();
  Vec3 heading = Vec3::UnitZ();  ///< unit, across the chord, towards the wanted part of the surface

  [[nodiscard]] bool isPoint() const { return surface.type == EntityType::point; }
  [[nodiscard]] Vec3 base(double fraction) const { return start + fraction * (finish - start); }
  /// The crossing ahead along `heading`, else the nearest behind. None where the line misses the
  /// surface.
  [[nodiscard]] std::optional<Vec3> at(double fraction) const;
  /// d at / d fraction, of the surface's tangent plane. None where the heading is tangent to the
  /// surface.
  [[nodiscard]] std::optional<Vec3> derivative(const Vec3& place) const;
};

/// A place of a ruled surface with its partial derivatives: f along the curves, g from the first to
/// the second.
struct RuledPoint {
  Vec3 place = Vec3::Zero();
  Vec3 byF = Vec3::Zero(), byG = Vec3::Zero(), byFG = Vec3::Zero();
};

/// RLDSRF: rulings join the places of equal fractions f of the base lines, S = (1-g) C1(f) + g
/// C2(f). f and g may leave [0, 1] as far as the subsurfaces reach.
///
/// Canonical form: sub-forms one after another, each as type code, number of values, values:
/// surface, point, point, vector and then the same four of the second curve or one point.
struct RuledSurface {
  SectionCurve first, second;

  /// The values must have been written by `canon` or passed the check of canonical input.
  [[nodiscard]] static RuledSurface of(std::span<const double> canon);
  [[nodiscard]] Canon canon() const;
  /// None where one of the curves has no place at `f`.
  [[nodiscard]] std::optional<RuledPoint> at(double f, double g) const;
  /// The unit normal byF x byG. None where it vanishes.
  [[nodiscard]] std::optional<Vec3> normal(double f, double g) const;
};

/// One sub-form of a canonical RLDSRF; none at the end or where the numbers are no sub-form. Moves
/// `next` behind it.
struct SubForm {
  EntityType type = EntityType::point;
  Canon canon;
};
[[nodiscard]] std::optional<SubForm> readSubForm(std::span<const double> canon, std::size_t& next);

}  // namespace arelem::geometry
