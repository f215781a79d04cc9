#include "backend/vplus/instruction.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "backend/vplus/name.h"
#include "ir/space/robot_tolerance.h"

namespace arelem::vplus {

namespace {
constexpr std::size_t deepestBlock = 64;
}  // namespace

bool isSame(const Place& a, const Place& b) {
  return a.known && b.known && (a.shift - b.shift).norm() < tolerance::writtenPlace &&
         (a.turn - b.turn).norm() < tolerance::writtenPlace;
}

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
  const double speed = settings_.at(Setting::toolSpeed);
  made.speed = std::isnan(speed) ? 0.0 : speed;
  motionEvent(straight ? "MOVES" : "MOVE");
  program_.moves.push_back(made);
}

/// Over a place: the move to it is to follow.
void Instructions::approach(const std::string& word) {
  endOfApproach();
  underWay_.reset();
  over_ = scope_.location();
  overLine_ = line_;
  scope_.sign(",");
  const std::optional<double> away = scope_.expression();
  if (!over_->known || !away || *away < 0.0) {
    stray("the text does not tell where this approach goes, or it goes beyond its place");
  }
  motionEvent(word, {away});
}

void Instructions::depart(const std::string& word) {
  endOfApproach();
  underWay_.reset();
  const std::optional<double> away = scope_.expression();
  if (!away || *away < 0.0) {
    stray("the text does not tell how far this departs, or it departs to the work");
  }
  motionEvent(word, {away});
}

void Instructions::event(std::string what, std::vector<std::optional<double>> numbers) {
  Event made{line_, std::move(what)};
  for (const std::optional<double>& number : numbers) {
    made.numbers.push_back(number.value_or(std::nan("")));
  }
  program_.events.push_back(std::move(made));
}

void Instructions::motionEvent(std::string what, std::vector<std::optional<double>> numbers) {
  event(std::move(what), std::move(numbers));
  program_.events.back().manner = settings_.take();
}

void Instructions::finish() {
  endOfApproach();
  if (program_.events.empty() || program_.events.back().what != "RETURN") {
    event("RETURN");  // .END is one
  }
}

void Instructions::endOfApproach() {
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
    approach(word);
  } else if (word == "DEPART" || word == "DEPARTS") {
    scope_.next();
    depart(word);
  } else if (word == "DELAY") {
    scope_.next();
    delay();
  } else if (word == "BREAK" || word == "RETURN" || word == "PAUSE" || word == "STOP") {
    scope_.next();
    event(word);
    if (word == "BREAK") {
      underWay_.reset();
    }
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
  event("DELAY", {seconds});
  if (!seconds) {
    return stray("the text does not tell how long the robot waits");
  }
  if (!program_.moves.empty()) {
    program_.moves.back().wait += *seconds;
  }
  underWay_.reset();
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
  event("SIGNAL", {value});
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
  event("BITS", {first, count, value});
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
