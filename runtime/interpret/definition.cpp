#include "runtime/interpret/definition.h"

#include <cmath>

#include "ir/define/matcher.h"
#include "ir/diag/frontend.h"
#include "ir/diag/interpret.h"
#include "ir/diag/limits.h"
#include "ir/space/tolerance.h"
#include "runtime/interpret/expression.h"
#include "runtime/interpret/item.h"
#include "runtime/interpret/printing.h"

namespace arelem::runtime::interpret {

namespace {

/// TYPE/CANON,... and TYPE/entity,CANON,... replace what the name held (spec CN-01 to CN-03).
bool isCanonical(const Items& items) {
  return (!items.empty() && items[0].is(Word::CANON)) ||
         (items.size() > 1 && items[0].entity() != nullptr && items[1].is(Word::CANON));
}

bool needsName(EntityType type) {
  return type == EntityType::pattern || type == EntityType::tabulatedCylinder ||
         type == EntityType::polyconic || type == EntityType::ruledSurface ||
         type == EntityType::mesh || type == EntityType::pathSpline;
}

/// Whether the place may take an entity of this type now; reports why not.
bool mayStore(State& state, const Place& place, const ir::Definition& definition, bool canonical) {
  const Span& span = definition.target.span;
  if (!state.store.isEntity(place)) {
    state.report(diagnose(span, diag::ArrayClass, state.spellPlace(place), "a scalar",
                          spell(definition.type)));
    return false;
  }
  if (state.store.entityStatus(place) != Status::defined) {
    return true;
  }
  const Entity& old = *state.store.entity(place);
  if (old.type != definition.type) {
    state.report(diagnose(span, diag::RedefinedType, state.spellPlace(place), spell(old.type),
                          spell(definition.type))
                     .label(old.definition, fmt::format("`{}` defined here", nameOf(old))));
    return false;
  }
  if (!canonical && !state.redefinable) {
    state.report(diagnose(span, diag::Redefined, state.spellPlace(place), spell(old.type))
                     .label(old.definition, fmt::format("`{}` defined here", nameOf(old))));
    return false;
  }
  return true;
}

std::optional<std::vector<define::Parameter>> parameters(State& state,
                                                         EntityType type,
                                                         const Items& items) {
  const std::optional<Word> noun = findWord(spell(type));
  const bool texts = noun && define::takesText(*noun);
  std::vector<define::Parameter> result;
  result.reserve(items.size());
  for (const Item& item : items) {
    const std::string* text = std::get_if<std::string>(&item.value);
    if (text != nullptr && !texts) {
      state.report(diagnose(item.span, diag::UndefinedSymbol, *text));
      return std::nullopt;
    }
    std::visit([&result](const auto& value) { result.emplace_back(value); }, item.value);
  }
  return result;
}

/// The LINE in which a tilted plane meets the XY plane of the system in force, or null if it does
/// not.
EntityPtr trace(const EntityPtr& plane) {
  const std::vector<double>& p = plane->canon;
  const double length = std::hypot(p[0], p[1]);
  if (length <= tolerance::nullDirection) {
    return nullptr;
  }
  auto line = std::make_shared<Entity>(*plane);
  line->type = EntityType::line;
  line->canon = {p[0] / length, p[1] / length, 0.0, p[3] / length};
  return line;
}

/// A line of another system stays a line for the forms that want one, as its trace; a plane first.
Result<Entity> defineWithTraces(const ir::Definition& definition,
                                std::vector<define::Parameter> given,
                                const Items& items,
                                const define::Context& context) {
  Result<Entity> result = define::define(definition.type, given, context);
  bool any = false;
  for (std::size_t i = 0; i < items.size() && !result; ++i) {
    if (items[i].wasLine) {
      EntityPtr line = trace(*items[i].entity());
      any = any || line;
      given[i] = line ? line : *items[i].entity();
    }
  }
  return any ? define::define(definition.type, given, context) : std::move(result);
}

std::shared_ptr<Entity> compute(State& state,
                                const ir::Definition& definition,
                                const Items& items,
                                const std::optional<Place>& place) {
  const auto given = parameters(state, definition.type, items);
  if (!given) {
    return nullptr;
  }
  std::vector<Failure> remarks;
  define::Context context = state.context;
  context.remarks = &remarks;
  Result<Entity> result = defineWithTraces(definition, *given, items, context);
  if (!result) {
    reportAt(state, definition.span, result.takeFailure(), items);
    return nullptr;
  }
  for (Failure& remark : remarks) {
    state.report(at(definition.span, std::move(remark)));
  }
  auto entity = std::make_shared<Entity>(*std::move(result));
  ++state.out.forms[static_cast<std::size_t>(entity->form)];
  entity->definition = definition.span;
  entity->referenceSystem = definition.type == EntityType::matrix ? "" : state.systems.current();
  if (place) {
    entity->name = state.program[place->symbol].name;
    entity->subscript = static_cast<int>(place->element);
  }
  if (state.options.defined) {
    state.options.defined(*entity, *given, state.context);
  }
  return entity;
}

void boundHistory(State& state) {
  if (state.store.historySize() >= state.options.limits.definitions && !state.stopped) {
    state.report(diagnose(state.statement->span, diag::LimitReached, "definitions to list",
                          state.options.limits.definitions, "definitions"));
    state.stopped = true;
  }
}
}  // namespace

EntityPtr evaluateDefinition(State& state, ir::DefinitionId id) {
  const ir::Definition& definition = state.program[id];
  const bool named = definition.target.symbol.valid();
  std::optional<Place> place;
  if (named) {
    place = state.place(definition.target);
    if (!place) {
      return nullptr;
    }
  }
  const std::optional<Items> items = evaluate(state, definition.arguments, Use::definition);
  std::shared_ptr<Entity> entity;
  if (!named && needsName(definition.type)) {
    state.report(diagnose(definition.span, diag::UnnamedPattern, spell(definition.type)));
  } else if (items) {
    if (place && !mayStore(state, *place, definition, isCanonical(*items))) {
      return nullptr;
    }
    entity = compute(state, definition, *items, place);
  }
  if (!entity) {
    if (place) {
      state.store.poison(*place);
    }
    return nullptr;
  }
  if (place) {
    state.store.setEntity(*place, entity);
  } else {
    state.store.setUnnamed(id, entity);
  }
  boundHistory(state);
  listDefinition(state, entity);
  return entity;
}

void execute(State& state, const ir::Assign& assignment) {
  assign(state, assignment.target, scalar(state, assignment.value));
}

void execute(State& state, const ir::Define& define) {
  evaluateDefinition(state, define.definition);
}

void execute(State& state, const ir::Obtain& obtain) {
  EntityPtr source;
  if (const auto* target = std::get_if<ir::Target>(&obtain.source.value)) {
    source = entityOf(state, *target);
  } else if (const auto* nested = std::get_if<ir::DefinitionId>(&obtain.source.value)) {
    source = evaluateDefinition(state, *nested);
  } else if (const auto item = evaluate(state, obtain.source, Use::definition)) {
    state.report(diagnose(obtain.source.span, diag::ObtainSource, describe(*item)));
  }
  const std::string_view type = spell(obtain.type);
  if (source && source->type != obtain.type) {
    Item item{source, obtain.source.span};
    reportAt(state, obtain.source.span,
             fail(diag::ObtainOtherType, type, describe(item), spell(source->type)), {item});
    source = nullptr;
  } else if (source && canonicalCount(source->type) == 0) {
    state.report(diagnose(obtain.source.span, diag::ObtainVariable, type));
    source = nullptr;
  } else if (source && obtain.targets.size() > source->canon.size()) {
    state.report(diagnose(state.statement->span, diag::ObtainItems, obtain.targets.size(), type,
                          source->canon.size()));
  }
  if (source && state.program.dialect == "apt360") {
    source = brought(state, source, Use::definition, obtain.source.span);
  }
  for (std::size_t i = 0; i < obtain.targets.size(); ++i) {
    if (!obtain.targets[i]) {
      continue;
    }
    const ir::Target& target = *obtain.targets[i];
    const ir::Symbol& symbol = state.program[target.symbol];
    if (symbol.kind == ir::Symbol::Kind::entity) {
      state.report(diagnose(target.span, diag::ObtainNotScalar, symbol.name, spell(symbol.type)));
      continue;
    }
    const bool has = source && i < source->canon.size();
    assign(state, target, has ? std::optional<double>(source->canon[i]) : std::nullopt);
  }
}

}  // namespace arelem::runtime::interpret
