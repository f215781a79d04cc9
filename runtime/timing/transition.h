#pragma once

namespace arelem::timing {

/// What a machine can do along its path. Lengths in any one unit, time in seconds.
struct Limits {
  double velocity = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0;
};

/// A change of speed with limited jerk: acceleration rises from 0, stays, and falls to 0 again.
/// Symmetric in time, so that a fall is a rise run backwards. Source: Naseath, eqs. 4-2 to 4-11,
/// with the start of the falling part at v1 - a^2/(2 j).
class Transition {
 public:
  Transition() = default;
  /// From one speed to the other; either may be the larger.
  Transition(double from, double to, const Limits& limits);

  [[nodiscard]] double duration() const { return 2.0 * ramp_ + flat_; }
  [[nodiscard]] double distance() const { return 0.5 * (low_ + high_) * duration(); }
  [[nodiscard]] double peakAcceleration() const { return jerk_ * ramp_; }
  [[nodiscard]] bool hasFlat() const { return flat_ > 0.0; }

  struct State {
    double place, speed, acceleration;
  };
  /// t seconds after the start of the change.
  [[nodiscard]] State at(double t) const;
  /// When the place `x` from the start is passed.
  [[nodiscard]] double timeAt(double x) const;
  /// Where a speed is passed, from the start of the change; its end nearest to a speed outside.
  [[nodiscard]] double placeOf(double speed) const;

 private:
  [[nodiscard]] State rising(double t) const;
  [[nodiscard]] double risingTime(double x) const;

  double low_ = 0.0, high_ = 0.0;
  bool falls_ = false;
  double jerk_ = 0.0;
  double ramp_ = 0.0;  // time of each part with jerk
  double flat_ = 0.0;  // time at full acceleration
};

/// The distance of a change between two speeds.
[[nodiscard]] double changeDistance(double a, double b, const Limits& limits);

/// The largest speed, at most `most`, that can be reached from (or left for) `speed` within
/// `distance`.
[[nodiscard]] double reachable(double speed, double distance, double most, const Limits& limits);

/// The largest speed, at most `most`, to which one can rise between `a` and `b` that are `distance`
/// apart. At least the larger of both where their change fits.
[[nodiscard]] double peakBetween(
    double a, double b, double distance, double most, const Limits& limits);

}  // namespace arelem::timing
