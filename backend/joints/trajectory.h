#pragma once
#include <vector>

#include "backend/joints/knot.h"

namespace arelem::joints {

/// x, y, z in mm, heading and tilt in degrees.
using Place = Eigen::Matrix<double, 5, 1>;

/// The tool at one time, with its first and second derivative by time.
struct State {
  Place place = Place::Zero();
  Place speed = Place::Zero();
  Place acceleration = Place::Zero();
  bool gun = false;
};

/// How the tool goes through its knots in time: straight from one to the next, at the speed of each
/// move as far as one acceleration along the path allows it (looking ahead), at rest where it must
/// stop. A weighted mean of that over a window of time follows, with weights that rise to the
/// middle of the window and fall again: the mean over half of it, twice. Accelerations become
/// continuous, corners are rounded by at most acceleration window^2 / 24, and where the tool stops,
/// for a window, it stands exactly at its knot. The speed of a corner is held so that it turns with
/// that acceleration.
class Trajectory {
 public:
  /// Acceleration in mm/s2, window in s.
  Trajectory(const std::vector<Knot>& knots, double acceleration, double window);

  /// How long the gun is open, and how long it would be at the speeds of the knots; the move that
  /// is slowed down most while it is.
  struct Spraying {
    double open = 0.0;     ///< s
    double planned = 0.0;  ///< s
    double worst = 1.0;    ///< time of a move over its planned time
    std::size_t knot = 0;  ///< that it begins at
  };
  [[nodiscard]] const Spraying& spraying() const { return spraying_; }
  [[nodiscard]] double duration() const { return raw_ + window_; }
  /// `time` from 0 to the duration.
  [[nodiscard]] State at(double time) const;
  /// The number of the knot that the tool leaves or left last at a time.
  [[nodiscard]] std::size_t knotAt(double time) const;

 private:
  /// A stretch of constant acceleration.
  struct Phase {
    double start = 0.0;
    Place from = Place::Zero();
    Place direction = Place::Zero();  // for one mm of path
    double speed = 0.0;
    double acceleration = 0.0;
    bool gun = false;
    std::size_t knot = 0;

    [[nodiscard]] Place placeAt(double t) const;
    [[nodiscard]] Place speedAt(double t) const;
  };
  void keepSpraying(const std::vector<Knot>& knots);
  void stand(const Place& place, double seconds, bool gun, std::size_t knot);
  void add(Phase phase, double seconds);
  [[nodiscard]] const Phase& phaseAt(double t) const;
  /// Before the mean is taken: at rest in front of the path and behind it.
  [[nodiscard]] Place rawPlace(double t) const;
  [[nodiscard]] Place rawSpeed(double t) const;
  /// The next time behind `t` at which another phase begins.
  [[nodiscard]] double nextBreak(double t) const;
  template <class Quantity>
  [[nodiscard]] Place mean(double time, const Quantity& of) const;

  std::vector<Phase> phases_;
  Spraying spraying_;
  double raw_ = 0.0;
  double window_ = 0.0;
};

}  // namespace arelem::joints
