#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ir/geometry/entity.h"
#include "ir/words/words.h"

namespace arelem::define {

/// A parameter as far as the choice of a form depends on it.
struct Symbol {
  enum class Sort : std::uint8_t { empty, scalar, word, entity, text };
  Sort sort = Sort::empty;
  Word word = Word::CANON;              ///< of a word
  EntityType type = EntityType::point;  ///< of an entity

  [[nodiscard]] static Symbol empty() { return {}; }
  [[nodiscard]] static Symbol scalar() { return {Sort::scalar, {}, {}}; }
  [[nodiscard]] static Symbol text() { return {Sort::text, {}, {}}; }
  [[nodiscard]] static Symbol of(Word word) { return {Sort::word, word, {}}; }
  [[nodiscard]] static Symbol of(EntityType type) { return {Sort::entity, {}, type}; }
};

/// "XLARGE", "circle", "scalar" or "nothing": how a message names what was found.
[[nodiscard]] std::string describe(const Symbol& symbol);

/// What a pattern wants at one place: a word, a scalar, an empty place or entities of certain
/// types.
struct Expectation {
  Symbol::Sort sort = Symbol::Sort::empty;
  Word word = Word::CANON;
  std::uint64_t types = 0;  ///< bit n: entities of type code n
  std::string_view text;    ///< as the pattern spells it: "circle1", "deg", "TANTO"

  [[nodiscard]] bool accepts(const Symbol& symbol) const;
};

/// A pattern of forms.def compiled to an automaton: nodes either take one parameter or split
/// without taking any.
struct Pattern {
  struct Node {
    enum class Kind : std::uint8_t { take, split, end };
    Kind kind = Kind::end;
    Expectation wanted;         ///< of take
    int next = -1, other = -1;  ///< `other` only of split
  };
  std::vector<Node> nodes;
  int start = 0;
};

/// Compiles a pattern. The patterns are our own table, so a wrong one is a programming error:
/// `error` then says what is wrong and the pattern accepts nothing. A unit test compiles all of
/// them.
[[nodiscard]] Pattern compile(std::string_view pattern, std::string* error = nullptr);

}  // namespace arelem::define
