#include "backend/vplus/event.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ir/space/robot_tolerance.h"

namespace arelem::vplus {

namespace {
bool isSame(double a, double b) {
  return std::abs(a - b) <= tolerance::writtenSpeed;
}

/// "with DURATION 1000": the setting in the words of the language.
std::string settingText(Setting setting, double value) {
  const auto either = [&](std::string_view above, std::string_view below, std::string_view none) {
    return std::string(value > 0.0 ? above : value < 0.0 ? below : none);
  };
  switch (setting) {
    case Setting::toolSpeed:
      return value == 0.0 ? "no SPEED in mm/s" : fmt::format("SPEED {:.6g} MMPS", value);
    case Setting::percent:
      return value == 0.0 ? "no SPEED in percent" : fmt::format("SPEED {:.6g}", value);
    case Setting::rotation:
      return fmt::format("a rotational speed of {:.6g}", value);
    case Setting::monitor:
      return fmt::format("SPEED {:.6g} MONITOR", value);
    case Setting::profile:
      return fmt::format("profile {:.6g} of ACCEL", value);
    case Setting::acceleration:
      return fmt::format("ACCEL {:.6g}", value);
    case Setting::deceleration:
      return fmt::format("the second number of ACCEL {:.6g}", value);
    case Setting::duration:
      return fmt::format("DURATION {:.6g}", value);
    case Setting::coarse:
      return value == 0.0 ? std::string("neither COARSE nor FINE")
                          : fmt::format("{} {:.6g}", either("COARSE", "FINE", ""), std::abs(value));
    case Setting::nulling:
      return either("NULL", "", "NONULL");
    case Setting::blending:
      return either("CPON", "", "CPOFF");
    case Setting::arm:
      return either("RIGHTY", "LEFTY", "neither RIGHTY nor LEFTY");
    case Setting::elbow:
      return either("ABOVE", "BELOW", "neither ABOVE nor BELOW");
    case Setting::wrist:
      return either("FLIP", "NOFLIP", "neither FLIP nor NOFLIP");
  }
  return {};
}
}  // namespace

Manner usualManner() {
  constexpr double full = 100.0;
  Manner manner{};
  for (const Setting setting : {Setting::percent, Setting::rotation, Setting::monitor,
                                Setting::acceleration, Setting::deceleration}) {
    manner[static_cast<std::size_t>(setting)] = full;
  }
  manner[static_cast<std::size_t>(Setting::nulling)] = 1.0;
  manner[static_cast<std::size_t>(Setting::blending)] = 1.0;
  return manner;
}

void Settings::set(Setting setting, std::optional<double> value, bool always) {
  const auto i = static_cast<std::size_t>(setting);
  next_[i] = value.value_or(std::nan(""));
  always_[i] = always ? next_[i] : always_[i];
}

double Settings::at(Setting setting) const {
  return next_[static_cast<std::size_t>(setting)];
}

Manner Settings::take() {
  return std::exchange(next_, always_);
}

std::string shown(const Event& event) {
  return event.numbers.empty()
             ? event.what
             : fmt::format("{} {:.6g}", event.what, fmt::join(event.numbers, ", "));
}

std::optional<EventDifference> difference(const Event& found, const Event& wanted) {
  if (found.what != wanted.what ||
      !std::equal(found.numbers.begin(), found.numbers.end(), wanted.numbers.begin(),
                  wanted.numbers.end(), isSame)) {
    return EventDifference{shown(found), shown(wanted)};
  }
  for (std::size_t i = 0; found.manner && wanted.manner && i < settings; ++i) {
    const double have = (*found.manner)[i];
    const double need = (*wanted.manner)[i];
    if (!isSame(have, need)) {
      const auto setting = static_cast<Setting>(i);
      return EventDifference{fmt::format("{} with {}", shown(found), settingText(setting, have)),
                             settingText(setting, need)};
    }
  }
  return std::nullopt;
}

}  // namespace arelem::vplus
