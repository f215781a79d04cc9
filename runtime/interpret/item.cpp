#include "runtime/interpret/item.h"

#include <cmath>

#include "ir/diag/interpret.h"
#include "ir/diag/limits.h"
#include "runtime/interpret/definition.h"
#include "runtime/interpret/expression.h"

namespace arelem::runtime::interpret {

namespace {

std::optional<double> bound(State& state, ir::ExprId expr, double otherwise) {
  if (!expr.valid()) {
    return otherwise;
  }
  const std::optional<double> value = scalar(state, expr);
  return value ? std::optional<double>(std::trunc(*value)) : std::nullopt;
}

/// Evaluates one argument at a time; a list becomes several items.
class Expansion {
 public:
  Expansion(State& state, Use use, Items& out) : state_(state), use_(use), out_(out) {}

  bool operator()(const ir::Argument& argument) {
    argument_ = &argument;
    return std::visit(*this, argument.value);
  }
  /// The same for a nested definition that was executed before.
  bool operator()(const ir::Argument& argument, const EntityPtr& nested) {
    argument_ = &argument;
    return putEntity(nested);
  }

  bool operator()(const ir::Omitted&) { return put(define::Omitted{}); }
  bool operator()(Word word) { return put(word); }
  bool operator()(const std::string& text) { return put(text); }
  bool operator()(ir::ExprId expr) {
    const std::optional<double> value = scalar(state_, expr);
    return value && put(*value);
  }
  bool operator()(const ir::Target& target) { return putEntity(entityOf(state_, target)); }
  bool operator()(ir::DefinitionId definition) {
    return putEntity(evaluateDefinition(state_, definition));
  }
  bool operator()(const ir::ElementRange& range) {
    if (use_ != Use::definition) {
      state_.report(diagnose(range.span, diag::ListMisplaced, state_.program[range.symbol].name));
      return false;
    }
    const std::optional<std::vector<std::uint32_t>> list = elements(state_, range);
    if (!list) {
      return false;
    }
    bool good = true;
    for (const std::uint32_t element : *list) {
      good = putElement(state_.store.place(range.symbol, element), range.span) && good;
    }
    return good;
  }

 private:
  bool put(Item::Value value) {
    out_.push_back({std::move(value), argument_->span});
    return true;
  }
  bool putEntity(const EntityPtr& entity) {
    if (!entity) {
      return false;
    }
    EntityPtr moved = brought(state_, entity, use_, argument_->span);
    if (!moved) {
      return false;
    }
    const bool tilted = entity->type == EntityType::line && moved->type == EntityType::plane;
    put(std::move(moved));
    out_.back().wasLine = tilted;
    return true;
  }
  bool putElement(const Place& place, const Span& span) {
    const bool isEntity = state_.store.isEntity(place);
    const Status status =
        isEntity ? state_.store.entityStatus(place) : state_.store.scalarStatus(place);
    if (status == Status::empty) {
      state_.reportEmpty(place, span);
    }
    if (status != Status::defined) {
      return false;
    }
    return isEntity ? putEntity(state_.store.entity(place)) : put(state_.store.scalar(place));
  }

