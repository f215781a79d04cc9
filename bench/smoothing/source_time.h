#pragma once
// The machining time as the source simulates it: Naseath, section 4.5 and eqs. 4-2 to 4-11. Written
// for the tests and the tables alone, from its formulas.
#include <algorithm>
#include <cmath>
#include <vector>

#include "runtime/spline/cubic.h"
#include "runtime/timing/transition.h"

namespace arelem::smooth::source {

inline constexpr timing::Limits machine{400.0, 4000.0, 20000.0};

inline double changeTime(double a, double b) {
  const double change = std::abs(b - a);
  const double full = machine.acceleration / machine.jerk;
  return change <= machine.acceleration * full ? 2.0 * std::sqrt(change / machine.jerk)
                                               : change / machine.acceleration + full;
}

inline double changeLength(double a, double b) {
  return 0.5 * (a + b) * changeTime(a, b);
}

/// The speed up to `most` that is reached from another one within a length, by bisection.
inline double reached(double from, double length, double most) {
  if (most <= from || changeLength(from, most) <= length) {
    return most;
  }
  double low = from;
  double high = most;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (changeLength(from, middle) <= length ? low : high) = middle;
  }
  return low;
}

struct Place {
  double along, speed;
};

/// Speeds that the curvature allows, at samples of each knot interval.
inline std::vector<Place> allowedSpeeds(const spline::CubicSpline& curve, int perSpan) {
  std::vector<Place> places;
  double along = 0.0;
  Vec3 last = curve.at(curve.begin());
  for (std::size_t span = 0; span < curve.spans(); ++span) {
    const spline::Bezier piece = curve.piece(span);
    for (int i = span == 0 ? 0 : 1; i <= perSpan; ++i) {
      const double t = piece.begin + (piece.end - piece.begin) * i / perSpan;
      const Vec3 at = piece.at(t);
      along += (at - last).norm();
      last = at;
      const double k = curve.derivatives(t).first.squaredNorm() > 0.0 ? curve.curvature(t) : 0.0;
      const double most = k > 0.0 ? std::sqrt(machine.acceleration / k) : machine.velocity;
      places.push_back({along, std::min(machine.velocity, most)});
    }
  }
  return places;
}

/// Changes of speed between the local extremes of the allowed speed, lowered where they cannot be
/// reached; the rest of each piece at its higher speed. Starts and ends at full speed.
inline double machiningTime(const spline::CubicSpline& curve, int perSpan) {
  const std::vector<Place> all = allowedSpeeds(curve, perSpan);
  std::vector<Place> extremes{{0.0, machine.velocity}};
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {
    const double before = all[i].speed - all[i - 1].speed;
    const double after = all[i + 1].speed - all[i].speed;
    if (before * after < 0.0 || ((before == 0.0) != (after == 0.0))) {
      extremes.push_back(all[i]);
    }
  }
  extremes.push_back({all.back().along, machine.velocity});
  for (std::size_t i = 1; i < extremes.size(); ++i) {
    const Place& a = extremes[i - 1];
    Place& b = extremes[i];
    b.speed = std::min(b.speed, reached(a.speed, b.along - a.along, b.speed));
  }
  for (std::size_t i = extremes.size() - 1; i-- > 0;) {
    const Place& b = extremes[i + 1];
    Place& a = extremes[i];
    a.speed = std::min(a.speed, reached(b.speed, b.along - a.along, a.speed));
  }
  double time = 0.0;
  for (std::size_t i = 1; i < extremes.size(); ++i) {
    const double a = extremes[i - 1].speed;
    const double b = extremes[i].speed;
    const double rest = extremes[i].along - extremes[i - 1].along - changeLength(a, b);
    time += changeTime(a, b) + std::max(rest, 0.0) / std::max(a, b);
  }
  return time;
}

}  // namespace arelem::smooth::source
