#include "runtime/timing/feed.h"

#include <algorithm>
#include <cmath>

#include "ir/cl/post_word.h"
#include "ir/diag/spline.h"
#include "ir/words/units.h"

namespace arelem::timing {

namespace {
constexpr double secondsOfAMinute = 60.0;

/// Of the number of a FEDRAT, or else of a DELAY.
bool isUnit(Word word, bool ofFeed) {
  switch (word) {
    case Word::IPM:
    case Word::MMPM:
    case Word::IPR:
    case Word::MMPR:
    case Word::MMPS:
    case Word::INVERS:
      return ofFeed;
    case Word::REV:
      return !ofFeed;
    default:
      return false;
  }
}
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

std::optional<Failure> objectionToTiming(const cl::Post& post) {
  const bool feeds = cl::is(post, Word::FEDRAT);
  if (!feeds && !cl::is(post, Word::DELAY)) {
    return std::nullopt;
  }
  const auto refuse = [&](std::string_view what) {
    return fail(diag::UntimedStatement, cl::nameOf(post),
                fmt::format("{}: it takes one number, {}", what,
                            feeds ? "and IPM, MMPM, IPR, MMPR, MMPS or INVERS for its unit"
                                  : "the seconds to wait, or turns of the spindle with REV"));
  };
  std::size_t numbers = 0;
  std::size_t units = 0;
  for (const cl::Value& value : post.arguments) {
    const Word* word = std::get_if<Word>(&value);
    const std::string* text = std::get_if<std::string>(&value);
    if (text != nullptr || (word != nullptr && !isUnit(*word, feeds))) {
      return refuse(fmt::format("`{}`", text != nullptr ? std::string_view(*text) : spell(*word)));
    }
    numbers += std::holds_alternative<double>(value) ? 1 : 0;
    units += word != nullptr ? 1 : 0;
  }
  if (numbers != 1 || units > 1) {
    return refuse(numbers == 0 ? "no number" : numbers > 1 ? "several numbers" : "several units");
  }
  return std::nullopt;
}

void FeedInForce::take(const cl::Post& post) {
  const double* number = firstNumber(post);
  if (number == nullptr) {
    return;
  }
  if (cl::is(post, Word::SPINDL)) {
    turns_ = hasOneOf(post, {Word::SFM}) ? 0.0 : std::abs(*number);  // below 0: counterclockwise
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
