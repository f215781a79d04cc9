#pragma once
#include <span>
#include <string>
#include <vector>

#include "runtime/spray/cost.h"
#include "runtime/spray/offset.h"
#include "runtime/spray/profile.h"

namespace arelem::spray {

/// A spray gun at its stand-off: what a GUN definition amounts to. Lengths in mm whatever UNITS
/// says.
struct Gun {
  enum class Kind : std::uint8_t { ellipse = 1, cone = 2, fan = 3, calibrated = 4, table = 5 };
  Kind kind = Kind::ellipse;
  Footprint footprint;
  double standOff = 0.0;    ///< from the nozzle to the work, mm; 0: not stated
  double flow = 0.0;        ///< largest nominal flow, mm3/s; 0: not stated
  double efficiency = 1.0;  ///< share of the paint that sticks
  double speed = 0.0;       ///< largest, mm/s; 0: not stated
  int output = 1;           ///< digital output that opens the gun
  double leadOn = 0.0;      ///< the gun is switched on that much earlier, s
  double leadOff = 0.0;     ///< and off, s
  double angle = 0.0;       ///< half angle of a cone or fan, radians; 0: of no angle
  /// A fan whose height was measured: height = heightAtZero + heightSlope times width. 0, 0: by its
  /// angle.
  double heightAtZero = 0.0;
  double heightSlope = 0.0;
  std::vector<std::pair<double, double>> table;  ///< deposition at places -1 ... 1

  [[nodiscard]] Profile profile() const;
  [[nodiscard]] GunLimits limits() const { return {speed, flow, efficiency}; }
  /// Along over across.
  [[nodiscard]] double aspect() const { return footprint.along / footprint.across; }
  /// Whether the footprint grows with the stand-off.
  [[nodiscard]] bool spreads() const { return angle > 0.0 || heightSlope > 0.0; }
  /// The stand-off that gives the footprint this half width, mm.
  [[nodiscard]] double standOffFor(double across) const;

  /// Canonical numbers: kind, along, across, stand-off, flow (l/min), efficiency, speed, output,
  /// lead on, lead off, half angle (degrees), c0, c1, then places and densities of a table.
  [[nodiscard]] std::vector<double> canon() const;
  [[nodiscard]] static Gun of(std::span<const double> canon);
};

/// Footprint radius of a cone of spray: r = d tan(half angle). Source: Sen 3.3, Bartlett (2.2).
[[nodiscard]] double coneRadius(double standOff, double halfAngle);

}  // namespace arelem::spray
