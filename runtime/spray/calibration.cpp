#include "runtime/spray/calibration.h"

#include <algorithm>
#include <cmath>

#include "ir/diag/spray.h"
#include "runtime/spray/units.h"

namespace arelem::spray {

namespace {
bool rises(const std::vector<double>& places) {
  return std::adjacent_find(places.begin(), places.end(), std::greater_equal<>()) == places.end();
}

/// Index of the lower neighbor and the share of the upper one.
std::pair<std::size_t, double> between(const std::vector<double>& places, double x) {
  if (places.size() == 1) {
    return {0, 0.0};
  }
  const auto above = std::upper_bound(places.begin() + 1, places.end() - 1, x);
  const auto i = static_cast<std::size_t>(above - places.begin()) - 1;
  return {i, (x - places[i]) / (places[i + 1] - places[i])};
}

std::optional<Failure> outside(const Grid& grid,
                               std::string_view what,
                               std::string_view unit,
                               double value,
                               const std::vector<double>& places) {
  if (value >= places.front() && value <= places.back()) {
    return std::nullopt;
  }
  return fail(diag::OutsideCalibration, what, value, unit, grid.name, places.front(),
              places.back());
}
}  // namespace

std::optional<Failure> objectionTo(const Grid& grid) {
  const auto wrong = [&grid](std::string what) {
    return fail(diag::CalibrationFile, fmt::format("[{}] {}", grid.name, what));
  };
  if (grid.pressures.empty() || grid.valves.empty()) {
    return wrong("has no pressures or no valves");
  }
  if (!rises(grid.pressures) || !rises(grid.valves)) {
    return wrong("has pressures or valves that do not rise");
  }
  if (grid.values.size() != grid.valves.size()) {
    return wrong(fmt::format("has {} rows of values for {} valve positions", grid.values.size(),
                             grid.valves.size()));
  }
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    if (grid.values[i].size() != grid.pressures.size()) {
      return wrong(fmt::format("has {} values in row {} for {} pressures", grid.values[i].size(),
                               i + 1, grid.pressures.size()));
    }
    if (std::any_of(grid.values[i].begin(), grid.values[i].end(),
                    [](double v) { return !(v > 0.0) || !std::isfinite(v); })) {
      return wrong(fmt::format("has a value in row {} that is not above 0", i + 1));
    }
  }
  return std::nullopt;
}

Result<double> interpolated(const Grid& grid, double pressure, double valve) {
  if (auto failure = outside(grid, "pressure", "kPa", pressure, grid.pressures)) {
    return *std::move(failure);
  }
  if (auto failure = outside(grid, "valve position", "degrees", valve, grid.valves)) {
    return *std::move(failure);
  }
  const auto [column, x] = between(grid.pressures, pressure);
  const auto [row, y] = between(grid.valves, valve);
  const std::size_t nextColumn = std::min(column + 1, grid.pressures.size() - 1);
  const std::size_t nextRow = std::min(row + 1, grid.valves.size() - 1);
  const double low =
      grid.values[row][column] + x * (grid.values[row][nextColumn] - grid.values[row][column]);
  const double high = grid.values[nextRow][column] +
                      x * (grid.values[nextRow][nextColumn] - grid.values[nextRow][column]);
  return low + y * (high - low);
}

Result<Setting> settingOf(const Calibration& gun, double pressure, double valve) {
  Result<double> flow = interpolated(gun.flow, pressure, valve);
  if (!flow) {
    return flow.takeFailure();
  }
  Result<double> diameter = interpolated(gun.diameter, pressure, valve);
  if (!diameter) {
    return diameter.takeFailure();
  }
  return Setting{*flow * milliliterPerMinute, std::atan(*diameter / (2.0 * gun.distance))};
}

}  // namespace arelem::spray
