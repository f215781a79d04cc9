#pragma once
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "runtime/interpret/item.h"

namespace arelem::runtime::interpret {

/// Reads parameters that are words, each with its values, from left to right: the form of SPRAY,
/// STENCL and ENGRAV behind their first parameter. A word stands once. The reader of a statement
/// says what its words mean, and names the statement in its failures.
class WordedReader {
 protected:
  explicit WordedReader(const Items& items) : items_(items) {}
  ~WordedReader() = default;
  WordedReader(const WordedReader&) = delete;
  WordedReader& operator=(const WordedReader&) = delete;

  /// What is written wrongly, and the rule that it breaks.
  [[nodiscard]] virtual Failure wrong(std::string what, std::string rule) const = 0;
  /// A number that cannot be.
  [[nodiscard]] virtual Failure refused(std::string_view name,
                                        double value,
                                        std::string_view rule) const = 0;
  /// Takes the values behind a word.
  virtual std::optional<Failure> value(Word word) = 0;

  /// The first parameter, a text; then all words.
  std::optional<Failure> readText(std::string& text);
  /// All words from the parameter `first` on, counted from 0.
  std::optional<Failure> readWords(std::size_t first);

  [[nodiscard]] bool has(Word word) const { return seen_.count(word) != 0; }
  /// A number comes next.
  [[nodiscard]] bool more() const { return next() != nullptr && next()->number() != nullptr; }
  [[nodiscard]] const Item* next() const {
    return next_ < items_.size() ? &items_[next_] : nullptr;
  }
  void skip() { ++next_; }
  /// The next parameter where it is an entity of the type, which is then taken; else null.
  EntityPtr take(EntityType type);

  std::optional<Failure> meaningless(Word word) const;
  /// A number times `unit`.
  std::optional<Failure> number(Word word, double& into, double unit = 1.0);
  /// The same; it must be above zero.
  std::optional<Failure> positive(Word word, double& into, double unit = 1.0);
  std::optional<Failure> fileName(Word word, std::string& into);

 private:
  std::optional<Failure> one();

  const Items& items_;
  std::size_t next_ = 0;
  std::set<Word> seen_;
};

}  // namespace arelem::runtime::interpret
