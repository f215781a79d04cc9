#include "frontend/check/statements.h"

#include "frontend/check/motion.h"
#include "frontend/check/old_number.h"
#include "frontend/lex/refusal.h"
#include "ir/define/matcher.h"
#include "ir/diag/frontend.h"

namespace arelem::frontend {

namespace {
using Kind = Node::Kind;

/// Words that may stand before another statement, separated by a comma.
bool isPrefix(Word word) {
  switch (row(word).wordClass) {
    case WordClass::toolPosition:
    case WordClass::postWithoutParameters:
    case WordClass::arelemSwitch:
    case WordClass::runControl:
      return true;
    default:
      return false;
  }
}
}  // namespace

void Statements::emitCommand(const Parts& p, std::vector<ir::Argument> list) {
  block_.emit(ir::Command{p.word, p.slash, std::move(list)});
}

/// Emits the words before the last one; `main` is the last one with its parameters.
bool Statements::prefixes(Parts& main) {
  const StatementTree& tree = values_.tree();
  NodeId id = tree.head;
  while (true) {
    const Node& node = tree[id];
    main = {node.word, node.span, tree.slash, tree.arguments};
    if (node.next == noNode) {
      return true;
    }
    const Node& after = tree[node.next];
    if (node.word == Word::OBTAIN) {
      return true;
    }
    if (!isPrefix(node.word) && !tree.slash) {  // CUTTER, OPTION, ... for CUTTER/ OPTION, ...
      main.first = node.next;
      main.slash = true;
      return true;
    }
    if (!isPrefix(node.word) || after.kind != Kind::word) {
      context_.report(diagnose(after.span, diag::Misplaced, fmt::format("`{}`", after.text)));
      return false;
    }
    if (row(node.word).wordClass == WordClass::runControl) {
      context_.reporter.used(ir::Feature::CR_11);
    }
    emitCommand({node.word, node.span, false, noNode}, {});
    id = node.next;
  }
}

void Statements::command() {
  Parts main;
  if (prefixes(main)) {
    dispatch(main);
  }
}

void Statements::assign() {
  const StatementTree& tree = values_.tree();
  const auto value = values_.expression(tree.value);
  const auto target = values_.target(tree.target, NameFacts::Class::scalar, {});
  values_.markDefined(tree.target);
  if (value && target) {
    block_.emit(ir::Assign{*target, *value});
  }
}

void Statements::define() {
  const StatementTree& tree = values_.tree();
  if (const auto id = values_.definition(tree.value, tree.target)) {
    context_.program.definitions[id->index].span = block_.origin().span;
    block_.emit(ir::Define{*id});
  }
}

void Statements::motion(const Parts& p) {
  Motion motion(context_, values_, block_);
  if (p.word == Word::FROM || p.word == Word::GOTO || p.word == Word::GODLTA) {
    motion.locate(p.word, p.span, p.first);
  } else if (p.word == Word::GO || p.word == Word::OFFSET) {
    motion.startup(p.word, p.span, p.first);
  } else if (row(p.word).type == 8000) {
    motion.follow(p.word, p.span, p.first);
  } else {
    plain(p, {.owner = spell(p.word), .omitted = true});
  }
}

void Statements::termac(const Parts& p) {
  if (block_.area() == BlockWriter::Area::macro) {
    emitCommand(p, {});
  } else {
    context_.report(diagnose(p.span, diag::TermacAlone));
  }
}

void Statements::dispatch(const Parts& p) {
  switch (row(p.word).wordClass) {
    case WordClass::fixedField:
      return context_.report(diagnose(p.span, diag::FixedFieldPlace, spell(p.word)));
    case WordClass::inputOutput:
      return print(p);
    case WordClass::obtain:
      return obtain(p);
    case WordClass::zsurf:
    case WordClass::psis:
      return surfaceOrNumbers(p);
    case WordClass::refsys:
      return refsys(p);
    case WordClass::jumpto:
    case WordClass::tranto: {
      const bool single = p.first == noNode || values_.tree()[p.first].next == noNode;
      return control_.jump(p.word, p.first, single);
    }
    case WordClass::loopBracket:
      p.word == Word::LOOPST ? control_.loopStart() : control_.loopEnd();
      return;
    case WordClass::pocket:
      return pocket(p);
    case WordClass::macroBracket:
      return termac(p);
    case WordClass::reserv:
      return reserv(p);
    case WordClass::fini:
      return fini(p);
    case WordClass::transformation:
    case WordClass::postWithParameters:
    case WordClass::postWithoutParameters:
      return postWord(p);
    case WordClass::geometry:
      return unnamed(p);
    case WordClass::runControl:
    case WordClass::debug:
      return runControl(p);
    case WordClass::motion:
      return motion(p);
    case WordClass::arelemValue:
    case WordClass::arelemSwitch:
    case WordClass::toolPosition:
    case WordClass::canon:
    case WordClass::tuneup:
    case WordClass::unused:
    case WordClass::spray:
      return plain(p, {.owner = spell(p.word)});
    case WordClass::units:
      return units(p);
    case WordClass::stencil:
      if (values_.tree()[values_.tree().head].text == refusal) {
        if (auto list = values_.arguments(p.first, {.owner = refusal, .strings = true})) {
          block_.emit(ir::ForeignCommand{std::string(refusal), true, *std::move(list)});
        }
        return;
      }
      return plain(p, {.owner = spell(p.word), .strings = true});
    case WordClass::call:
    case WordClass::ifWord:
    case WordClass::syn:
    case WordClass::libry:
    case WordClass::function:
    case WordClass::modifier:
    case WordClass::phase:
      break;
  }
  if (p.word == Word::FAN && p.slash) {  // the width of the spray, a word that robots' posts read
    postWord(p);
    return;
  }
  context_.report(diagnose(p.span, diag::Misplaced, fmt::format("the word `{}`", spell(p.word)))
                      .note("it is not a word that begins a statement"));
}

/// A trailing NOPOST, NOPLOT or PTONLY belongs to no parameter list: it is a statement of its own.
bool Statements::takeSuffix(std::vector<ir::Argument>& list, Word& suffix) const {
  const Word* word = list.empty() ? nullptr : std::get_if<Word>(&list.back().value);
  if (word == nullptr || row(*word).wordClass != WordClass::runControl) {
    return false;
  }
  context_.reporter.used(ir::Feature::CR_11);
  suffix = *word;
  list.pop_back();
  return true;
}

void Statements::plain(const Parts& p, ArgumentRules rules) {
  auto list = values_.arguments(p.first, rules);
  if (!list) {
    return;
  }
  Word suffix = Word::NOPOST;
  const bool split = takeSuffix(*list, suffix);
  const bool bare = row(p.word).wordClass == WordClass::toolPosition || p.word == Word::NOPS ||
                    p.word == Word::AUTOPS || p.word == Word::CUT || p.word == Word::NDTEST ||
                    p.word == Word::W_2DCALC || p.word == Word::W_3DCALC;
  if (bare && !list->empty()) {
    context_.report(diagnose(p.span, diag::ParametersNotAllowed, spell(p.word)));
    return;
  }
  const bool needs = row(p.word).wordClass == WordClass::arelemValue || p.word == Word::CANON ||
                     row(p.word).wordClass == WordClass::motion;
  if (needs && list->empty()) {
    const DiagRow& cause = row(p.word).wordClass == WordClass::arelemValue
                               ? old_number::valueMissing
                               : diag::ParameterExpectedRow;
    context_.report(old_number::as(
        cause, diagnose(p.span, diag::ParameterExpected, spell(p.word), "a parameter")));
    return;
  }
  emitCommand(p, std::move(*list));
  if (split) {
    emitCommand({suffix, p.span, false, noNode}, {});
  }
}

void Statements::units(const Parts& p) {
  if (p.first == noNode || values_.tree()[p.first].kind == Kind::name) {
    context_.report(diagnose(p.span, diag::ParameterExpected, "UNITS", "MM, CM, INCHES or FEET"));
    return;
  }
  plain(p, {.owner = spell(p.word)});
}

bool Statements::checkPostArguments(const Parts& p, const std::vector<ir::Argument>& list) {
  const bool surfaces = p.word == Word::CLEARP || p.word == Word::CLRSRF ||
                        p.word == Word::TRACUT || p.word == Word::COPY;
  for (const ir::Argument& a : list) {
    if (!surfaces && values_.entityOf(a)) {
      context_.report(diagnose(a.span, diag::SurfaceInPost, spell(p.word)));
      return false;
    }
  }
  if (row(p.word).wordClass == WordClass::postWithoutParameters && (p.slash || !list.empty())) {
    if (!context_.options.takes(&DialectRules::bareWordParameters)) {
      context_.report(diagnose(p.span, diag::ParametersNotAllowed, spell(p.word)));
      return false;
    }
    if (context_.options.warns(&DialectRules::bareWordParameters)) {
      context_.report(diagnose(p.span, diag::ParametersPassed, spell(p.word)));
    }
  }
  return true;
}

void Statements::postWord(const Parts& p) {
  const StatementTree& tree = values_.tree();
  ArgumentRules rules{.owner = spell(p.word)};
  rules.unknownAsText = context_.options.takes(&DialectRules::unknownPostText);
  rules.silentText = !context_.options.warns(&DialectRules::unknownPostText);
  std::vector<ir::Argument> list;
  NodeId rest = p.first;
  if (p.word == Word::MACHIN) {
    if (rest == noNode || (tree[rest].kind != Kind::name && tree[rest].kind != Kind::word)) {
      context_.report(
          diagnose(p.span, diag::ParameterExpected, "MACHIN", "the name of a postprocessor"));
      return;
    }
    list.push_back({std::string(tree[rest].text), tree[rest].span});
    rest = tree[rest].next;
  }
  auto more = values_.arguments(rest, rules);
  if (!more) {
    return;
  }
  list.insert(list.end(), std::make_move_iterator(more->begin()),
              std::make_move_iterator(more->end()));
  Word suffix = Word::NOPOST;
  const bool split = takeSuffix(list, suffix);
  if (checkPostArguments(p, list)) {
    emitCommand(p, std::move(list));
    if (split) {
      emitCommand({suffix, p.span, false, noNode}, {});
    }
  }
}

void Statements::runControl(const Parts& p) {
  auto list = values_.arguments(p.first, {.owner = spell(p.word)});
  if (!list) {
    return;
  }
  const bool none = p.word == Word::NOPOST || p.word == Word::NOPLOT;
  if (none && !list->empty()) {
    context_.report(diagnose(p.span, diag::ParametersNotAllowed, spell(p.word)));
    return;
  }
  if (p.word == Word::PTONLY) {
    const auto mode = list->empty() ? std::nullopt : values_.literal(list->front());
    const bool fits = list->empty() || ((mode == 1.0 || mode == 2.0) && list->size() == 1) ||
                      (mode == 3.0 && list->size() == 2);
    if (!fits) {
      context_.report(
          diagnose(p.span, diag::PtonlyFormat, "PTONLY", "1, 2, or 3 and a record number"));
      return;
    }
  }
  emitCommand(p, std::move(*list));
}

/// A definition without a name. CIRCLE/ with seven or more numbers is the arc record of CL files.
void Statements::unnamed(const Parts& p) {
  const auto type = entityType(p.word);
  if (!type || !context_.options.takes(&DialectRules::unnamedDefinitions)) {
    if (!type) {
      context_.reporter.used(ir::Feature::RV_01);
    }
    const std::string nameless = fmt::format("`{}` without a name before it", spell(p.word));
    context_.report(
        type ? old_number::as(old_number::unnamedType, diagnose(p.span, diag::Misplaced, nameless))
             : diagnose(p.span, diag::ReservedType, spell(p.word)));
    return;
  }
  auto list = values_.arguments(p.first, {.owner = spell(p.word),
                                          .ranges = true,
                                          .shortPoints = true,
                                          .strings = define::takesText(p.word)});
  if (!list) {
    return;
  }
  if (p.word == Word::CIRCLE && list->size() >= 7) {
    emitCommand(p, std::move(*list));
    return;
  }
  if (context_.options.warns(&DialectRules::unnamedDefinitions)) {
    context_.report(diagnose(p.span, diag::UnnamedDefinition));
  }
  ir::Definition d;
  d.type = *type;
  d.typeSpan = p.span;
  d.arguments = std::move(*list);
  d.span = block_.origin().span;
  context_.program.definitions.push_back(std::move(d));
  block_.emit(ir::Define{{static_cast<std::uint32_t>(context_.program.definitions.size() - 1)}});
}

void Statements::fini(const Parts& p) {
  if (p.slash || values_.tree()[values_.tree().head].next != noNode) {
    context_.report(diagnose(p.span, diag::FiniAlone));
  }
  if (block_.inArea()) {
    context_.report(diagnose(p.span, diag::FiniInArea, block_.areaName()));
  }
  block_.emit(ir::Fini{});
}

}  // namespace arelem::frontend
