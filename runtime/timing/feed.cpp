#include "runtime/timing/feed.h"

#include <algorithm>

#include "ir/cl/post_word.h"
#include "ir/words/units.h"

namespace arelem::timing {

namespace {
constexpr double secondsOfAMinute = 60.0;
}  // namespace

const double* firstNumber(const cl::Post& post) {
  for (const cl::Value& value : post.arguments) {
    if (const double* number = std::get_if<double>(&value)) {
      return number;
    }
  }
  return nullptr;
}

bool hasOneOf(const cl::Post& post, std::initializer_list<Word> words) {
  return std::any_of(post.arguments.begin(), post.arguments.end(), [&](const cl::Value& value) {
    const Word* word = std::get_if<Word>(&value);
    return word != nullptr && std::find(words.begin(), words.end(), *word) != words.end();
  });
}

void FeedInForce::take(const cl::Post& post) {
  const double* number = firstNumber(post);
  if (number == nullptr) {
    return;
  }
  if (cl::is(post, Word::SPINDL)) {
    turns_ = *number;
  } else if (cl::is(post, Word::FEDRAT)) {
    mode_ = hasOneOf(post, {Word::INVERS})            ? Mode::inverse
            : hasOneOf(post, {Word::IPR, Word::MMPR}) ? Mode::perTurn
                                                      : Mode::perMinute;
    const bool inches = hasOneOf(post, {Word::IPM, Word::IPR});
    const bool millimeters = hasOneOf(post, {Word::MMPM, Word::MMPR});
    const bool perSecond = hasOneOf(post, {Word::MMPS});
    value_ = *number * (inches                       ? millimetersOfAnInch
                        : millimeters || isInverse() ? 1.0
                        : perSecond                  ? secondsOfAMinute
                                                     : unit_);
  }
}

double FeedInForce::perMinute(double length) const {
  return value_ * (mode_ == Mode::perTurn ? turns_ : mode_ == Mode::inverse ? length : 1.0);
}

}  // namespace arelem::timing
