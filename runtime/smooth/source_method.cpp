// The algorithm of Naseath, chapter 3, with the corrections of its formulas and one guard: his
// deviation is sampled and lets the curve leave the tube by up to 4 %; here the result is
// certified.
#include <algorithm>
#include <cmath>

#include "runtime/smooth/polygon.h"
#include "runtime/smooth/smooth.h"

namespace arelem::smooth {

namespace {

using spline::CubicSpline;

/// Nothing moves any more: largest move as a share of the tolerance.
constexpr double stillness = 1e-9;

/// Parameters where the control points act, eqs. 3-33 to 3-37.
std::vector<double> actingPlaces(const CubicSpline& curve) {
  const auto knots = curve.knots();
  const std::size_t n = knots.size();
  const std::size_t m = curve.control().size();
  std::vector<double> places(m);
  for (std::size_t i = 0; i < m; ++i) {
    places[i] =
        curve.closed() ? knots[(i + n - 2) % (n - 1)] : knots[std::clamp<std::size_t>(i, 1, n) - 1];
  }
  if (!curve.closed()) {
    places[1] = 0.5 * (knots[0] + knots[1]);
    places[m - 2] = 0.5 * (knots[n - 2] + knots[n - 1]);
    places[m - 1] = knots[n - 1];
  }
  return places;
}

class Iteration {
 public:
  Iteration(const CubicSpline& curve, const Options& options)
      : original_(curve), options_(options), places_(actingPlaces(curve)) {}

  Smoothed run() {
    const double radius = options_.tolerance;
    std::vector<Vec3> control = original_.control();
    std::vector<double> equal(control.size(), radius);
    std::vector<double> sensitivity = measured(control, step(control, equal), equal);
    double left = radius;
    int turns = 0;
    while (turns < options_.mostIterations && !interrupted()) {
      ++turns;
      const std::vector<double> distance = moves(sensitivity, left);
      std::vector<Vec3> next = step(control, distance);
      sensitivity = measured(control, next, distance);
      left = radius - sampledDeviation(next);
      if (left < 0.0) {
        break;  // the polygon before stays
      }
      const double most = largestMove(control, next);
      control = std::move(next);
      if (left <= options_.accuracy * radius || most < stillness * radius) {
        break;
      }
    }
    Smoothed result = guarded(original_, original_.withControl(std::move(control)), radius);
    result.iterations = turns;
    return result;
  }

 private:
  [[nodiscard]] bool interrupted() const {
    return options_.interrupted != nullptr && options_.interrupted->load(std::memory_order_relaxed);
  }

  [[nodiscard]] std::vector<Vec3> step(const std::vector<Vec3>& control,
                                       const std::vector<double>& distance) const {
    const bool closed = original_.closed();
    const std::vector<Vec3> way =
        directions(control, original_.control(), categories(control, closed), closed);
    std::vector<Vec3> next = control;
    for (std::size_t i = 0; i < next.size(); ++i) {
      next[i] += distance[i] * way[i];
    }
    return next;
  }

  /// Change of the curve where a control point acts, for its move.
  [[nodiscard]] std::vector<double> measured(const std::vector<Vec3>& before,
                                             const std::vector<Vec3>& after,
                                             const std::vector<double>& distance) const {
    std::vector<Vec3> difference(before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      difference[i] = after[i] - before[i];
    }
    const CubicSpline change = original_.withControl(std::move(difference));
    std::vector<double> sensitivity(before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      sensitivity[i] = change.at(places_[i]).norm() / distance[i];
    }
    return sensitivity;
  }

  [[nodiscard]] double sampledDeviation(const std::vector<Vec3>& control) const {
    std::vector<Vec3> difference(control.size());
    for (std::size_t i = 0; i < control.size(); ++i) {
      difference[i] = control[i] - original_.control()[i];
    }
    const CubicSpline gap = original_.withControl(std::move(difference));
    double most = 0.0;
    for (std::size_t span = 0; span < gap.spans(); ++span) {
      const spline::Bezier piece = gap.piece(span);
      for (int i = 0; i <= options_.precision; ++i) {
        const double t =
            piece.begin + (piece.end - piece.begin) * static_cast<double>(i) / options_.precision;
        most = std::max(most, piece.at(t).norm());
      }
    }
    return most;
  }

  static double largestMove(const std::vector<Vec3>& before, const std::vector<Vec3>& after) {
    double most = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      most = std::max(most, (after[i] - before[i]).norm());
    }
    return most;
  }

  const CubicSpline& original_;
  const Options& options_;
  std::vector<double> places_;
};

}  // namespace

Smoothed sourceMethod(const spline::CubicSpline& curve, const Options& options) {
  return Iteration(curve, options).run();
}

}  // namespace arelem::smooth
