#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "runtime/interpret/state.h"

namespace arelem::runtime::interpret {

/// An evaluated argument with its place in the text.
struct Item {
  using Value = std::variant<define::Omitted, double, Word, EntityPtr, std::string>;
  Value value;
  Span span;
  bool wasLine = false;  ///< a LINE that a tilted reference system shows as a PLANE

  [[nodiscard]] const double* number() const { return std::get_if<double>(&value); }
  [[nodiscard]] const EntityPtr* entity() const { return std::get_if<EntityPtr>(&value); }
  [[nodiscard]] const EntityPtr* entity(EntityType type) const {
    const EntityPtr* e = entity();
    return e != nullptr && (*e)->type == type ? e : nullptr;
  }
  [[nodiscard]] bool is(Word word) const {
    const Word* w = std::get_if<Word>(&value);
    return w != nullptr && *w == word;
  }
  [[nodiscard]] bool omitted() const { return std::holds_alternative<define::Omitted>(value); }
};
using Items = std::vector<Item>;

/// What arguments are for: definitions see entities in the system in force and may hold lists of
/// array elements; statements of motion and posts see entities in the base system.
enum class Use : std::uint8_t { definition, motion };

/// Evaluates arguments and expands lists. None when one has no value; all of them are looked at
/// first, so that every error of a statement shows.
[[nodiscard]] std::optional<Items> evaluate(State& state,
                                            const std::vector<ir::Argument>& arguments,
                                            Use use);
[[nodiscard]] std::optional<Item> evaluate(State& state, const ir::Argument& argument, Use use);

/// The entity of a name in its own system, or null.
[[nodiscard]] EntityPtr entityOf(State& state, const ir::Target& target);
/// The same as the use wants it: moved to the base or the current system.
[[nodiscard]] EntityPtr brought(State& state, const EntityPtr& entity, Use use, const Span& span);

/// "a POINT", "the word ON", "the number 3": what was seen, for messages.
[[nodiscard]] std::string describe(const Item& item);
/// "2 numbers, a POINT": the kinds of all parameters.
[[nodiscard]] std::string describe(const Items& items);
/// One label on the definition of each entity among the operands.
void labelOperands(Diagnostic& diagnostic, const Items& items);
/// Reports a failure at a place of the text, with such labels.
void reportAt(State& state, const Span& place, Failure failure, const Items& items);

/// The elements that a list like A(2,THRU,ALL,INCR,3) names, in its order.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> elements(State& state,
                                                                 const ir::ElementRange& range);

}  // namespace arelem::runtime::interpret
