#include "runtime/interpret/worded.h"

#include <fmt/format.h>

namespace arelem::runtime::interpret {

std::optional<Failure> WordedReader::readText(std::string& text) {
  const std::string* given =
      items_.empty() ? nullptr : std::get_if<std::string>(&items_.front().value);
  if (given == nullptr) {
    return wrong(items_.empty() ? "no parameters" : describe(items_.front()) + " in front",
                 "the first parameter is the text in quotes");
  }
  text = *given;
  return readWords(1);
}

std::optional<Failure> WordedReader::readWords(std::size_t first) {
  for (next_ = first; next_ < items_.size();) {
    if (auto failure = one()) {
      return failure;
    }
  }
  return std::nullopt;
}

std::optional<Failure> WordedReader::one() {
  const Item& item = items_[next_];
  const Word* word = std::get_if<Word>(&item.value);
  if (word == nullptr) {
    return wrong(describe(item) + fmt::format(" as parameter {}", next_ + 1),
                 "a word belongs there");
  }
  if (!seen_.insert(*word).second) {
    return wrong(fmt::format("{} twice", spell(*word)), "each word stands once");
  }
  ++next_;
  return value(*word);
}

EntityPtr WordedReader::take(EntityType type) {
  const EntityPtr* found = next() != nullptr ? next()->entity(type) : nullptr;
  if (found == nullptr) {
    return nullptr;
  }
  ++next_;
  return *found;
}

std::optional<Failure> WordedReader::meaningless(Word word) const {
  return wrong(fmt::format("the word {}", spell(word)), "it has no meaning there");
}

std::optional<Failure> WordedReader::number(Word word, double& into, double unit) {
  if (!more()) {
    return wrong(fmt::format("{} without a number", spell(word)), "a number belongs there");
  }
  into = *next()->number() * unit;
  ++next_;
  return std::nullopt;
}

std::optional<Failure> WordedReader::positive(Word word, double& into, double unit) {
  if (auto failure = number(word, into, unit)) {
    return failure;
  }
  return into > 0.0 ? std::nullopt : std::optional(refused(spell(word), into / unit, "positive"));
}

std::optional<Failure> WordedReader::fileName(Word word, std::string& into) {
  const std::string* file = next() != nullptr ? std::get_if<std::string>(&next()->value) : nullptr;
  if (file == nullptr) {
    return wrong(fmt::format("{} without a file", spell(word)),
                 "the name of a file in quotes belongs there");
  }
  into = *file;
  ++next_;
  return std::nullopt;
}

}  // namespace arelem::runtime::interpret
