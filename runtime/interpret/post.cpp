#include "ir/diag/interpret.h"
#include "runtime/interpret/cl_statement.h"
#include "runtime/interpret/command.h"
#include "runtime/interpret/post_arguments.h"
#include "runtime/interpret/refuse.h"
#include "runtime/interpret/swarf_form.h"

namespace arelem::runtime::interpret {

namespace {

constexpr std::string_view copyForms =
    "COPY/i,SAME,n, COPY/i,TRANSL,x,y,z,n, COPY/i,XYROT,degrees,n and COPY/i,MODIFY,matrix,n";

/// Words that steer the program itself are no parameters of a machine.
bool isParameterWord(Word word) {
  switch (row(word).wordClass) {
    case WordClass::motion:
    case WordClass::toolPosition:
    case WordClass::ifWord:
    case WordClass::jumpto:
    case WordClass::call:
    case WordClass::loopBracket:
    case WordClass::macroBracket:
    case WordClass::function:
    case WordClass::fini:
    case WordClass::obtain:
    case WordClass::reserv:
    case WordClass::syn:
      return false;
    default:
      return true;
  }
}

/// Which entities a post word takes, by the way it is given.
enum class Takes : std::uint8_t { nothing, surface, matrix };

Takes takes(const std::optional<Word>& word) {
  if (!word) {
    return Takes::nothing;
  }
  switch (*word) {
    case Word::CLEARP:
    case Word::CLRSRF:
      return Takes::surface;
    case Word::TRACUT:
    case Word::COPY:
    case Word::TRANS:
      return Takes::matrix;
    default:
      return Takes::nothing;
  }
}

bool isSurfaceType(EntityType type) {
  return type != EntityType::point && type != EntityType::vector && type != EntityType::matrix &&
         type != EntityType::pattern;
}

cl::SurfaceValue surfaceValue(const Entity& e) {
  return {e.type, e.name, e.subscript, e.canon};
}

/// The parameters as a CL record holds them; none when one is not allowed.
std::optional<std::vector<cl::Value>> values(State& state,
                                             std::string_view name,
                                             const std::optional<Word>& word,
                                             const Items& items) {
  std::vector<cl::Value> result;
  bool good = true;
  for (const Item& item : items) {
    if (const double* number = item.number()) {
      result.emplace_back(*number);
    } else if (const Word* minor = std::get_if<Word>(&item.value)) {
      if (!isParameterWord(*minor)) {
        state.report(diagnose(item.span, diag::PostWord, name, spell(*minor)));
        good = false;
      }
      result.emplace_back(*minor);
    } else if (const std::string* text = std::get_if<std::string>(&item.value)) {
      result.emplace_back(*text);
    } else if (const EntityPtr* entity = item.entity()) {
      const Takes allowed = takes(word);
      const bool isMatrix = (*entity)->type == EntityType::matrix;
      if (allowed == Takes::nothing) {
        state.report(diagnose(item.span, diag::PostSurface, name, describe(item)));
        good = false;
      } else if (allowed == Takes::matrix ? !isMatrix : !isSurfaceType((*entity)->type)) {
        state.report(diagnose(item.span, diag::PostSurfaceType, name, describe(item)));
        good = false;
      }
      result.emplace_back(surfaceValue(**entity));
    } else {
      state.report(diagnose(item.span, diag::PostWord, name, describe(item)));
      good = false;
    }
  }
  return good ? std::optional(std::move(result)) : std::nullopt;
}

/// Whether items[from] on are `count` numbers and nothing more.
bool numbersFrom(const Items& items, std::size_t from, std::size_t count) {
  if (items.size() != from + count) {
    return false;
  }
  for (std::size_t i = from; i < items.size(); ++i) {
    if (items[i].number() == nullptr) {
      return false;
    }
  }
  return true;
}

bool isTracut(const Items& items) {
  return items.size() == 1 &&
         (items[0].is(Word::NOMORE) || items[0].entity(EntityType::matrix) != nullptr);
}

bool isIndex(const Items& items) {
  const bool ends = items.size() == 2 && items[1].is(Word::NOMORE);
  return (items.size() == 1 || ends) && items[0].number() != nullptr;
}

bool isCopy(const Items& items) {
  if (items.size() < 3 || items[0].number() == nullptr) {
    return false;
  }
  return (items[1].is(Word::SAME) && numbersFrom(items, 2, 1)) ||
         (items[1].is(Word::TRANSL) && numbersFrom(items, 2, 4)) ||
         (items[1].is(Word::XYROT) && numbersFrom(items, 2, 2)) ||
         (items[1].is(Word::MODIFY) && items[2].entity(EntityType::matrix) != nullptr &&
          numbersFrom(items, 3, 1));
}

/// The forms that Section 3 executes are checked here, where the text is known.
bool checkTransformation(State& state, Word word, const Items& items) {
  const Span& span = state.statement->span;
  if (word == Word::TRACUT && !isTracut(items)) {
    state.report(diagnose(span, diag::TracutForm, describe(items)));
    return false;
  }
  if (word == Word::INDEX && !isIndex(items)) {
    state.report(
        diagnose(span, diag::CopyForm, "INDEX", describe(items), "INDEX/i and INDEX/i,NOMORE"));
    return false;
  }
  if (word == Word::COPY && !isCopy(items)) {
    state.report(diagnose(span, diag::CopyForm, "COPY", describe(items), copyForms));
    return false;
  }
  return (word != Word::VTLAXS && word != Word::WCORN) || checkSwarf(state, word, items);
}

}  // namespace

void post(State& state, const ir::Command& command) {
  const Word word = command.word;
  const std::string_view name = spell(word);
  const auto items = evaluate(state, command.arguments, Use::motion);
  if (!items || !checkTransformation(state, word, *items) || !checkFeed(state, name, *items)) {
    return;
  }
  checkFeedUnits(state, name, *items);
  checkPostArguments(state, word, *items);
  // The front end tells of it; this is for programs that are built otherwise.
  const bool untold = state.program.dialect.empty();
  if (row(word).wordClass == WordClass::postWithoutParameters && !items->empty() && untold) {
    state.report(diagnose(state.statement->span, diag::PostParameters, name, items->size()));
  }
  if (auto arguments = values(state, name, word, *items)) {
    if (word == Word::FAN) {  // a modifier by its class, so it has no number on a tape
      state.emit(Pass{cl::Post{Word::END, "FAN", *std::move(arguments)}});
      return;
    }
    cl::Post out{word, "", *std::move(arguments)};
    turnTable(state, out);
    state.emit(Pass{std::move(out)});
  }
}

void execute(State& state, const ir::ForeignCommand& command) {
  const auto items = evaluate(state, command.arguments, Use::motion);
  if (!items || arcStatement(state, command.word, *items)) {
    return;
  }
  if (command.word == "REFUSE" && (state.calls != nullptr || state.program.dialect != "cl")) {
    return refuse(state, *items);
  }
  frameStatement(state, command.word, *items);
  if (auto arguments = values(state, command.word, std::nullopt, *items)) {
    state.emit(Pass{cl::Post{Word::END, command.word, *std::move(arguments)}});
  }
}

}  // namespace arelem::runtime::interpret