  State& state_;
  Use use_;
  Items& out_;
  const ir::Argument* argument_ = nullptr;
};

/// Executes the nested definitions from the last to the first, before anything else of their
/// statement is looked at, as the old system does: what they name can be used beside them. The
/// result is in order of execution.
std::vector<EntityPtr> executeNested(State& state, const std::vector<ir::Argument>& arguments) {
  std::vector<EntityPtr> results;
  for (auto a = arguments.rbegin(); a != arguments.rend(); ++a) {
    if (const auto* id = std::get_if<ir::DefinitionId>(&a->value)) {
      results.push_back(evaluateDefinition(state, *id));
    }
  }
  return results;
}

/// How often the first kind repeats, to say "3 numbers" rather than "a number, a number, a number".
std::string kindOf(const Item& item) {
  if (item.number() != nullptr) {
    return "number";
  }
  if (const EntityPtr* entity = item.entity()) {
    return std::string(spell((*entity)->type));
  }
  if (const Word* word = std::get_if<Word>(&item.value)) {
    return std::string(spell(*word));
  }
  if (const std::string* text = std::get_if<std::string>(&item.value)) {
    return fmt::format("`{}`", *text);
  }
  return "an empty place";
}

}  // namespace

std::optional<std::vector<std::uint32_t>> elements(State& state, const ir::ElementRange& range) {
  const std::string& name = state.program[range.symbol].name;
  const std::uint32_t size = state.store.arraySize(range.symbol);
  if (size == 0) {
    state.report(diagnose(range.span, diag::ArrayNotReserved, name));
    return std::nullopt;
  }
  const std::optional<double> low = bound(state, range.low, 1.0);
  const std::optional<double> high = bound(state, range.high, size);
  const std::optional<double> written = bound(state, range.step, 1.0);
  if (!low || !high || !written) {
    return std::nullopt;
  }
  const double step = range.descending ? -*written : *written;
  if (step == 0.0) {
    state.report(diagnose(range.span, diag::RangeStep, name, *written));
    return std::nullopt;
  }
  // The low and high limits bound the list whatever its direction; out of order, only the first
  // counts.
  const double first = step > 0.0 ? *low : *high;
  const double last = *low > *high ? first : (step > 0.0 ? *high : *low);
  for (const double limit : {first, last}) {
    if (limit < 1.0 || limit > size) {
      state.report(diagnose(range.span, diag::SubscriptOutside, name, limit, size));
      return std::nullopt;
    }
  }
  std::vector<std::uint32_t> list;
  for (double i = first; step > 0.0 ? i <= last : i >= last; i += step) {
    list.push_back(static_cast<std::uint32_t>(i));
  }
  return list;
}

EntityPtr entityOf(State& state, const ir::Target& target) {
  const std::optional<Place> place = state.place(target);
  if (!place) {
    return nullptr;
  }
  if (!state.store.isEntity(*place)) {
    state.report(diagnose(target.span, diag::ArrayClass, state.spellPlace(*place), "a scalar",
                          "the place of an entity"));
    return nullptr;
  }
  switch (state.store.entityStatus(*place)) {
    case Status::defined:
      return state.store.entity(*place);
    case Status::empty:
      state.reportEmpty(*place, target.span);
      return nullptr;
    default:
      return nullptr;
  }
}

EntityPtr brought(State& state, const EntityPtr& entity, Use use, const Span& span) {
  static const std::string base;
  const std::string& system = use == Use::motion ? base : state.systems.current();
  if (entity->referenceSystem == system) {
    return entity;
  }
  Result<EntityPtr> moved = state.systems.seenFrom(entity, system);
  if (!moved) {
    reportAt(state, span, moved.takeFailure(), {{entity, span}});
    return nullptr;
  }
  return *std::move(moved);
}

std::optional<Items> evaluate(State& state, const std::vector<ir::Argument>& arguments, Use use) {
  std::vector<EntityPtr> nested = executeNested(state, arguments);
  Items items;
  items.reserve(arguments.size());
  Expansion expand(state, use, items);
  bool good = true;
  for (const ir::Argument& argument : arguments) {
    if (std::holds_alternative<ir::DefinitionId>(argument.value)) {
      good = expand(argument, nested.back()) && good;
      nested.pop_back();
    } else {
      good = expand(argument) && good;
    }
    if (items.size() > state.options.limits.elements) {
      state.report(diagnose(argument.span, diag::LimitElements, items.size(),
                            state.options.limits.elements));
      return std::nullopt;
    }
  }
  return good ? std::optional<Items>(std::move(items)) : std::nullopt;
}

std::optional<Item> evaluate(State& state, const ir::Argument& argument, Use use) {
  Items items;
  if (!Expansion(state, use, items)(argument) || items.size() != 1) {
    return std::nullopt;
  }
  return std::move(items.front());
}

std::string describe(const Item& item) {
  if (const double* number = item.number()) {
    return fmt::format("the number {}", *number);
  }
  if (const EntityPtr* entity = item.entity()) {
    const std::string name = nameOf(**entity);
    return name.empty() ? fmt::format("a {}", spell((*entity)->type))
                        : fmt::format("the {} `{}`", spell((*entity)->type), name);
  }
  if (const Word* word = std::get_if<Word>(&item.value)) {
    return fmt::format("the word {}", spell(*word));
  }
  return kindOf(item);
}

std::string describe(const Items& items) {
  if (items.empty()) {
    return "no parameters";
  }
  std::string text;
  for (std::size_t i = 0; i < items.size();) {
    const std::string kind = kindOf(items[i]);
    std::size_t same = i + 1;
    while (same < items.size() && kindOf(items[same]) == kind) {
      ++same;
    }
    text += i == 0 ? "" : ", ";
    const std::size_t count = same - i;
    text += count == 1 ? kind : fmt::format("{} {}{}", count, kind, kind == "number" ? "s" : "");
    i = same;
  }
  return text;
}

void labelOperands(Diagnostic& diagnostic, const Items& items) {
  std::set<const Entity*> seen;
  for (const Item& item : items) {
    const EntityPtr* entity = item.entity();
    if (entity == nullptr || (*entity)->name.empty() || !seen.insert(entity->get()).second) {
      continue;
    }
    diagnostic.labels.push_back(
        {(*entity)->definition, fmt::format("`{}` defined here", nameOf(**entity))});
  }
}

void reportAt(State& state, const Span& place, Failure failure, const Items& items) {
  Diagnostic d = at(place, std::move(failure));
  labelOperands(d, items);
  state.report(std::move(d));
}

}  // namespace arelem::runtime::interpret
