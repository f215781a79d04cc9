#include "backend/vplus/instruction.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "backend/vplus/name.h"

namespace arelem::vplus {

namespace {
constexpr std::size_t deepestBlock = 64;
}  // namespace

void Instructions::one(std::size_t line) {
  line_ = line;
  const std::string word = scope_.word();
  if (word == "MOVE" || word == "MOVES") {
    scope_.next();
    return move(word == "MOVES");
  }
  if (motionWord(word) || settingWord(word) || blockWord(word) || outputWord(word)) {
    return;
  }
  assignment(word);
}

void Instructions::move(bool straight) {
  const Place place = scope_.location();
  if (place.known && !scope_.error()) {
    Move made;
    made.pose = robot::poseOf(place.shift, place.turn);
    lean(made.pose);
    made.line = line_;
    made.straight = straight;
    made.speed = speed_;
    program_.moves.push_back(made);
  }
}

/// The tilt axis leans the tool along its side.
void Instructions::lean(robot::Pose& pose) const {
  if (tilt_ == nullptr || tiltDegrees_ == 0.0) {
    return;
  }
  const Vec3 across = pose.axis.cross(*pose.side);
  const Eigen::AngleAxisd turn(tiltDegrees_ * std::numbers::pi / 180.0, across);
  pose.axis = turn * pose.axis;
  pose.side = turn * *pose.side;
}

bool Instructions::motionWord(const std::string& word) {
  if (word == "APPRO" || word == "APPROS") {
    scope_.next();
    scope_.location();
    scope_.sign(",");
    scope_.expression();
  } else if (word == "DEPART" || word == "DEPARTS") {
    scope_.next();
    scope_.expression();
  } else if (word == "DELAY") {
    scope_.next();
    time();
  } else if (word == "BREAK" || word == "RETURN" || word == "PAUSE" || word == "STOP" ||
             word == "LEFTY" || word == "RIGHTY" || word == "ABOVE" || word == "BELOW" ||
             word == "FLIP" || word == "NOFLIP") {
    scope_.next();
  } else {
    return false;
  }
  return true;
}

bool Instructions::settingWord(const std::string& word) {
  if (word == "SPEED") {
    scope_.next();
    setSpeed();
  } else if (word == "ACCEL") {
    scope_.next();
    if (scope_.takeSign("(")) {
      scope_.expression();
      scope_.sign(")");
    }
    scope_.expression();
    scope_.sign(",");
    scope_.expression();
  } else if (word == "DURATION") {
    scope_.next();
    time();
    scope_.take("ALWAYS");
  } else if (word == "COARSE" || word == "FINE" || word == "NULL" || word == "NONULL" ||
             word == "CPON" || word == "CPOFF") {
    scope_.next();
    if ((word == "COARSE" || word == "FINE") && !scope_.atEnd() && scope_.word() != "ALWAYS") {
      scope_.expression();
    }
    scope_.take("ALWAYS");
  } else if (word == "TOOL" || word == "BASE") {
    scope_.next();
    if (word == "TOOL" && !scope_.atEnd()) {
      scope_.location();
    } else if (word == "BASE" && !scope_.atEnd()) {
      const std::size_t column = scope_.column();
      constexpr std::size_t most = 4;  // dx, dy, dz and a turn about z
      if (scope_.list() > most) {
        scope_.wrongAt(column, fmt::format("BASE takes {} values", most));
      }
    }
  } else if (word == "ENABLE" || word == "DISABLE") {
    scope_.next();
    scope_.anyWord("a switch");
  } else if (word == "PARAMETER") {
    scope_.next();
    scope_.anyWord("a parameter");
    scope_.sign("=");
    scope_.expression();
  } else {
    return false;
  }
  return true;
}

void Instructions::time() {
  const std::size_t column = scope_.column();
  const std::optional<double> seconds = scope_.expression();
  if (seconds && *seconds < 0.0) {
    scope_.wrongAt(column, fmt::format("the time is {:g}; it is 0 or more", *seconds));
  }
}

void Instructions::setSpeed() {
  const std::size_t column = scope_.column();
  const std::optional<double> value = scope_.expression();
  if (scope_.takeSign(",")) {
    scope_.expression();
  }
  const bool millimeters = scope_.take("MMPS");
  const bool inches = !millimeters && scope_.take("IPS");
  const bool monitor = !millimeters && !inches && scope_.take("MONITOR");
  scope_.take("ALWAYS");
  if (value && !(*value > 0.0)) {
    return scope_.wrongAt(column, fmt::format("the speed is {:g}; it is above 0", *value));
  }
  if (!monitor) {
    constexpr double inch = 25.4;
    speed_ = value && millimeters ? *value : value && inches ? *value * inch : 0.0;
  }
}

bool Instructions::outputWord(const std::string& word) {
  if (word == "SIGNAL") {
    scope_.next();
    do {
      signal();
    } while (!scope_.error() && scope_.takeSign(","));
  } else if (word == "BITS") {
    scope_.next();
    bits();
  } else if (word == "TYPE") {
    scope_.next();
    scope_.items();
  } else {
    return false;
  }
  return true;
}

void Instructions::signal() {
  const std::size_t column = scope_.column();
  const std::optional<double> value = scope_.expression();
  if (!value) {
    return;
  }
  const auto output = static_cast<int>(std::lround(std::abs(*value)));
  const bool exists = (output >= 1 && output <= 512) || (output >= 2001 && output <= 2512) ||
                      (output >= 3001 && output <= 4999);
  if (!exists) {
    return scope_.wrongAt(column,
                          fmt::format("there is no output {}; there are 1 to 512, 2001 to 2512 "
                                      "and 3001 to 4999",
                                      output));
  }
  program_.signals.push_back({program_.moves.size(), output, *value > 0.0});
}

void Instructions::bits() {
  const std::optional<double> first = scope_.expression();
  std::optional<double> count = 1.0;
  if (scope_.takeSign(",")) {
    count = scope_.expression();
  }
  scope_.sign("=");
  const std::optional<double> value = scope_.expression();
  constexpr double bitsOfTilt = 8.0;
  if (tilt_ != nullptr && first && value && *first == tilt_->firstOutput && count == bitsOfTilt) {
    tiltDegrees_ = robot::tiltAngle(*tilt_, static_cast<int>(std::lround(*value)));
  }
}

bool Instructions::blockWord(const std::string& word) {
  if (word == "IF" || word == "WHILE") {
    open(word);
    scope_.expression();
    scope_.require(word == "IF" ? "THEN" : "DO");
  } else if (word == "FOR") {
    open(word);
    scope_.setReal(scope_.name("a variable"), std::nullopt);
    scope_.sign("=");
    scope_.expression();
    scope_.require("TO");
    scope_.expression();
    if (scope_.take("STEP")) {
      scope_.expression();
    }
  } else if (word == "ELSE") {
    scope_.next();
    if (blocks_.empty() || !blocks_.back().starts_with("IF")) {
      scope_.wrongAt(1, "ELSE outside IF");
    } else if (blocks_.back() != "IF") {
      scope_.wrongAt(1, "a second ELSE");
    } else {
      blocks_.back() = "IF and ELSE";
    }
  } else if (word == "END") {
    scope_.next();
    if (blocks_.empty()) {
      scope_.wrongAt(1, "END without IF, FOR or WHILE");
    } else {
      blocks_.pop_back();
    }
  } else if (word == "CALL") {
    program_.straightLine = false;
    scope_.next();
    scope_.name("the name of a program");
    scope_.sign("(");
    if (!scope_.isSign(")")) {
      scope_.items();
    }
    scope_.sign(")");
  } else {
    return false;
  }
  return true;
}

void Instructions::open(const std::string& word) {
  program_.straightLine = false;
  scope_.next();
  blocks_.push_back(word);
  if (blocks_.size() > deepestBlock) {
    scope_.wrongAt(1, fmt::format("more than {} blocks in each other", deepestBlock));
  }
}

void Instructions::assignment(const std::string& word) {
  if (word == "SET") {
    scope_.next();
    const std::string name = scope_.name("the name of a location");
    scope_.sign("=");
    const Place place = scope_.location();
    // The frame that the program sets first carries its coordinates: poses are seen from it.
    const bool first = frames_++ == 0;
    return scope_.setLocation(
        name, first ? Place{Vec3::Zero(), robot::Matrix3::Identity(), true} : place);
  }
  if (word.empty() || isKeyword(word)) {
    return scope_.wrong("an instruction");
  }
  const std::string name = scope_.name("an instruction");
  scope_.sign("=");
  scope_.setReal(name, scope_.expression());
}

}  // namespace arelem::vplus
