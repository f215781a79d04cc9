#include "backend/robot/feed.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ir/diag/robot.h"
#include "ir/words/units.h"

namespace arelem::robot {

namespace {
constexpr double secondsOfAMinute = 60.0;
}  // namespace

const double* numberAt(const cl::Post& post, std::size_t place) {
  return place < post.arguments.size() ? std::get_if<double>(&post.arguments[place]) : nullptr;
}

bool hasWord(const cl::Post& post, Word word) {
  return std::any_of(post.arguments.begin(), post.arguments.end(), [&](const cl::Value& value) {
    const Word* found = std::get_if<Word>(&value);
    return found != nullptr && *found == word;
  });
}

std::optional<double> numberOf(const cl::Post& post) {
  for (const cl::Value& value : post.arguments) {
    if (const double* number = std::get_if<double>(&value)) {
      return *number;
    }
  }
  return std::nullopt;
}

double turnsBehind(const cl::Post& spindle, double before) {
  const bool stands =
      std::any_of(spindle.arguments.begin(), spindle.arguments.end(), [](const cl::Value& value) {
        const Word* word = std::get_if<Word>(&value);
        const std::string* text = std::get_if<std::string>(&value);
        const std::string_view name = word != nullptr   ? spell(*word)
                                      : text != nullptr ? std::string_view(*text)
                                                        : std::string_view();
        constexpr std::array others = {"OFF", "SFM", "SMM", "ORIENT", "LOCK", "MAXRPM"};
        return std::find(others.begin(), others.end(), name) != others.end();
      });
  return stands ? 0.0 : std::abs(numberOf(spindle).value_or(before));
}

std::optional<double> speedOf(const cl::Post& feedRate, double millimeters, double turns) {
  const std::optional<double> value = numberOf(feedRate);
  const bool inches = hasWord(feedRate, Word::IPR) || hasWord(feedRate, Word::IPM);
  const bool perTurn = hasWord(feedRate, Word::IPR) || hasWord(feedRate, Word::MMPR);
  if (!value || !(*value > 0.0) || (perTurn && !(turns > 0.0)) || hasWord(feedRate, Word::INVERS)) {
    return std::nullopt;
  }
  if (hasWord(feedRate, Word::MMPS)) {
    return *value;
  }
  const bool named = inches || perTurn || hasWord(feedRate, Word::MMPM);
  const double unit = inches ? millimetersOfAnInch : named ? 1.0 : millimeters;
  return *value * unit * (perTurn ? turns : 1.0) / secondsOfAMinute;
}

Result<double> neededSpeed(const cl::Post& feedRate, double millimeters, double turns) {
  if (const std::optional<double> speed = speedOf(feedRate, millimeters, turns)) {
    return *speed;
  }
  return fail(diag::RobotFeed, numberOf(feedRate).value_or(0.0));
}

Result<double> secondsOf(const cl::Post& delay, double turns) {
  const std::optional<double> value = numberOf(delay);
  const bool counts = hasWord(delay, Word::REV);
  if (!value || *value < 0.0 || (counts && !(turns > 0.0))) {
    return fail(diag::RobotDelay, value.value_or(0.0), counts ? " turns" : " s");
  }
  return counts ? *value * secondsOfAMinute / turns : *value;
}

}  // namespace arelem::robot
