#pragma once
#include <optional>
#include <span>
#include <vector>

#include "ir/diag/result.h"
#include "ir/geometry/entity.h"
#include "runtime/spline/bezier.h"

/// Path splines: what a tool follows instead of cut vectors. Lengths are in the part unit.
namespace arelem::spline {

/// A cubic B-spline in space with continuous curvature: simple knots, and either Bezier ends (the
/// first and last knot count four times, the curve begins and ends in its end points) or closed
/// (knots and control points go round).
///
/// m control points need m - 2 distinct knots when open and m + 1 when closed, where the last one
/// ends the period. Source: Naseath, section 2.3, in Sederberg's notation with one more knot at
/// each end.
class CubicSpline {
 public:
  /// Errors: fewer than 4 control points, a wrong number of knots, knots that do not rise, values
  /// that are not finite.
  [[nodiscard]] static Result<CubicSpline> make(std::vector<Vec3> control,
                                                std::vector<double> knots,
                                                bool closed);
  /// The same with knots 0, 1, 2, ...
  [[nodiscard]] static Result<CubicSpline> uniform(std::vector<Vec3> control, bool closed);

  [[nodiscard]] bool closed() const { return closed_; }
  [[nodiscard]] const std::vector<Vec3>& control() const { return control_; }
  /// The distinct knots.
  [[nodiscard]] std::span<const double> knots() const {
    return std::span(full_).subspan(3, full_.size() - 6);
  }
  [[nodiscard]] std::size_t spans() const { return full_.size() - 7; }
  [[nodiscard]] double begin() const { return full_[3]; }
  [[nodiscard]] double end() const { return full_[full_.size() - 4]; }

  struct Derivatives {
    Vec3 point, first, second, third;
  };
  /// Parameters outside are moved to the nearest end (open) or into the period (closed).
  [[nodiscard]] Vec3 at(double t) const;
  [[nodiscard]] Derivatives derivatives(double t) const;
  /// |p' x p''| / |p'|^3, per part unit; 0 at a cusp where p' is null.
  [[nodiscard]] double curvature(double t) const;

  [[nodiscard]] Bezier piece(std::size_t span) const;
  [[nodiscard]] std::vector<Bezier> pieces() const;
  [[nodiscard]] double length() const;

  /// The same curve with one knot more (Boehm). A knot that is there already, or lies outside, is
  /// refused.
  [[nodiscard]] Result<CubicSpline> withKnot(double t) const;
  /// The same curve with a knot more in the middle of every span.
  [[nodiscard]] CubicSpline refined() const;
  /// The same, in the middle of the spans that are marked.
  [[nodiscard]] CubicSpline refined(const std::vector<bool>& marked) const;
  /// The same knots with other control points.
  [[nodiscard]] CubicSpline withControl(std::vector<Vec3> control) const;

  /// The four control points of a span, and the matrix rows that make its Bezier points of them:
  /// piece(span).control[r] = sum of weights[r][i] * control()[index(span, i)].
  using Weights = std::array<std::array<double, 4>, 4>;
  [[nodiscard]] Weights pieceWeights(std::size_t span) const;
  [[nodiscard]] std::size_t index(std::size_t span, std::size_t i) const {
    const std::size_t k = span + i;
    return k < control_.size() ? k : k - control_.size();
  }
  /// Where the i-th control point acts: the mean of the three knots in its middle (Greville).
  [[nodiscard]] double place(std::size_t i) const;

  struct Nearest {
    double t = 0.0;
    Vec3 point = Vec3::Zero();
    double distance = 0.0;
  };
  /// The point next to `p`: no other is nearer by more than 1e-9 of the size of the curve.
  [[nodiscard]] Nearest nearest(const Vec3& p) const;

  /// The parameter of the foot of the perpendicular from `p`, looked for from `from` on and never
  /// behind it: for the places of a path that runs along the curve.
  [[nodiscard]] double footAhead(const Vec3& p, double from) const;
  /// The span of a parameter inside the curve.
  [[nodiscard]] std::size_t spanOf(double t) const;

  /// Canonical numbers of a BSPLIN: closed (0 or 1), m, the distinct knots, x y z of each control
  /// point.
  [[nodiscard]] std::vector<double> canon() const;
  [[nodiscard]] static Result<CubicSpline> of(std::span<const double> canon);

 private:
  [[nodiscard]] double inside(double t) const;
  [[nodiscard]] Nearest polished(Nearest best, const Vec3& p) const;

  bool closed_ = false;
  std::vector<Vec3> control_;
  std::vector<double> full_;  // spans + 7 knots: three more on each side of the distinct ones
};

/// The first parameter at which the curve stops to lead back: where its derivative is 0, or so
/// small that doubles cannot tell. None for a curve that a tool can follow without a stop.
[[nodiscard]] std::optional<double> cuspOf(const CubicSpline& curve);

/// The points of a path that runs along the curve with every chord within `tolerance` of it, both
/// ends included. Certified by the hulls of the pieces.
[[nodiscard]] std::vector<Vec3> chordPoints(const CubicSpline& curve, double tolerance);

/// Upper bound of the distance between two curves of the same knots at equal parameters, by the
/// Bezier points of their difference, each piece halved `halvings` times. Never too small.
[[nodiscard]] double deviationBound(const CubicSpline& a, const CubicSpline& b, int halvings);

struct CurvatureFigures {
  double most = 0.0;
  double mean = 0.0;  ///< over the length
};
/// Sampled `perSpan` times a knot interval, ends included.
[[nodiscard]] CurvatureFigures curvatureFigures(const CubicSpline& curve, int perSpan);

}  // namespace arelem::spline
