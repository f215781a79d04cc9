#include "runtime/interpret/store.h"

#include <algorithm>

namespace arelem::runtime::interpret {

Store::Store(const ir::Program& program, const Limits& limits, bool history)
    : history_(history), program_(program), unnamed_(program.definitions.size()) {
  std::uint32_t scalars = 0;
  std::uint32_t entities = 0;
  for (const ir::Symbol& symbol : program.symbols) {
    const auto size =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(symbol.arraySize, limits.array));
    std::uint32_t& next = symbol.kind == ir::Symbol::Kind::entity ? entities : scalars;
    base_.push_back(next);
    size_.push_back(size);
    next += std::max(size, 1U);
  }
  scalars_.resize(scalars);
  scalarStatus_.resize(scalars);
  entities_.resize(entities);
  entityStatus_.resize(entities);
}

void Store::setEntity(const Place& place, EntityPtr entity) {
  Status& status = entityStatus_[place.slot];
  const bool first = status < Status::lost;
  if (first || history_) {
    order_.push_back({place, {}, entity->definition, first, history_ ? entity : nullptr});
  }
  status = Status::defined;
  entities_[place.slot] = std::move(entity);
}

void Store::setUnnamed(ir::DefinitionId definition, EntityPtr entity) {
  EntityPtr& kept = unnamed_[definition.index];
  if (!kept || history_) {
    order_.push_back({{}, definition, entity->definition, !kept, history_ ? entity : nullptr});
  }
  kept = std::move(entity);
}

void Store::poison(const Place& place) {
  Status& status = isEntity(place) ? entityStatus_[place.slot] : scalarStatus_[place.slot];
  status = status >= Status::lost ? Status::lost : Status::poisoned;
}

Defined Store::row(const Entry& entry) const {
  Defined d;
  d.definition = entry.definition;
  if (entry.unnamed.valid()) {
    d.entity = unnamed_[entry.unnamed.index];
    return d;
  }
  d.name = program_[entry.place.symbol].name;
  d.subscript = static_cast<int>(entry.place.element);
  if (isEntity(entry.place)) {
    d.entity = entities_[entry.place.slot];
    d.definition = d.entity->definition;
  } else {
    d.scalar = scalars_[entry.place.slot];
  }
  return d;
}

std::vector<Defined> Store::defined() const {
  std::vector<Defined> all;
  for (const Entry& entry : order_) {
    if (entry.first) {
      all.push_back(row(entry));
    }
  }
  return all;
}

std::vector<Defined> Store::history() const {
  std::vector<Defined> all;
  if (!history_) {
    return all;
  }
  all.reserve(order_.size());
  for (const Entry& entry : order_) {
    Defined& d = all.emplace_back(row(entry));
    if (entry.kept) {
      d.entity = entry.kept;
      d.definition = entry.definition;
    }
  }
  return all;
}

}  // namespace arelem::runtime::interpret
