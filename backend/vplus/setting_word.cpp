#include <cmath>

#include <fmt/format.h>

#include "backend/vplus/instruction.h"
#include "ir/space/robot_tolerance.h"

namespace arelem::vplus {

bool Instructions::settingWord(const std::string& word) {
  if (word == "SPEED") {
    scope_.next();
    setSpeed();
  } else if (word == "ACCEL") {
    scope_.next();
    setAcceleration();
  } else if (word == "DURATION") {
    scope_.next();
    const std::optional<double> seconds = time();
    settings_.set(Setting::duration, seconds, scope_.take("ALWAYS"));
  } else if (word == "TOOL" || word == "BASE") {
    scope_.next();
    word == "TOOL" ? setTool() : setBase();
  } else if (word == "ENABLE" || word == "DISABLE") {
    scope_.next();
    event(word + " " + scope_.word());
    scope_.anyWord("a switch");
  } else if (word == "PARAMETER") {
    scope_.next();
    event("PARAMETER " + scope_.word());
    scope_.anyWord("a parameter");
    scope_.sign("=");
    scope_.expression();
  } else {
    return blendingWord(word) || armWord(word);
  }
  return true;
}

bool Instructions::blendingWord(const std::string& word) {
  constexpr double usual = 100.0;
  if (word == "COARSE" || word == "FINE") {
    scope_.next();
    const bool given = !scope_.atEnd() && scope_.word() != "ALWAYS";
    const std::optional<double> percent = given ? positive("the percentage") : usual;
    const std::optional<double> kept = word == "FINE" && percent ? -*percent : percent;
    settings_.set(Setting::coarse, kept, scope_.take("ALWAYS"));
  } else if (word == "NULL" || word == "NONULL") {
    scope_.next();
    settings_.set(Setting::nulling, word == "NULL" ? 1.0 : 0.0, scope_.take("ALWAYS"));
  } else if (word == "CPON" || word == "CPOFF") {
    scope_.next();
    settings_.set(Setting::blending, word == "CPON" ? 1.0 : 0.0, scope_.take("ALWAYS"));
  } else {
    return false;
  }
  return true;
}

bool Instructions::armWord(const std::string& word) {
  const auto stand = [&](Setting setting, double side) {
    scope_.next();
    settings_.set(setting, side, true);
    return true;
  };
  if (word == "LEFTY" || word == "RIGHTY") {
    return stand(Setting::arm, word == "RIGHTY" ? 1.0 : -1.0);
  }
  if (word == "ABOVE" || word == "BELOW") {
    return stand(Setting::elbow, word == "ABOVE" ? 1.0 : -1.0);
  }
  if (word == "FLIP" || word == "NOFLIP") {
    return stand(Setting::wrist, word == "FLIP" ? 1.0 : -1.0);
  }
  return false;
}

std::optional<double> Instructions::positive(const char* name) {
  const std::size_t column = scope_.column();
  const std::optional<double> value = scope_.expression();
  if (value && !(*value > 0.0)) {
    scope_.wrongAt(column, fmt::format("{} is {:g}; it is above 0", name, *value));
  }
  return value;
}

void Instructions::setAcceleration() {
  std::optional<double> profile = 0.0;
  if (scope_.takeSign("(")) {
    const std::size_t column = scope_.column();
    profile = scope_.expression();
    constexpr double mostProfile = 8.0;
    if (profile && !(*profile >= 0.0 && *profile <= mostProfile)) {
      scope_.wrongAt(
          column, fmt::format("the profile is {:g}; there are 0 to {:g}", *profile, mostProfile));
    }
    scope_.sign(")");
  }
  settings_.set(Setting::profile, profile, true);
  settings_.set(Setting::acceleration, positive("the acceleration"), true);
  scope_.sign(",");
  settings_.set(Setting::deceleration, positive("the deceleration"), true);
}

void Instructions::setSpeed() {
  const std::optional<double> value = positive("the speed");
  std::optional<std::optional<double>> rotation;
  if (scope_.takeSign(",")) {
    rotation = positive("the rotational speed");
  }
  constexpr double inch = 25.4;
  const bool millimeters = scope_.take("MMPS");
  const bool inches = !millimeters && scope_.take("IPS");
  const bool monitor = !millimeters && !inches && scope_.take("MONITOR");
  const bool always = scope_.take("ALWAYS");
  if (monitor) {
    return settings_.set(Setting::monitor, value, true);
  }
  if (rotation) {
    settings_.set(Setting::rotation, *rotation, always);
  }
  const bool ofTool = millimeters || inches;
  const std::optional<double> speed = value && inches ? *value * inch : value;
  settings_.set(Setting::toolSpeed, ofTool ? speed : 0.0, always);
  settings_.set(Setting::percent, ofTool ? 0.0 : value, always);
}

void Instructions::setTool() {
  const Place tool = scope_.atEnd() ? Place{} : scope_.location();
  if (!tool.known) {
    return stray("the text does not tell this tool");
  }
  const bool other =
      !program_.toolShift || !isSame({*program_.toolShift, program_.toolTurn, true}, tool);
  if (other && !program_.moves.empty()) {
    stray("the tool changes between two moves");
  }
  program_.toolShift = tool.shift;
  program_.toolTurn = tool.turn;
}

void Instructions::setBase() {
  const std::size_t column = scope_.column();
  for (std::size_t i = 0; !scope_.error() && (i == 0 || scope_.takeSign(",")); ++i) {
    if (i == program_.base.size()) {
      return scope_.wrongAt(column, fmt::format("BASE takes {} values", program_.base.size()));
    }
    const bool given = !scope_.isSign(",") && !scope_.atEnd();
    const std::optional<double> value = given ? scope_.expression() : 0.0;
    if (!value) {
      return stray("the text does not tell where this base lies");
    }
    if (program_.base[i] != *value && !program_.moves.empty()) {
      stray("the base moves between two moves");
    }
    program_.base[i] = *value;
  }
}

}  // namespace arelem::vplus
