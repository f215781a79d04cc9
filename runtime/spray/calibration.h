#pragma once
#include <string>
#include <vector>

#include "ir/diag/result.h"

namespace arelem::spray {

/// A measured quantity over tank pressure (kPa, columns) and valve position (degrees, rows), both
/// rising.
struct Grid {
  std::string name;  ///< for messages: "flow", "diameter"
  std::vector<double> pressures;
  std::vector<double> valves;
  std::vector<std::vector<double>> values;  ///< a row a valve position
};

/// Bilinear between the measured places; outside of them E0354 names the range. The source fits
/// straight lines, but its own dialog values do not follow from its tables by any of them
/// (formulas 4), so what was measured is interpolated.
[[nodiscard]] Result<double> interpolated(const Grid& grid, double pressure, double valve);

/// Why a grid cannot be used: sizes that do not agree, places that do not rise.
[[nodiscard]] std::optional<Failure> objectionTo(const Grid& grid);

/// A gun as it was measured (Sen appendix B).
struct Calibration {
  std::string name;
  Grid flow;      ///< ml/min
  Grid diameter;  ///< of the pattern, mm, at `distance`
  double distance = 0.0;
};
/// What a setting of the gun gives.
struct Setting {
  double flow = 0.0;       ///< mm3/s
  double halfAngle = 0.0;  ///< of the cone, radians
};
[[nodiscard]] Result<Setting> settingOf(const Calibration& gun, double pressure, double valve);

/// Reads a gun's TOML text: `[flow]` and `[diameter]` with pressures, valves, values, and the
/// `distance` of the diameters. Errors: E0355 with line and what is wrong.
[[nodiscard]] Result<Calibration> readCalibration(std::string_view text, std::string_view name);

}  // namespace arelem::spray
