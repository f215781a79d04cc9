#include "runtime/timing/feed.h"

#include <fmt/format.h>

#include "ir/cl/post_word.h"
#include "ir/diag/spline.h"

namespace arelem::timing {

namespace {
/// What stands in a DELAY beside one number and REV; "" where nothing does.
std::string strangeIn(const cl::Post& delay) {
  std::size_t numbers = 0;
  for (const cl::Value& value : delay.arguments) {
    const Word* word = std::get_if<Word>(&value);
    const std::string* text = std::get_if<std::string>(&value);
    if (text != nullptr || (word != nullptr && *word != Word::REV)) {
      return fmt::format("`{}`", text != nullptr ? std::string_view(*text) : spell(*word));
    }
    numbers += std::holds_alternative<double>(value) ? 1 : 0;
  }
  return numbers == 0 ? "no number" : numbers > 1 ? "several numbers" : "";
}
}  // namespace

std::optional<Failure> objectionToTiming(const cl::Post& post) {
  if (cl::is(post, Word::FEDRAT)) {
    cl::FeedReading reading = cl::readFeed(post, 1.0);
    return reading.feed ? std::nullopt
                        : std::optional(fail(diag::UntimedStatement, "FEDRAT", reading.why));
  }
  const std::string strange = cl::is(post, Word::DELAY) ? strangeIn(post) : "";
  return strange.empty() ? std::nullopt
                         : std::optional(fail(diag::UntimedStatement, "DELAY",
                                              strange + ": it takes one number, the seconds to "
                                                        "wait, or turns of the spindle with REV"));
}

void FeedInForce::take(const cl::Post& post) {
  if (cl::is(post, Word::SPINDL)) {
    turns_ = cl::turnsBehind(post, turns_);
  } else if (cl::is(post, Word::FEDRAT)) {
    feed_ = cl::readFeed(post, unit_).feed.value_or(feed_);
  }
}

}  // namespace arelem::timing
