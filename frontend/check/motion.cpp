#include "frontend/check/motion.h"

#include <utility>

#include "frontend/check/old_number.h"
#include "ir/diag/frontend.h"

namespace arelem::frontend {

namespace {
using Kind = Node::Kind;

std::optional<ir::Condition> conditionOf(Word word) {
  switch (word) {
    case Word::TO:
      return ir::Condition::to;
    case Word::ON:
      return ir::Condition::on;
    case Word::PAST:
      return ir::Condition::past;
    case Word::TANTO:
    case Word::DSTAN:
      return ir::Condition::tanto;
    case Word::PSTAN:
      return ir::Condition::pstan;
    default:
      return std::nullopt;
  }
}

ir::Heading headingOf(Word word) {
  switch (word) {
    case Word::GOLFT:
      return ir::Heading::left;
    case Word::GORGT:
      return ir::Heading::right;
    case Word::GOBACK:
      return ir::Heading::back;
    case Word::GOUP:
      return ir::Heading::up;
    case Word::GODOWN:
      return ir::Heading::down;
    default:
      return ir::Heading::forward;
  }
}

bool isSurfaceType(EntityType type) {
  return type != EntityType::point && type != EntityType::vector && type != EntityType::matrix &&
         type != EntityType::pattern;
}
}  // namespace

std::optional<ir::Argument> Motion::item(NodeId id, Word word) {
  ArgumentRules rules;
  rules.owner = spell(word);
  return values_.argument(id, rules);
}

bool Motion::surface(Word word, const ir::Argument& argument) {
  const auto type = values_.entityOf(argument);
  if (!type || !isSurfaceType(*type)) {
    const DiagRow& cause =
        values_.isScalar(argument) ? old_number::numberForSurface : diag::SurfaceExpectedRow;
    context_.report(old_number::as(cause, diagnose(argument.span, diag::SurfaceExpected,
                                                   spell(word), values_.describe(argument))));
    return false;
  }
  return true;
}

/// GOTO and FROM with literal numbers only become LocateNumbers, as in the fast lane.
bool Motion::plainNumbers(Word word, const std::vector<ir::Argument>& list) {
  ir::LocateNumbers numbers;
  if (word == Word::GODLTA || list.size() > numbers.numbers.size()) {
    return false;
  }
  numbers.word = word;
  for (const ir::Argument& a : list) {
    const auto value = values_.literal(a);
    if (!value) {
      return false;
    }
    numbers.numbers[numbers.count++] = *value;
  }
  context_.program.exprs.resize(context_.program.exprs.size() - list.size());
  block_.emit(numbers);
  return true;
}

bool Motion::checkLocate(Word word, const Span& at, const std::vector<ir::Argument>& list) {
  std::size_t numbers = 0;
  while (numbers < list.size() && values_.isScalar(list[numbers])) {
    ++numbers;
  }
  if (numbers == list.size()) {
    const bool delta = word == Word::GODLTA;
    const bool fits = delta ? numbers >= 1 && numbers <= 4
                            : numbers >= 2 && numbers <= 10 && numbers != 5 && numbers != 8;
    if (!fits) {
      context_.report(
          diagnose(at, diag::MotionCount, spell(word), numbers, numbers == 1 ? "" : "s"));
    }
    return fits;
  }
  const ir::Argument& first = list[numbers];
  const auto type = values_.entityOf(first);
  if (!type) {
    context_.report(diagnose(first.span, diag::WordInMotion, spell(word), values_.describe(first)));
    return false;
  }
  const bool place =
      *type == EntityType::point || *type == EntityType::vector ||
      ((*type == EntityType::pattern || *type == EntityType::pathSpline) && word == Word::GOTO);
  const bool axisAfterNumbers = numbers == 3 && *type == EntityType::vector && word != Word::GODLTA;
  if (!place || (numbers != 0 && !axisAfterNumbers)) {
    context_.report(
        old_number::as(old_number::noSurfaceType,
                       diagnose(first.span, diag::ArgumentType, spell(word), spell(*type))));
    return false;
  }
  return true;
}

void Motion::locate(Word word, const Span& wordSpan, NodeId first) {
  ArgumentRules rules;
  rules.owner = spell(word);
  auto list = values_.arguments(first, rules);
  if (!list || !checkLocate(word, wordSpan, *list) || plainNumbers(word, *list)) {
    return;
  }
  block_.emit(ir::Locate{word, std::move(*list)});
}

bool Motion::wordItem(Word motion, const Node& node, ir::SurfaceUse& use, bool& pending) {
  const auto condition = conditionOf(node.word);
  if (!condition || pending) {
    context_.report(diagnose(node.span, diag::WordInMotion, spell(motion), node.text));
    return false;
  }
  use.condition = *condition;
  use.conditionSpan = node.span;
  pending = true;
  return true;
}

void Motion::startup(Word word, const Span& wordSpan, NodeId first) {
  const StatementTree& tree = values_.tree();
  ir::Startup s;
  s.offset = word == Word::OFFSET;
  ir::SurfaceUse use;
  bool pending = false;
  bool ok = true;
  for (NodeId id = first; id != noNode && ok; id = tree[id].next) {
    if (tree[id].kind == Kind::word) {
      ok = wordItem(word, tree[id], use, pending);
      continue;
    }
    auto argument = item(id, word);
    if (!argument) {
      ok = false;
    } else if (values_.isScalar(*argument) && tree[id].next == noNode && !s.surfaces.empty() &&
               !pending) {
      s.feed = std::get<ir::ExprId>(argument->value);
    } else if ((ok = surface(word, *argument))) {
      use.surface = std::move(*argument);
      s.surfaces.push_back(std::exchange(use, {}));
      pending = false;
    }
  }
  const std::size_t most = s.offset ? 2 : 3;
  if (ok && (s.surfaces.empty() || s.surfaces.size() > most || pending)) {
    context_.report(diagnose(wordSpan, diag::ParameterExpected, spell(word),
                             s.offset ? "one or two surfaces" : "one to three surfaces"));
    ok = false;
  }
  if (ok) {
    block_.emit(std::move(s));
  }
}

bool Motion::isSurfaceNode(const Node& node) const {
  if (node.kind == Kind::definition) {
    return true;
  }
  if (node.kind != Kind::name) {
    return false;
  }
  const NameFacts* facts = context_.names.find(node.text);
  return facts != nullptr && facts->kind == NameFacts::Class::entity;
}

std::size_t Motion::countSurfaces(NodeId id) const {
  std::size_t count = 0;
  for (; id != noNode; id = values_.tree()[id].next) {
    count += isSurfaceNode(values_.tree()[id]) ? 1 : 0;
  }
  return count;
}

/// A name that nothing has behind the only check surface: told as a label that needs another one.
bool Motion::isStrayLabel(const Node& node, const ir::Follow& motion, bool pending) {
  if (node.kind != Kind::name || node.hasList || pending || motion.checks.size() != 1 ||
      context_.names.find(node.text) != nullptr) {
    return false;
  }
  context_.report(diagnose(node.span, diag::UndefinedSymbol, node.text)
                      .withHelp("a label follows each of two check surfaces; with one the motion "
                                "goes on at the next statement, where TRANTO may stand"));
  return true;
}

/// [m,] [n, INTOF,] cs [, label] ... [, feed]
bool Motion::followChecks(Word word,
                          NodeId id,
                          ir::Follow& motion,
                          std::vector<CheckLabel>& labels) {
  const StatementTree& tree = values_.tree();
  const bool several = countSurfaces(id) > 1;
  ir::CheckUse check;
  bool pending = false;
  bool labelDue = false;
  for (; id != noNode; id = tree[id].next) {
    const Node& node = tree[id];
    const bool intof = node.next != noNode && tree[node.next].kind == Kind::word &&
                       tree[node.next].word == Word::INTOF;
    const bool surfaceNode = isSurfaceNode(node);
    if (node.kind == Kind::word && !labelDue) {
      if (!wordItem(word, node, check.use, pending)) {
        return false;
      }
    } else if (labelDue && several && !surfaceNode &&
               (node.kind == Kind::name || node.kind == Kind::number)) {
      labels.push_back({motion.checks.size() - 1, node.text, node.span});
      motion.checks.back().label = ir::LabelRef{};
      labelDue = false;
    } else if (labelDue && several) {
      context_.report(diagnose(node.span, diag::CheckWithoutLabel));
      return false;
    } else {
      if (isStrayLabel(node, motion, pending)) {
        return false;
      }
      auto argument = item(id, word);
      if (!argument) {
        return false;
      }
      if (values_.isScalar(*argument) && intof) {
        check.nth = std::get<ir::ExprId>(argument->value);
        id = node.next;
      } else if (values_.isScalar(*argument) && node.next == noNode && !pending) {
        motion.feed = std::get<ir::ExprId>(argument->value);
      } else if (!surface(word, *argument)) {
        return false;
      } else {
        check.use.surface = std::move(*argument);
        motion.checks.push_back(std::exchange(check, {}));
        pending = false;
        labelDue = several;
      }
    }
  }
  if (pending || check.nth.valid()) {
    context_.report(
        diagnose(block_.origin().span, diag::ParameterExpected, spell(word), "a check surface"));
    return false;
  }
  if (labelDue) {
    context_.report(diagnose(motion.checks.back().use.surface.span, diag::CheckWithoutLabel));
    return false;
  }
  return true;
}

void Motion::follow(Word word, const Span& wordSpan, NodeId first) {
  const StatementTree& tree = values_.tree();
  ir::Follow motion;
  motion.heading = headingOf(word);
  if (first == noNode) {
    context_.report(diagnose(wordSpan, diag::ParameterExpected, spell(word), "a drive surface"));
    return;
  }
  if (tree[first].kind == Kind::word) {
    context_.report(diagnose(tree[first].span, diag::ModifierBeforeDrive, tree[first].text));
    return;
  }
  auto drive = item(first, word);
  if (!drive || !surface(word, *drive)) {
    return;
  }
  motion.drive = std::move(*drive);
  std::vector<CheckLabel> labels;
  if (!followChecks(word, tree[first].next, motion, labels)) {
    return;
  }
  if (motion.checks.empty() && (word == Word::GOUP || word == Word::GODOWN)) {
    context_.report(diagnose(wordSpan, diag::ImpliedUpDown, spell(word)));
    return;
  }
  const std::uint32_t at = block_.emit(std::move(motion));
  for (const CheckLabel& label : labels) {
    block_.refer(at, static_cast<std::uint32_t>(label.check), label.text, label.span);
  }
}

}  // namespace arelem::frontend
