#include "runtime/interpret/printing.h"

#include "ir/diag/interpret.h"
#include "ir/diag/limits.h"
#include "runtime/interpret/expression.h"

namespace arelem::runtime::interpret {

namespace {

constexpr std::string_view printForms =
    "PRINT/ON, PRINT/OFF, PRINT/0 and PRINT/mode,{names|ALL} with mode 1 to 4";
constexpr std::string_view punchForms = "PUNCH/{1|2|3},{names|ALL}";

bool isLarge(EntityType type) {
  return canonicalCount(type) == 0;
}

/// Collects what a list of names asks for, in its order.
class Selection {
 public:
  /// ALL leaves out the types of many numbers unless `large`.
  Selection(State& state, int mode, bool large = false)
      : state_(state), mode_(mode), large_(large) {}

  std::vector<Printed> take(const std::vector<ir::Argument>& arguments, std::size_t first) {
    for (std::size_t i = first; i < arguments.size(); ++i) {
      argument_ = &arguments[i];
      std::visit(*this, argument_->value);
    }
    return std::move(list_);
  }

  void operator()(const ir::Omitted&) {}
  void operator()(Word word) {
    if (word == Word::ALL) {
      all();
    } else {
      wrong(fmt::format("the word {}", spell(word)));
    }
  }
  /// A name that the program never gives a value.
  void operator()(const std::string& text) {
    Printed& p = row();
    p.name = text;
    p.undefined = true;
  }
  void operator()(const ir::Target& target) { named(target); }
  void operator()(ir::ExprId id) {
    const ir::Expr& expr = state_.program[id];
    if (expr.kind == ir::Expr::Kind::symbol) {
      named(expr.target);
    } else if (const std::optional<double> value = scalar(state_, id)) {
      row().scalar = *value;
    }
  }
  void operator()(ir::DefinitionId) {
    if (const auto item = evaluate(state_, *argument_, Use::definition)) {
      row().entity = *item->entity();
    }
  }
  void operator()(const ir::ElementRange& range) {
    if (const auto list = elements(state_, range)) {
      for (const std::uint32_t element : *list) {
        put(state_.store.place(range.symbol, element));
      }
    }
  }

 private:
  Printed& row() {
    Printed& p = list_.emplace_back();
    p.isn = static_cast<int>(state_.statement->isn);
    p.mode = mode_;
    return p;
  }
  void named(const ir::Target& target) {
    if (const auto place = state_.place(target)) {
      put(*place);
    }
  }
  void put(const Place& place) {
    Printed& p = row();
    p.name = state_.program[place.symbol].name;
    p.subscript = static_cast<int>(place.element);
    if (state_.store.isEntity(place)) {
      p.undefined = state_.store.entityStatus(place) != Status::defined;
      p.entity = p.undefined ? nullptr : asSeen(state_.store.entity(place));
    } else {
      p.undefined = state_.store.scalarStatus(place) != Status::defined;
      p.scalar = p.undefined ? 0.0 : state_.store.scalar(place);
    }
  }
  /// Printing is a use: what was defined in another reference system is shown in the one in force,
  /// under the type that it was defined with. What cannot be moved is shown as it is.
  [[nodiscard]] EntityPtr asSeen(const EntityPtr& entity) const {
    const auto moved = state_.systems.seenFrom(entity, state_.systems.current());
    if (!moved || *moved == entity) {
      return entity;
    }
    auto shown = std::make_shared<Entity>(**moved);
    shown->type = entity->type;
    return shown;
  }
  void all() {
    for (Defined& d : state_.store.defined()) {
      if (d.name.empty() || (d.entity && isLarge(d.entity->type) && !large_)) {
        continue;
      }
      Printed& p = row();
      p.name = std::move(d.name);
      p.subscript = d.subscript;
      p.entity = d.entity ? asSeen(d.entity) : nullptr;
      p.scalar = d.scalar;
    }
  }
  void wrong(const std::string& what) {
    state_.report(diagnose(argument_->span, diag::PrintForm, "PRINT", what, printForms));
  }

