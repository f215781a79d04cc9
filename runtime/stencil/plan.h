#pragma once
#include <functional>
#include <span>

#include "ir/space/vector.h"
#include "runtime/stencil/cell.h"
#include "runtime/stencil/message.h"

namespace arelem::stencil {

/// Everything in mm, mm/s, s and degrees.

/// What of a spray gun with a flat fan counts here.
struct FanGun {
  double fan = 63.5;  ///< full angle
  /// Measured height = heightAtZero + heightSlope times width; a slope of 0: by the fan's angle.
  double heightAtZero = 0.0;
  double heightSlope = 0.0;
  double speed = 0.0;       ///< largest; 0: any
  double leadOn = 0.0;      ///< the gun is switched on that much before its first line
  double leadOff = 0.0;     ///< and off that much before its last
  double flow = 0.0;        ///< nominal, mm3/s; 0: not stated
  double efficiency = 1.0;  ///< share of the paint that sticks
};
[[nodiscard]] double heightOf(const FanGun& gun, double width);

enum class TiltRule : std::uint8_t {
  off,
  trapezoid,      ///< halves each cell as if its sides were parallel (Blank 2.5.1)
  quadrilateral,  ///< halves each cell as it is (2.5.2)
  best            ///< makes the film of each cell as even as it can be
};
struct TiltLimits {
  double most = 25.4;   ///< of the axis that Blank's end effector has
  double rate = 120.0;  ///< deg/s: 600 steps of 0.2 degrees
};

struct Job {
  FanGun gun;
  TiltRule tilt = TiltRule::off;
  TiltLimits limits;
  /// Paint constant: speed times width, mm2/s. Speed is inversely proportional to width (2.6).
  double speedTimesWidth = 0.0;
  /// Speeds as the source has them: those of the line that a move begins at, not of its cell.
  bool asSource = false;
};

/// One place of the gun. `speed` is that of the move to the next pose.
struct Pose {
  Line line;                  ///< on the ground
  double yaw = 0.0;           ///< of the line, without jumps of more than half a turn along a run
  double tilt = 0.0;          ///< positive towards the second end of the line
  double height = 0.0;        ///< of the nozzle over the ground
  Vec2 place = Vec2::Zero();  ///< of the nozzle
  double speed = 0.0;
};

/// A run as the gun goes it. Between `on` and `off` it sprays.
struct Track {
  std::string symbol;
  std::size_t position = 0;  ///< of the symbol in the text, from 0
  std::size_t stroke = 0;
  std::vector<Pose> poses;
  std::size_t on = 0;     ///< index of the pose at which the gun is switched on
  std::size_t off = 0;    ///< and off
  std::size_t first = 0;  ///< index of the pose over the first line of the stroke, behind a run-up
};

/// The tilt of each line of a run: what the cells beside it want, held to the limits. No tilt is
/// above `limits.most` or turns faster than `limits.rate` in the seconds given for each cell;
/// within that it departs from the wanted one as little as possible.
[[nodiscard]] std::vector<double> tiltsOf(const std::vector<Line>& lines,
                                          TiltRule rule,
                                          double fan,
                                          const TiltLimits& limits,
                                          const std::vector<double>& seconds);

/// The tilts within the same limits for which the worst film of all cells departs least from the
/// mean: the least such departure within a grid of 0.8 degrees, found by halving.
[[nodiscard]] std::vector<double> evenestTilts(const std::vector<Line>& lines,
                                               double fan,
                                               const TiltLimits& limits,
                                               const std::vector<double>& seconds);

/// Plans one run, at whatever speeds it takes. Error: E0742, the gun would be switched off before
/// it is switched on.
[[nodiscard]] Result<Track> planRun(const Run& run, const Job& job);
/// Whether all moves keep the gun's largest speed. Error: E0562, the fastest of them, and the
/// factor on SPEED that would do for all: not above `mostFactor()`, which is asked for where a
/// slower gun tilts otherwise.
[[nodiscard]] std::optional<Failure> objectionToSpeeds(std::span<const Track> tracks,
                                                       const Job& job,
                                                       const std::function<double()>& mostFactor);

/// Film of tracks: mean film of each cell over the mean of all, strips within the cell, and how
/// the paint of its two halves divides the area.
struct Evenness {
  Spread film;               ///< strips over the mean film
  double leastShare = 50.0;  ///< percent of a cell's area that half of its paint falls on
  double mostShare = 50.0;
  double withinTenPercent = 1.0;  ///< share of the area
  double area = 0.0;
  std::size_t cells = 0;
};
[[nodiscard]] Evenness evennessOf(std::span<const Track> tracks, const FanGun& gun);

}  // namespace arelem::stencil
