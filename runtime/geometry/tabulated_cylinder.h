#pragma once
#include <vector>

#include "runtime/geometry/shapes.h"

namespace arelem::geometry {

/// A place of a plane curve with its first and second derivative by the curve parameter.
struct CurvePoint {
  Vec2 place = Vec2::Zero();
  Vec2 tangent = Vec2::UnitX();  ///< d place / du
  Vec2 second = Vec2::Zero();    ///< d2 place / du2
};

/// TABCYL: a plane curve swept along a direction. The curve lies in the (u, v) plane of `frame`; it
/// is a chain of cubics, each over its chord, with a straight interval before the first and behind
/// the last point.
///
/// Canonical form: n, k, m1..m9, then for each interval u v a b len max min, then the final u v.
///   n   number of intervals, the two straight ones included
///   k   number of values behind k (9 + 7 n + 2)
///   m   rows U, V, W of the frame: u = m1 x + m2 y + m3 z, ...; W is the generatrix
///   max, min  largest and smallest offset v of the interval, divided by len
struct TabulatedCylinder {
  /// The cubic over the chord from `start` to the start of the next interval (or `end`):
  /// offset v(t) = a t^3 + b t^2 + c t at distance t along the chord, 0 <= t <= length.
  struct Interval {
    Vec2 start = Vec2::Zero();
    Vec2 along = Vec2::UnitX();  ///< unit direction of the chord
    double length = 0.0;
    double a = 0.0, b = 0.0;
    double highest = 0.0, lowest = 0.0;  ///< extreme offsets over the chord, not divided; include 0
    bool extension = false;              ///< straight, before the first or behind the last point

    /// From v(length) = 0.
    [[nodiscard]] double c() const { return -length * (a * length + b); }
    [[nodiscard]] Vec2 across() const { return {-along.y(), along.x()}; }
    [[nodiscard]] double offset(double t) const { return ((a * t + b) * t + c()) * t; }
    [[nodiscard]] double slope(double t) const { return (3.0 * a * t + 2.0 * b) * t + c(); }
    [[nodiscard]] double bend(double t) const { return 6.0 * a * t + 2.0 * b; }
    /// Sets `highest` and `lowest` from the cubic.
    void bound();
    [[nodiscard]] CurvePoint at(double t) const;
  };

  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();  ///< rows U, V, W
  std::vector<Interval> intervals;
  Vec2 end = Vec2::Zero();

  /// The values must have passed the check of canonical input.
  [[nodiscard]] static TabulatedCylinder of(std::span<const double> canon);
  [[nodiscard]] Canon canon() const;

  [[nodiscard]] Vec3 generatrix() const { return frame.row(2).transpose(); }
  /// (u, v) of a place, and the place of (u, v) at height w along the generatrix.
  [[nodiscard]] Vec2 projected(const Vec3& place) const { return (frame * place).head<2>(); }
  [[nodiscard]] Vec3 inSpace(const Vec2& place, double w = 0.0) const {
    return frame.transpose() * Vec3(place.x(), place.y(), w);
  }
};

/// The number of canonical values of a TABCYL of n intervals.
[[nodiscard]] constexpr std::size_t tabulatedCylinderCount(std::size_t n) {
  return 13 + 7 * n;
}

/// The place of the curve nearest to `place`.
struct Nearest {
  std::size_t interval = 0;
  double t = 0.0;
  double distance = 0.0;
};
/// `withExtensions` also looks at the straight intervals. There is at least one interval to look
/// at.
[[nodiscard]] Nearest nearestOn(const TabulatedCylinder& surface,
                                const Vec2& place,
                                bool withExtensions = true);

}  // namespace arelem::geometry
