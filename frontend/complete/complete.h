#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/dialect.h"
#include "ir/geometry/entity.h"
#include "ir/limits.h"

/// Completion of statements that are being typed.
namespace arelem::frontend {

/// A row of statement_forms.def, or of the words for the machine in ir/words/post_forms.def.
struct StatementForm {
  Word word = Word::END;
  std::string_view pattern;
  std::string_view meaning;
  std::string_view example;  ///< "" where an example needs more than a line
};
[[nodiscard]] std::span<const StatementForm> statementForms();
/// The row of a word, or nullptr.
[[nodiscard]] const StatementForm* statementForm(Word word);

/// A name that the program has.
struct KnownName {
  enum class Kind : std::uint8_t { scalar, entity, macro, label };
  std::string name;
  Kind kind = Kind::scalar;
  EntityType type = EntityType::point;  ///< of an entity
};

struct Completion {
  std::size_t begin = 0;  ///< of the word in the text that the candidates replace
  /// In alphabetical order; a word that goes on with `/` or `(` ends in it.
  std::vector<std::string> candidates;
};

/// The words and names that may stand at the end of `text`, a statement as far as it is typed:
/// vocabulary words only where the tables of forms let them follow what stands before.
[[nodiscard]] Completion complete(std::string_view text, std::span<const KnownName> names);

}  // namespace arelem::frontend
