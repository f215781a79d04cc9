#include "backend/vplus/instruction.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "backend/vplus/name.h"
#include "ir/space/robot_tolerance.h"

namespace arelem::vplus {

namespace {
constexpr std::size_t deepestBlock = 64;

/// Whether both are one place, but for the rounding of sums.
bool isSame(const Place& a, const Place& b) {
  return a.known && b.known && (a.shift - b.shift).norm() < tolerance::writtenPlace &&
         (a.turn - b.turn).norm() < tolerance::writtenPlace;
}
}  // namespace

bool isOutput(double number) {
  return (number >= 1.0 && number <= 512.0) || (number >= 2001.0 && number <= 2512.0) ||
         (number >= 3001.0 && number <= 4999.0);
}

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

void Instructions::stray(std::string what) {
  program_.strays.push_back({line_, std::move(what)});
}

void Instructions::move(bool straight) {
  const Place place = scope_.location();
  underWay_.reset();
  if (scope_.error()) {
    return;
  }
  if (!place.known || (frame_ && !frame_->known)) {
    over_.reset();
    return stray("the text does not tell where this move goes");
  }
  if (over_ && !isSame(*over_, place)) {
    stray(fmt::format("the approach of line {} is to another place than this move", overLine_));
  }
  over_.reset();
  const Place base = frame_.value_or(Place{});
  const robot::Matrix3 back = base.turn.transpose();
  Move made;
  underWay_ = robot::poseOf(back * (place.shift - base.shift), back * place.turn);
  made.pose = leaning(*underWay_);
  made.line = line_;
  made.straight = straight;
  made.speed = nextSpeed_.value_or(speed_);
  nextSpeed_.reset();
  program_.moves.push_back(made);
}

/// Over a place: the move to it is to follow.
void Instructions::approach() {
  finish();
  nextSpeed_.reset();
  underWay_.reset();
  over_ = scope_.location();
  overLine_ = line_;
  scope_.sign(",");
  const std::optional<double> away = scope_.expression();
  if (!over_->known || !away || *away < 0.0) {
    stray("the text does not tell where this approach goes, or it goes beyond its place");
  }
}

void Instructions::depart() {
  finish();
  nextSpeed_.reset();
  underWay_.reset();
  const std::optional<double> away = scope_.expression();
  if (!away || *away < 0.0) {
    stray("the text does not tell how far this departs, or it departs to the work");
  }
}

void Instructions::finish() {
  if (over_) {
    program_.strays.push_back({overLine_, "no move follows this approach"});
  }
  over_.reset();
}

/// The tilt axis leans the tool along its side.
robot::Pose Instructions::leaning(robot::Pose pose) const {
  if (tilt_ == nullptr || tiltDegrees_ == 0.0) {
    return pose;
  }
  const Vec3 across = pose.axis.cross(*pose.side);
  const Eigen::AngleAxisd turn(tiltDegrees_ * std::numbers::pi / 180.0, across);
  pose.axis = turn * pose.axis;
  pose.side = turn * *pose.side;
  return pose;
}

bool Instructions::motionWord(const std::string& word) {
  if (word == "APPRO" || word == "APPROS") {
    scope_.next();
    approach();
  } else if (word == "DEPART" || word == "DEPARTS") {
    scope_.next();
    depart();
  } else if (word == "DELAY") {
    scope_.next();
    delay();
  } else if (word == "BREAK" || word == "RETURN" || word == "PAUSE" || word == "STOP" ||
             word == "LEFTY" || word == "RIGHTY" || word == "ABOVE" || word == "BELOW" ||
             word == "FLIP" || word == "NOFLIP") {
    scope_.next();
    if (word == "BREAK") {
      underWay_.reset();
    }
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
    word == "TOOL" ? setTool() : setBase();
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

std::optional<double> Instructions::time() {
  const std::size_t column = scope_.column();
  const std::optional<double> seconds = scope_.expression();
  if (seconds && *seconds < 0.0) {
    scope_.wrongAt(column, fmt::format("the time is {:g}; it is 0 or more", *seconds));
  }
  return seconds;
}

void Instructions::delay() {
  const std::optional<double> seconds = time();
  if (!seconds) {
    return stray("the text does not tell how long the robot waits");
  }
  if (!program_.moves.empty()) {
    program_.moves.back().wait += *seconds;
  }
  underWay_.reset();
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

void Instructions::setSpeed() {
  const std::size_t column = scope_.column();
  const std::optional<double> value = scope_.expression();
  if (scope_.takeSign(",")) {
    scope_.expression();
  }
  const bool millimeters = scope_.take("MMPS");
  const bool inches = !millimeters && scope_.take("IPS");
  const bool monitor = !millimeters && !inches && scope_.take("MONITOR");
  const bool always = scope_.take("ALWAYS");
  if (value && !(*value > 0.0)) {
    return scope_.wrongAt(column, fmt::format("the speed is {:g}; it is above 0", *value));
  }
  if (!monitor) {
    constexpr double inch = 25.4;
    const double speed = value && millimeters ? *value : value && inches ? *value * inch : 0.0;
    always ? void(speed_ = speed) : void(nextSpeed_ = speed);
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
  if (!isOutput(output)) {
    return scope_.wrongAt(column,
                          fmt::format("there is no output {}; there are 1 to 512, 2001 to 2512 "
                                      "and 3001 to 4999",
                                      output));
  }
  const std::size_t underWay = underWay_ && !program_.moves.empty() ? 1 : 0;
  program_.signals.push_back({program_.moves.size() - underWay, output, *value > 0.0});
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
    // A move that has begun ends with it: the next one waits for that, BITS do not.
    if (underWay_ && !program_.moves.empty()) {
      program_.moves.back().pose = leaning(*underWay_);
    }
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
    if (!frame_) {
      frame_ = place;
      program_.frameShift = place.shift;
      program_.frameTurn = place.turn;
    }
    return scope_.setLocation(name, place);
  }
  if (word.empty() || isKeyword(word)) {
    return scope_.wrong("an instruction");
  }
  const std::string name = scope_.name("an instruction");
  scope_.sign("=");
  scope_.setReal(name, scope_.expression());
}

}  // namespace arelem::vplus
