#pragma once
#include <cstdint>
#include <vector>

#include "ir/limits.h"
#include "ir/program/program.h"
#include "runtime/run.h"

namespace arelem::runtime::interpret {

/// Where a name or an array element is kept. `element` is 0 for a plain name.
struct Place {
  ir::SymbolId symbol;
  std::uint32_t element = 0;
  std::uint32_t slot = 0;
};

/// `poisoned`: its definition failed and was reported, so that uses stay silent; `lost`: the same
/// after it once had a value.
enum class Status : std::uint8_t { empty, poisoned, lost, defined };

/// The values of all names, flat by kind, in order of first definition.
class Store {
 public:
  /// `history`: every definition of an entity is kept, not the last of each place alone.
  Store(const ir::Program& program, const Limits& limits, bool history);

  [[nodiscard]] bool isEntity(const Place& place) const {
    return program_[place.symbol].kind == ir::Symbol::Kind::entity;
  }
  /// `element` is 0 for a plain name and 1 to the size for an array; the caller has checked it.
  [[nodiscard]] Place place(ir::SymbolId symbol, std::uint32_t element) const {
    return {symbol, element, base_[symbol.index] + (element == 0 ? 0U : element - 1U)};
  }
  [[nodiscard]] std::uint32_t arraySize(ir::SymbolId symbol) const { return size_[symbol.index]; }

  [[nodiscard]] Status scalarStatus(const Place& place) const { return scalarStatus_[place.slot]; }
  [[nodiscard]] double scalar(const Place& place) const { return scalars_[place.slot]; }
  void setScalar(const Place& place, double value, const Span& definition) {
    scalars_[place.slot] = value;
    Status& status = scalarStatus_[place.slot];
    if (status < Status::lost) {
      remember(place, definition);
    }
    status = Status::defined;
  }

  [[nodiscard]] Status entityStatus(const Place& place) const { return entityStatus_[place.slot]; }
  [[nodiscard]] const EntityPtr& entity(const Place& place) const { return entities_[place.slot]; }
  void setEntity(const Place& place, EntityPtr entity);

  /// A nested definition without a name; executed again it replaces its earlier result.
  void setUnnamed(ir::DefinitionId definition, EntityPtr entity);
  void poison(const Place& place);

  /// Everything defined, in order of first definition.
  [[nodiscard]] std::vector<Defined> defined() const;
  /// Every definition, in order of execution; scalars as in defined(). Empty unless kept.
  [[nodiscard]] std::vector<Defined> history() const;
  /// The rows of history() so far.
  [[nodiscard]] std::uint64_t historySize() const { return history_ ? order_.size() : 0; }

 private:
  struct Entry {
    Place place;
    ir::DefinitionId unnamed;
    Span definition;
    bool first = true;
    EntityPtr kept;  // what was defined then; null for scalars and without a history
  };
  void remember(const Place& place, const Span& definition) {
    order_.push_back({place, {}, definition, true, nullptr});
  }
  [[nodiscard]] Defined row(const Entry& entry) const;

  bool history_;
  const ir::Program& program_;
  std::vector<std::uint32_t> base_;  // first slot, by symbol
  std::vector<std::uint32_t> size_;  // 0 unless an array, by symbol
  std::vector<double> scalars_;
  std::vector<Status> scalarStatus_;
  std::vector<EntityPtr> entities_;
  std::vector<Status> entityStatus_;
  std::vector<EntityPtr> unnamed_;  // by definition
  std::vector<Entry> order_;
};

}  // namespace arelem::runtime::interpret
