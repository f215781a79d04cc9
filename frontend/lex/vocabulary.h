#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "frontend/compile.h"
#include "ir/words/words.h"

namespace arelem::frontend {

/// The words of one program: the vocabulary, its synonyms, and without the words that yield to the
/// program's own symbols. Extension words yield to a symbol of the same name that the program
/// defines anywhere; outside apt360 so do the words that the old system reserved without a use.
class Vocabulary {
 public:
  explicit Vocabulary(Dialect dialect) : dialect_(dialect) {}

  [[nodiscard]] std::optional<Word> find(std::string_view text) const;
  /// SYN/ name,WORD.
  void addSynonym(std::string_view name, Word word) { synonyms_[std::string(name)] = word; }
  [[nodiscard]] std::size_t synonyms() const { return synonyms_.size(); }
  void clearSynonyms() { synonyms_.clear(); }
  /// The program defines a symbol of this name: an extension word of the same name yields to it.
  void yieldTo(std::string_view name);
  /// Whether `word` gives way to a symbol.
  [[nodiscard]] bool canYield(Word word) const;

 private:
  Dialect dialect_;
  std::map<std::string, Word, std::less<>> synonyms_;
  std::set<std::string, std::less<>> yielded_;
};

}  // namespace arelem::frontend
