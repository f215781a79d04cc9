#include "backend/robot/feed.h"

#include "ir/cl/feed.h"
#include "ir/cl/post_word.h"
#include "ir/diag/robot.h"

namespace arelem::robot {

namespace {
constexpr double secondsOfAMinute = 60.0;
}  // namespace

const double* numberAt(const cl::Post& post, std::size_t place) {
  return place < post.arguments.size() ? std::get_if<double>(&post.arguments[place]) : nullptr;
}

std::optional<double> speedOf(const cl::Post& feedRate, double millimeters, double turns) {
  const std::optional<cl::Feed> feed = cl::readFeed(feedRate, millimeters).feed;
  constexpr double noMove = 0.0;  // an inverse time says no speed
  const double speed = feed ? feed->perMinute(noMove, turns) / secondsOfAMinute : 0.0;
  return speed > 0.0 ? std::optional(speed) : std::nullopt;
}

Result<double> neededSpeed(const cl::Post& feedRate, double millimeters, double turns) {
  if (const std::optional<double> speed = speedOf(feedRate, millimeters, turns)) {
    return *speed;
  }
  const double* number = cl::firstNumber(feedRate);
  return fail(diag::RobotFeed, number != nullptr ? *number : 0.0);
}

Result<double> secondsOf(const cl::Post& delay, double turns) {
  const double* value = cl::firstNumber(delay);
  const bool counts = cl::has(delay, Word::REV);
  if (value == nullptr || *value < 0.0 || (counts && !(turns > 0.0))) {
    return fail(diag::RobotDelay, value != nullptr ? *value : 0.0, counts ? " turns" : " s");
  }
  return counts ? *value * secondsOfAMinute / turns : *value;
}

}  // namespace arelem::robot
