#include <algorithm>
#include <cmath>

#include "ir/diag/interpret.h"
#include "runtime/interpret/command.h"
#include "runtime/interpret/motion.h"

namespace arelem::runtime::interpret {

namespace {

/// The numbers of a statement that takes nothing else; none with a report.
std::optional<std::vector<double>> numbers(State& state,
                                           std::string_view word,
                                           const Items& items,
                                           std::string_view forms) {
  std::vector<double> result;
  for (const Item& item : items) {
    const double* number = item.number();
    if (number == nullptr) {
      state.report(diagnose(item.span, diag::MotionOperand, word, describe(item), forms));
      return std::nullopt;
    }
    result.push_back(*number);
  }
  return result;
}

/// What a value of the parameter must be, or "" when it is good.
std::string_view rule(Word word, double value) {
  switch (word) {
    case Word::INTOL:
    case Word::OUTTOL:
    case Word::TOLER:
      return value >= 0.0 ? "" : "a tolerance is not negative";
    case Word::MAXDP:
      return value > 0.0 ? "" : "the longest cut vector is positive";
    case Word::NUMPTS:
      return value >= 1.0 && std::trunc(value) == value
                 ? ""
                 : "the number of cut vectors is whole and at least 1";
    default:
      return "";
  }
}

std::string_view parameterForms(Word word) {
  switch (word) {
    case Word::CUTTER:
      return "CUTTER/d, CUTTER/d,r, CUTTER/d,r,e,f,a,b,h and CUTTER/OPTION,{1|2},{ra,hi|OFF}";
    case Word::MAXDP:
      return "MAXDP/length";
    case Word::NUMPTS:
      return "NUMPTS/n";
    case Word::INTOL:
      return "INTOL/ps[,ds[,cs1[,cs2]]]";
    case Word::OUTTOL:
      return "OUTTOL/ps[,ds[,cs1[,cs2]]]";
    case Word::TOLER:
      return "TOLER/ps[,ds[,cs1[,cs2]]]";
    default:
      return "THICK/ps[,ds[,cs1[,cs2]]]";
  }
}

bool countFits(Word word, std::size_t count) {
  switch (word) {
    case Word::CUTTER:
      return count == 1 || count == 2 || count == 7;
    case Word::MAXDP:
    case Word::NUMPTS:
      return count == 1;
    default:
      return count >= 1 && count <= 4;
  }
}

/// CUTTER/OPTION,{1|2},{ra,hi|OFF}; items[0] is the word OPTION.
void cutterOption(State& state, const Items& items) {
  const std::string_view forms = parameterForms(Word::CUTTER);
  const Span& span = state.statement->span;
  const double* surface = items.size() > 1 ? items[1].number() : nullptr;
  if (surface == nullptr || (*surface != 1.0 && *surface != 2.0)) {
    state.report(diagnose(span, diag::MotionArguments, "CUTTER/OPTION", describe(items), forms));
    return;
  }
  CutterOption option{static_cast<int>(*surface), std::nullopt};
  if (items.size() == 3 && items[2].is(Word::OFF)) {
    state.emit(option);
    return;
  }
  const double* radius = items.size() == 4 ? items[2].number() : nullptr;
  const double* height = items.size() == 4 ? items[3].number() : nullptr;
  if (radius == nullptr || height == nullptr) {
    state.report(diagnose(span, diag::MotionArguments, "CUTTER/OPTION", describe(items), forms));
    return;
  }
  option.ring = std::array{*radius, *height};
  state.emit(option);
}

/// ON or OFF after a switch; a switch alone is on.
std::optional<bool> switched(State& state, const ir::Command& command) {
  if (command.arguments.empty()) {
    return true;
  }
  const auto items = evaluate(state, command.arguments, Use::motion);
  if (!items) {
    return std::nullopt;
  }
  const bool mayTurnOff =
      command.word == Word::MULTAX || command.word == Word::GOUGCK || command.word == Word::GOUGE;
  if (mayTurnOff && items->size() == 1 &&
      (items->front().is(Word::ON) || items->front().is(Word::OFF))) {
    return items->front().is(Word::ON);
  }
  if (command.word == Word::DNTCUT && items->size() == 1 && items->front().is(Word::PRINT)) {
    state.ignore("the PRINT of DNTCUT/PRINT", "suppressed points are in no record");
    return true;
  }
  const std::string_view name = spell(command.word);
  state.report(diagnose(
      state.statement->span, diag::MotionArguments, name, describe(*items),
      mayTurnOff ? fmt::format("{0}, {0}/ON and {0}/OFF", name) : fmt::format("{} alone", name)));
  return std::nullopt;
}

}  // namespace

void motionParameter(State& state, const ir::Command& command) {
  const auto items = evaluate(state, command.arguments, Use::motion);
  if (!items) {
    return;
  }
  if (command.word == Word::CUTTER && !items->empty() && items->front().is(Word::OPTION)) {
    cutterOption(state, *items);
    return;
  }
  const std::string_view name = spell(command.word);
  const std::string_view forms = parameterForms(command.word);
  auto given = numbers(state, name, *items, forms);
  if (!given) {
    return;
  }
  if (!countFits(command.word, given->size())) {
    state.report(
        diagnose(state.statement->span, diag::MotionArguments, name, describe(*items), forms));
    return;
  }
  for (std::size_t i = 0; i < given->size(); ++i) {
    if (const std::string_view broken = rule(command.word, (*given)[i]); !broken.empty()) {
      state.report(diagnose((*items)[i].span, diag::ParameterValue, name, (*given)[i], broken));
      return;
    }
  }
  state.emit(Parameter{command.word, *std::move(given)});
}

void toggle(State& state, const ir::Command& command) {
  if (const std::optional<bool> on = switched(state, command)) {
    state.multax = command.word == Word::MULTAX ? *on : state.multax;
    state.emit(Toggle{command.word == Word::GOUGE ? Word::GOUGCK : command.word, *on});
  }
}

void pocket(State& state, const ir::Command& command) {
  const auto items = evaluate(state, command.arguments, Use::motion);
  if (!items) {
    return;
  }
  Pocket action;
  bool eight = items->size() >= 8;
  for (std::size_t i = 0; i < 8 && eight; ++i) {
    const double* number = (*items)[i].number();
    eight = number != nullptr;
    action.parameters[i] = eight ? *number : 0.0;
  }
  if (!eight) {
    state.report(diagnose(state.statement->span, diag::PocketCount, describe(*items)));
    return;
  }
  for (std::size_t i = 8; i < items->size();) {
    if (const EntityPtr* point = (*items)[i].entity(EntityType::point)) {
      action.points.push_back(tripleOf(**point));
      ++i;
      continue;
    }
    std::array<double, 3> xyz{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double* number = i + k < items->size() ? (*items)[i + k].number() : nullptr;
      if (number == nullptr) {
        const Item& seen = (*items)[std::min(i + k, items->size() - 1)];
        state.report(
            diagnose(seen.span, diag::PocketPoints,
                     fmt::format("{} is not a point: write point names or x,y,z", describe(seen))));
        return;
      }
      xyz[k] = *number;
    }
    action.points.push_back(state.systems.pointToBase({xyz[0], xyz[1], xyz[2]}));
    i += 3;
  }
  if (action.points.size() < 3 || action.points.size() > 20) {
    state.report(diagnose(state.statement->span, diag::PocketPoints,
                          fmt::format("{} vertices: a pocket has 3 to 20", action.points.size())));
    return;
  }
  state.meetImplied("POCKET", false, true);
  state.emit(std::move(action));
}

}  // namespace arelem::runtime::interpret
