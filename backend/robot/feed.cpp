#include "backend/robot/feed.h"

#include <algorithm>

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

std::optional<double> speedOf(const cl::Post& feedRate, double millimeters) {
  const double* value = numberAt(feedRate, 0);
  if (value == nullptr || !(*value > 0.0) || hasWord(feedRate, Word::IPR) ||
      hasWord(feedRate, Word::MMPR)) {
    return std::nullopt;
  }
  return hasWord(feedRate, Word::MMPS)   ? *value
         : hasWord(feedRate, Word::MMPM) ? *value / secondsOfAMinute
         : hasWord(feedRate, Word::IPM)  ? *value * millimetersOfAnInch / secondsOfAMinute
                                         : *value * millimeters / secondsOfAMinute;
}

Result<double> neededSpeed(const cl::Post& feedRate, double millimeters) {
  if (const std::optional<double> speed = speedOf(feedRate, millimeters)) {
    return *speed;
  }
  const double* value = numberAt(feedRate, 0);
  return fail(diag::VplusFeed, value == nullptr ? 0.0 : *value);
}

}  // namespace arelem::robot
