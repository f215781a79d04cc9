#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "ir/space/tolerance.h"
#include "runtime/tool/profile.h"

/// The parts of a cutter that proofs speak of.
namespace arelem::certify {

/// A piece of the half-profile turned about the axis, thickened by a ball. It is the straight line
/// from a to b, or, with a radius, the arc about a from angle `low` to `high`, counted from
/// straight below a outwards.
struct Piece {
  tool::ProfilePoint a, b;
  double ball = 0.0;
  double radius = 0.0, low = 0.0, high = 0.0;

  [[nodiscard]] double length() const {
    return radius > 0.0 ? radius * (high - low) : std::hypot(b.rho - a.rho, b.z - a.z);
  }
  [[nodiscard]] tool::ProfilePoint at(double share) const {
    const double angle = low + share * (high - low);
    return radius > 0.0
               ? tool::ProfilePoint{a.rho + radius * std::sin(angle),
                                    a.z - radius * std::cos(angle)}
               : tool::ProfilePoint{a.rho + share * (b.rho - a.rho), a.z + share * (b.z - a.z)};
  }
  /// Largest distance from the axis, and from the tool end.
  [[nodiscard]] double widest() const { return std::max(a.rho, b.rho) + radius; }
  [[nodiscard]] double reach() const {
    return std::max(std::hypot(a.rho, a.z), std::hypot(b.rho, b.z)) + radius;
  }
  /// Least of x rho + y z over the part with shares in [from, to].
  [[nodiscard]] double least(double x, double y, double from, double to) const;
};

/// The pieces whose union covers all cutting points of a profile.
[[nodiscard]] std::vector<Piece> piecesOf(const tool::Profile& cutter);

/// The unit direction square to a unit axis to which a vector of the size of one leans from it; any
/// where what is left of it may be rounding, which leans along the axis too.
[[nodiscard]] inline Vec3 squareTo(const Vec3& axis, const Vec3& v) {
  Vec3 across = v - v.dot(axis) * axis;
  if (across.norm() <= tolerance::symmetric) {
    return axis.unitOrthogonal();
  }
  across.normalize();
  return (across - across.dot(axis) * axis).normalized();
}

/// An angle by what proofs ask of it.
struct Turn {
  double radians = 0.0, cosine = 1.0, sine = 0.0;

  /// Of an angle of at most pi.
  [[nodiscard]] Turn half() const {
    const double halved = std::sqrt(0.5 * (1.0 + cosine));
    // The sine of a small angle must keep its figures.
    return {0.5 * radians, halved,
            halved > 0.5 ? 0.5 * sine / halved : std::sqrt(0.5 * (1.0 - cosine))};
  }
  [[nodiscard]] Turn plus(const Turn& b, double sign) const {
    return {radians + sign * b.radians, cosine * b.cosine - sign * sine * b.sine,
            sine * b.cosine + sign * cosine * b.sine};
  }
};

/// Least over |x| <= half, half <= pi, of first (1 - cos x) + second sin x.
[[nodiscard]] double leastOfTurn(double first, double second, const Turn& half);

}  // namespace arelem::certify
