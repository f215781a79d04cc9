#include "runtime/timing/transition.h"

#include <algorithm>
#include <cmath>

#include "ir/space/smooth_tolerance.h"

namespace arelem::timing {

namespace {

constexpr int mostTurns = 60;

/// The largest value in [low, high] where the rising `excess` is not positive, by false position
/// (Illinois). excess(low) is at most 0.
template <class Excess>
double largestWithin(double low, double high, Excess excess) {
  double atHigh = excess(high);
  if (atHigh <= 0.0) {
    return high;
  }
  double atLow = excess(low);
  for (int i = 0; i < mostTurns && high - low > tolerance::transitionEnough * high; ++i) {
    double middle = low + (high - low) * (-atLow / (atHigh - atLow));
    if (!(middle > low && middle < high) || i % 4 == 3) {
      middle = 0.5 * (low + high);
    }
    const double value = excess(middle);
    if (value <= 0.0) {
      low = middle;
      atLow = value;
      atHigh *= 0.5;
    } else {
      high = middle;
      atHigh = value;
      atLow *= 0.5;
    }
  }
  return low;
}

}  // namespace

Transition::Transition(double from, double to, const Limits& limits)
    : low_(std::min(from, to)), high_(std::max(from, to)), falls_(to < from), jerk_(limits.jerk) {
  const double change = high_ - low_;
  const double full = limits.acceleration / limits.jerk;
  if (change <= limits.acceleration * full) {
    ramp_ = std::sqrt(change / limits.jerk);
  } else {
    ramp_ = full;
    flat_ = change / limits.acceleration - full;
  }
}

Transition::State Transition::rising(double t) const {
  const double j = jerk_;
  if (t <= ramp_) {
    return {t * (low_ + j * t * t / 6.0), low_ + 0.5 * j * t * t, j * t};
  }
  const double speed = low_ + 0.5 * j * ramp_ * ramp_;
  const double place = ramp_ * (low_ + j * ramp_ * ramp_ / 6.0);
  const double a = j * ramp_;
  if (t <= ramp_ + flat_) {
    const double s = t - ramp_;
    return {place + s * (speed + 0.5 * a * s), speed + a * s, a};
  }
  const double rest = std::max(duration() - t, 0.0);
  return {distance() - rest * (high_ - j * rest * rest / 6.0), high_ - 0.5 * j * rest * rest,
          j * rest};
}

Transition::State Transition::at(double t) const {
  if (!falls_) {
    return rising(t);
  }
  const State back = rising(duration() - t);
  return {distance() - back.place, back.speed, -back.acceleration};
}

/// Newton's method on the place, which rises with the time, inside a bracket that shrinks.
double Transition::risingTime(double x) const {
  double low = 0.0;
  double high = duration();
  double t = distance() > 0.0 ? high * std::sqrt(std::clamp(x / distance(), 0.0, 1.0)) : 0.0;
  for (int i = 0; i < mostTurns; ++i) {
    const State s = rising(t);
    const double miss = s.place - x;
    (miss > 0.0 ? high : low) = t;
    double next = s.speed > 0.0 ? t - miss / s.speed : 0.5 * (low + high);
    if (!(next >= low && next <= high)) {
      next = 0.5 * (low + high);
    }
    if (std::abs(next - t) <= tolerance::transitionEnough * duration()) {
      return next;
    }
    t = next;
  }
  return t;
}

double Transition::timeAt(double x) const {
  return falls_ ? duration() - risingTime(distance() - x) : risingTime(x);
}

double Transition::placeOf(double speed) const {
  const double v = std::clamp(speed, low_, high_);
  const double a = jerk_ * ramp_;
  const double flatFrom = low_ + 0.5 * a * ramp_;
  const double flatTo = high_ - 0.5 * a * ramp_;
  const double t = v < flatFrom ? std::sqrt(2.0 * (v - low_) / jerk_)
                   : v > flatTo ? duration() - std::sqrt(2.0 * (high_ - v) / jerk_)
                   : a > 0.0    ? ramp_ + (v - flatFrom) / a
                                : 0.0;
  const double place = rising(t).place;
  return falls_ ? distance() - place : place;
}

double changeDistance(double a, double b, const Limits& limits) {
  return Transition(a, b, limits).distance();
}

double reachable(double speed, double distance, double most, const Limits& limits) {
  if (most <= speed) {
    return most;
  }
  return largestWithin(speed, most,
                       [&](double v) { return changeDistance(speed, v, limits) - distance; });
}

double peakBetween(double a, double b, double distance, double most, const Limits& limits) {
  const double low = std::max(a, b);
  if (most <= low) {
    return low;
  }
  return largestWithin(low, most, [&](double v) {
    return changeDistance(a, v, limits) + changeDistance(v, b, limits) - distance;
  });
}

}  // namespace arelem::timing