  State& state_;
  int mode_;
  bool large_;
  const ir::Argument* argument_ = nullptr;
  std::vector<Printed> list_;
};

/// The number after PRINT/ or PUNCH/, or none with a report.
std::optional<int> mode(State& state,
                        const ir::Command& command,
                        std::string_view word,
                        int low,
                        int high,
                        std::string_view forms) {
  const auto* expr =
      command.arguments.empty() ? nullptr : std::get_if<ir::ExprId>(&command.arguments[0].value);
  if (expr == nullptr) {
    state.report(diagnose(state.statement->span, diag::PrintForm, word, "no mode number", forms));
    return std::nullopt;
  }
  const std::optional<double> value = scalar(state, *expr);
  if (!value) {
    return std::nullopt;
  }
  const int number = *value >= low && *value <= high ? static_cast<int>(*value) : low - 1;
  if (number < low || number != *value) {
    state.report(diagnose(command.arguments[0].span, diag::PrintForm, word,
                          fmt::format("the mode {}", *value), forms));
    return std::nullopt;
  }
  return number;
}

/// One line of a deck: name,subscript,type,count,values; numbers in shortest round-trip form.
void punchLine(State& state, const Printed& p) {
  std::string& deck = state.out.deck;
  if (p.undefined) {
    return;
  }
  deck += p.entity ? fmt::format("{},{},{},{}", p.name, p.subscript, spell(p.entity->type),
                                 p.entity->canon.size())
                   : fmt::format("{},{},SCALAR,1,{}", p.name, p.subscript, p.scalar);
  if (p.entity) {
    for (const double value : p.entity->canon) {
      deck += fmt::format(",{}", value);
    }
  }
  deck += '\n';
}

void punchAll(State& state, const std::vector<Printed>& list, int mode) {
  for (const Printed& p : list) {
    if (p.name.empty()) {
      state.report(
          diagnose(state.statement->span, diag::PrintForm, "PUNCH", "an unnamed item", punchForms));
    } else if (mode == 1 || (mode == 3) == (p.entity != nullptr)) {
      punchLine(state, p);
    }
  }
  state.out.deck += "ENDPCH\n";
}

void listRows(State& state, std::vector<Printed> rows) {
  for (Printed& row : rows) {
    if (state.out.printed.size() >= state.options.limits.records) {
      state.report(
          diagnose(state.statement->span, diag::LimitRecords, state.options.limits.records));
      state.stopped = true;
      return;
    }
    state.out.printed.push_back(std::move(row));
  }
}

}  // namespace

void print(State& state, const ir::Command& command) {
  if (command.arguments.size() == 1) {
    if (const Word* word = std::get_if<Word>(&command.arguments[0].value);
        word != nullptr && (*word == Word::ON || *word == Word::OFF)) {
      state.listing = *word == Word::ON;
      return;
    }
  }
  const std::optional<int> number = mode(state, command, "PRINT", 0, 4, printForms);
  if (!number) {
    return;
  }
  std::vector<Printed> rows;
  if (*number == 0) {
    rows.emplace_back();  // a page: a title line without text
    rows.back().isn = static_cast<int>(state.statement->isn);
    rows.back().mode = 0;
  } else {
    rows = Selection(state, *number).take(command.arguments, 1);
  }
  if (*number == 4) {
    punchAll(state, rows, 1);
  }
  listRows(state, std::move(rows));
}

void punch(State& state, const ir::Command& command) {
  if (const std::optional<int> number = mode(state, command, "PUNCH", 1, 3, punchForms)) {
    punchAll(state, Selection(state, *number, true).take(command.arguments, 1), *number);
  }
}

void title(State& state, const ir::Text& text) {
  Printed p;
  p.isn = static_cast<int>(state.statement->isn);
  p.title = text.text;
  std::vector<Printed> rows;
  rows.push_back(std::move(p));
  listRows(state, std::move(rows));
}

namespace {
/// `L1 = LINE 0 1 0 5`, without the values of types that have hundreds.
std::string shown(const Entity& entity) {
  std::string text =
      fmt::format("{} = {}", entity.name.empty() ? "unnamed" : nameOf(entity), spell(entity.type));
  if (!isLarge(entity.type)) {
    for (const double value : entity.canon) {
      text += fmt::format(" {}", value);
    }
  }
  return text;
}
}  // namespace

void listDefinition(State& state, const EntityPtr& entity) {
  if (state.tracing) {
    state.trace(shown(*entity));
  }
  if (!state.listing) {
    return;
  }
  Printed p;
  p.isn = static_cast<int>(state.statement->isn);
  p.name = entity->name;
  p.subscript = entity->subscript;
  p.entity = entity;
  std::vector<Printed> rows;
  rows.push_back(std::move(p));
  listRows(state, std::move(rows));
}

}  // namespace arelem::runtime::interpret
