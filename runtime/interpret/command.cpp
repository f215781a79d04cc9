#include "runtime/interpret/command.h"

#include "ir/diag/interpret.h"
#include "ir/words/units.h"
#include "runtime/interpret/cl_statement.h"
#include "runtime/interpret/printing.h"

namespace arelem::runtime::interpret {

namespace {

/// WORD/{ON|OFF}: none with a report otherwise.
std::optional<bool> onOff(State& state, const ir::Command& command) {
  if (command.arguments.size() == 1) {
    if (const Word* word = std::get_if<Word>(&command.arguments[0].value)) {
      if (*word == Word::ON || *word == Word::OFF) {
        return *word == Word::ON;
      }
    }
  }
  const std::string_view name = spell(command.word);
  if (const auto items = evaluate(state, command.arguments, Use::motion)) {
    state.report(diagnose(state.statement->span, diag::CommandForm, name, describe(*items),
                          fmt::format("{0}/ON and {0}/OFF", name)));
  }
  return std::nullopt;
}

void canon(State& state, const ir::Command& command) {
  if (const std::optional<bool> on = onOff(state, command)) {
    state.redefinable = *on;
  }
}

void units(State& state, const ir::Command& command) {
  if (command.arguments.size() == 1) {
    if (const Word* unit = std::get_if<Word>(&command.arguments[0].value);
        unit != nullptr &&
        (*unit == Word::MM || *unit == Word::CM || *unit == Word::INCHES || *unit == Word::FEET)) {
      if (state.carried.unit && *state.carried.unit != *unit) {
        state.report(diagnose(state.statement->span, diag::UnitChanged, spell(*unit),
                              spell(*state.carried.unit)));
      }
      state.context.millimeters = millimetersOf(*unit);
      state.carried.toldOfUnits = state.carried.toldOfUnits && state.carried.unit == *unit;
      state.carried.unit = *unit;
      state.emit(Pass{cl::Units{*unit}});
      return;
    }
  }
  state.report(diagnose(state.statement->span, diag::CommandForm, "UNITS",
                        fmt::format("{} parameters", command.arguments.size()),
                        "UNITS/{MM|CM|INCHES|FEET}"));
}

void inputOutput(State& state, const ir::Command& command) {
  switch (command.word) {
    case Word::PRINT:
      print(state, command);
      return;
    case Word::PUNCH:
      punch(state, command);
      return;
    default: {
      const auto items = evaluate(state, command.arguments, Use::motion);
      const bool first = items && !items->empty() && items->front().number() != nullptr;
      state.report(diagnose(state.statement->span, diag::ReadUnsupported,
                            first ? fmt::format("{}", *items->front().number()) : "..."));
    }
  }
}

/// The arc record of CL files.
void arcRecord(State& state, const ir::Command& command) {
  if (const auto items = evaluate(state, command.arguments, Use::motion)) {
    arcStatement(state, spell(command.word), *items);
  }
}

void other(State& state, const ir::Command& command) {
  switch (command.word) {
    case Word::BEVELS:
    case Word::DMILL:
      state.ignore(std::string(spell(command.word)), "the old system never described it");
      return;
    case Word::CIRCLE:
      arcRecord(state, command);
      return;
    default:
      state.report(diagnose(state.statement->span, diag::Unsupported, spell(command.word),
                            "the word does not begin a statement that can be executed"));
  }
}

}  // namespace

void execute(State& state, const ir::Command& command) {
  switch (row(command.word).wordClass) {
    case WordClass::arelemValue:
      command.word == Word::TLAXIS ? toolAxis(state, command) : motionParameter(state, command);
      return;
    case WordClass::arelemSwitch:
      command.word == Word::BEVELS || command.word == Word::DMILL ? other(state, command)
                                                                  : toggle(state, command);
      return;
    case WordClass::inputOutput:
      inputOutput(state, command);
      return;
    case WordClass::zsurf:
      zsurf(state, command);
      return;
    case WordClass::refsys:
      referenceSystem(state, command);
      return;
    case WordClass::pocket:
      pocket(state, command);
      return;
    case WordClass::psis:
      partSurface(state, command);
      return;
    case WordClass::debug:
    case WordClass::runControl:
    case WordClass::tuneup:
      runControl(state, command);
      return;
    case WordClass::motion:
      direction(state, command);
      return;
    case WordClass::toolPosition:
      state.emit(ToolRelation{command.word});
      if (state.program.dialect == "apt360") {
        state.emit(Toggle{Word::TLON, true});  // of a tool end on a line: differences-motion.md
      }
      return;
    case WordClass::canon:
      canon(state, command);
      return;
    case WordClass::stencil:
      command.word == Word::ENGRAV ? engrave(state, command) : stencil(state, command);
      return;
    case WordClass::units:
      units(state, command);
      return;
    case WordClass::spray:
      spray(state, command);
      return;
    case WordClass::modifier:
      command.word == Word::FAN ? post(state, command) : other(state, command);
      return;
    case WordClass::transformation:
    case WordClass::postWithParameters:
    case WordClass::postWithoutParameters:
      post(state, command);
      return;
    case WordClass::loopBracket:
    case WordClass::macroBracket:
      return;  // a place for labels: loops and macros are laid out by the frontend
    default:
      other(state, command);
  }
}

void execute(State& state, const ir::Text& text) {
  if (text.word == Word::TITLES) {
    title(state, text);
  } else if (text.word != Word::REMARK) {
    state.emit(Pass{cl::Text{text.word, text.text}});
  }
}

void zsurf(State& state, const ir::Command& command) {
  const auto items = evaluate(state, command.arguments, Use::definition);
  if (!items) {
    return;
  }
  std::array<double, 4> p{};
  const EntityPtr* plane = items->size() == 1 ? items->front().entity(EntityType::plane) : nullptr;
  bool good = plane != nullptr || items->size() == 4;
  for (std::size_t i = 0; i < 4 && good; ++i) {
    if (plane != nullptr) {
      p[i] = (*plane)->canon[i];
    } else if (const double* number = (*items)[i].number()) {
      p[i] = *number;
    } else {
      good = false;
    }
  }
  if (!good) {
    state.report(diagnose(state.statement->span, diag::ZsurfForm, describe(*items)));
    return;
  }
  if (p[2] == 0.0) {
    reportAt(state, state.statement->span, fail(diag::ZsurfVertical), *items);
    return;
  }
  state.context.zsurfA = p[0];
  state.context.zsurfB = p[1];
  state.context.zsurfC = p[2];
  state.context.zsurfD = p[3];
}

void referenceSystem(State& state, const ir::Command& command) {
  const auto items = evaluate(state, command.arguments, Use::definition);
  if (!items) {
    return;
  }
  if (items->size() == 1 && items->front().is(Word::NOMORE)) {
    state.systems.leave();
    return;
  }
  const EntityPtr* matrix =
      items->size() == 1 ? items->front().entity(EntityType::matrix) : nullptr;
  if (matrix == nullptr) {
    state.report(diagnose(state.statement->span, diag::SystemForm, describe(*items)));
  } else if ((*matrix)->name.empty()) {
    state.report(diagnose(items->front().span, diag::SystemUnnamed));
  } else if (std::optional<Failure> failure = state.systems.enter(**matrix)) {
    reportAt(state, items->front().span, *std::move(failure), *items);
  }
}

/// DEBUG/ [{SEC1|SEC2},] {ON|OFF}: what of Section 1 (values) or 2 (motion) is traced from here on.
void debug(State& state, const ir::Command& command) {
  std::vector<Word> words;
  for (const ir::Argument& argument : command.arguments) {
    const Word* word = std::get_if<Word>(&argument.value);
    words.push_back(word == nullptr ? Word::END : *word);
  }
  const bool one = words.size() == 2 && (words[0] == Word::SEC1 || words[0] == Word::SEC2);
  const Word last = words.empty() ? Word::END : words.back();
  if ((words.size() != 1 && !one) || (last != Word::ON && last != Word::OFF)) {
    if (const auto items = evaluate(state, command.arguments, Use::motion)) {
      state.report(diagnose(state.statement->span, diag::CommandForm, spell(command.word),
                            describe(*items), "DEBUG/ON, DEBUG/OFF, DEBUG/SEC1,ON, DEBUG/SEC2,ON"));
    }
    return;
  }
  if (!one || words[0] == Word::SEC1) {
    state.tracing = last == Word::ON;
  }
  if (!one || words[0] == Word::SEC2) {
    state.emit(Toggle{Word::DEBUG, last == Word::ON});
  }
}

void runControl(State& state, const ir::Command& command) {
  const std::string name(spell(command.word));
  if (command.word == Word::CLPRNT && command.slash) {
    const Word* word =
        command.arguments.size() == 1 ? std::get_if<Word>(&command.arguments[0].value) : nullptr;
    if (word != nullptr && *word == Word::OPTION) {
      state.ignore("CLPRNT/OPTION", "the listing always shows the final records");
    } else if (const std::optional<bool> on = onOff(state, command)) {
      state.emit(Pass{cl::Listing{*on}});
    }
    return;
  }
  switch (command.word) {
    case Word::CLPRNT:
      state.ignore(name, "a listing is an output of its own");
      return;
    case Word::NOPOST:
    case Word::NOPLOT:
    case Word::PTONLY:
      state.ignore(name, "outputs and sections are chosen when the compiler is called");
      return;
    case Word::DEBUG:
      debug(state, command);
      return;
    case Word::DYNDMP:
      state.ignore(name, "it traced the old system's own routines");
      return;
    default:
      state.ignore(name, "it set up the old system's machine");
  }
}

}  // namespace arelem::runtime::interpret
