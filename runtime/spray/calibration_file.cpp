// The only file of this room that knows TOML.
#include <toml++/toml.h>

#include "ir/diag/spray.h"
#include "runtime/spray/calibration.h"

namespace arelem::spray {

namespace {
Failure wrong(std::string what) {
  return fail(diag::CalibrationFile, std::move(what));
}

Result<std::vector<double>> numbers(const toml::node_view<const toml::node>& node,
                                    const std::string& what) {
  const toml::array* array = node.as_array();
  if (array == nullptr) {
    return wrong(what + " is missing or no array");
  }
  std::vector<double> list;
  for (const toml::node& one : *array) {
    const std::optional<double> value = one.value<double>();
    if (!value) {
      return wrong(fmt::format("{} has something else than a number in line {}", what,
                               one.source().begin.line));
    }
    list.push_back(*value);
  }
  return list;
}

std::optional<Failure> read(const toml::table& file, const char* name, Grid& grid) {
  grid.name = name;
  const auto table = file[name];
  const std::string where = std::string("[") + name + "] ";
  for (const auto& [key, into] :
       {std::pair{"pressures", &grid.pressures}, {"valves", &grid.valves}}) {
    Result<std::vector<double>> list = numbers(table[key], where + key);
    if (!list) {
      return list.takeFailure();
    }
    *into = *std::move(list);
  }
  const toml::array* rows = table["values"].as_array();
  if (rows == nullptr) {
    return wrong(where + "values is missing or no array");
  }
  for (std::size_t i = 0; i < rows->size(); ++i) {
    Result<std::vector<double>> list =
        numbers(toml::node_view<const toml::node>(rows->get(i)), where + "values");
    if (!list) {
      return list.takeFailure();
    }
    grid.values.push_back(*std::move(list));
  }
  return objectionTo(grid);
}

Result<Calibration> read(const toml::table& file, std::string_view name) {
  Calibration gun;
  gun.name = name;
  for (Grid* grid : {&gun.flow, &gun.diameter}) {
    if (auto failure = read(file, grid == &gun.flow ? "flow" : "diameter", *grid)) {
      return *std::move(failure);
    }
  }
  gun.distance = file["diameter"]["distance"].value_or(0.0);
  if (!(gun.distance > 0.0)) {
    return wrong("[diameter] distance is missing or not above 0");
  }
  return gun;
}
}  // namespace

Result<Calibration> readCalibration(std::string_view text, std::string_view name) {
  // The library throws; nothing is thrown from one room to another.
  try {
    return read(toml::parse(text), name);
  } catch (const toml::parse_error& error) {
    return wrong(fmt::format("line {}: {}", error.source().begin.line, error.description()));
  }
}

}  // namespace arelem::spray
