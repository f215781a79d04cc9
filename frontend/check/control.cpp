#include "frontend/check/control.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "ir/diag/frontend.h"
#include "ir/space/tolerance.h"

namespace arelem::frontend {

namespace {
using Kind = Node::Kind;

void append(std::vector<Jump>& to, const std::vector<Jump>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// For which signs of (left - right) the comparison holds: negative, zero, positive.
std::array<bool, 3> holds(Relation relation) {
  switch (relation) {
    case Relation::equal:
      return {false, true, false};
    case Relation::notEqual:
      return {true, false, true};
    case Relation::less:
      return {true, false, false};
    case Relation::lessEqual:
      return {true, true, false};
    case Relation::greater:
      return {false, false, true};
    case Relation::greaterEqual:
      return {false, true, true};
  }
  return {};
}
}  // namespace

bool Control::labelText(NodeId id, Word word, std::string_view& text) {
  const Node* node = id == noNode ? nullptr : &values_.tree()[id];
  const bool fits =
      node != nullptr && !node->hasList &&
      (node->kind == Kind::label || node->kind == Kind::name || node->kind == Kind::number);
  if (!fits) {
    const Span at = node == nullptr ? block_.origin().span : node->span;
    Diagnostic d = diagnose(at, diag::LabelExpected, spell(word));
    if (node != nullptr && node->kind == Kind::word) {
      d.help = fmt::format("`{}` is a word of the language and cannot be a label", node->text);
    }
    context_.report(std::move(d));
    return false;
  }
  text = node->text;
  return true;
}

/// Later systems jump anywhere in a program; names may then be used above their definition.
bool Control::mayJump(std::string_view word) {
  if (block_.inArea()) {
    return true;
  }
  if (!context_.options.takes(&DialectRules::jumpsAnywhere)) {
    context_.report(diagnose(block_.origin().span, diag::JumpOutside, word));
    return false;
  }
  if (context_.options.warns(&DialectRules::jumpsAnywhere)) {
    context_.report(diagnose(block_.origin().span, diag::JumpInProgram, word));
  }
  jumps_ = true;
  context_.lenient = true;
  return true;
}

void Control::branch() {
  const StatementTree& tree = values_.tree();
  if (!mayJump("IF")) {
    return;
  }
  const auto value = values_.expression(tree.value);
  std::array<std::string_view, 3> labels;
  std::array<Span, 3> spans;
  bool ok = value.has_value();
  NodeId id = tree.arguments;
  for (std::size_t i = 0; i < labels.size(); ++i, id = tree[id].next) {
    ok = labelText(id, Word::IF, labels[i]) && ok;
    spans[i] = tree[id].span;
  }
  if (!ok) {
    return;
  }
  const std::uint32_t at = block_.emit(ir::Branch{*value, {}, {}, {}});
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    block_.refer(at, i, labels[i], spans[i]);
  }
}

void Control::jump(Word word, NodeId argument, bool single) {
  if (word == Word::JUMPTO && !mayJump("JUMPTO")) {
    return;
  }
  std::string_view text;
  if (!labelText(argument, word, text)) {
    return;
  }
  if (!single) {
    const NodeId second = values_.tree()[argument].next;
    context_.report(diagnose(values_.tree()[second].span, diag::Misplaced, "a second label"));
    return;
  }
  const std::uint32_t at =
      word == Word::JUMPTO ? block_.emit(ir::Jump{}) : block_.emit(ir::Transfer{});
  block_.refer(at, 0, text, values_.tree()[argument].span);
}

void Control::loopStart() {
  if (block_.area() == BlockWriter::Area::macro) {
    context_.report(diagnose(block_.origin().span, diag::ForbiddenInMacro, "LOOPST"));
    return;
  }
  if (block_.area() == BlockWriter::Area::loop) {
    context_.report(diagnose(block_.origin().span, diag::LoopInLoop)
                        .label(block_.loopStart(), "this loop is open"));
    return;
  }
  block_.emit(ir::Command{Word::LOOPST, false, {}});
  block_.beginLoop(block_.origin().span);
  context_.lenient = true;
}

void Control::loopEnd() {
  if (block_.area() == BlockWriter::Area::macro) {
    context_.report(diagnose(block_.origin().span, diag::ForbiddenInMacro, "LOOPND"));
    return;
  }
  if (block_.area() != BlockWriter::Area::loop) {
    context_.report(diagnose(block_.origin().span, diag::LoopEndAlone));
    return;
  }
  block_.emit(ir::Command{Word::LOOPND, false, {}});
  block_.endLoop();
  context_.lenient = jumps_ || inDo();
}

bool Control::inDo() const {
  for (const Open& o : open_) {
    if (o.isDo) {
      return true;
    }
  }
  return false;
}

bool Control::compare(const Node& node, Exits& exits) {
  const auto left = values_.expression(node.first);
  const auto right = values_.expression(values_.tree()[node.first].next);
  if (!left || !right) {
    return false;
  }
  const ir::ExprId difference = values_.binary(ir::Expr::Kind::subtract, *left, *right, node.span);
  const std::uint32_t at = block_.emit(ir::Branch{difference, {}, {}, {}});
  const std::array<bool, 3> truth = holds(node.relation);
  for (std::uint32_t slot = 0; slot < truth.size(); ++slot) {
    (truth[slot] ? exits.whenTrue : exits.whenFalse).push_back({at, slot});
  }
  return true;
}

/// Emits the branches of a condition; every exit is a jump that is patched later.
bool Control::condition(NodeId id, Exits& exits) {
  const Node& node = values_.tree()[id];
  if (node.kind == Kind::compare) {
    return compare(node, exits);
  }
  if (node.kind == Kind::negation) {
    const bool ok = condition(node.first, exits);
    std::swap(exits.whenTrue, exits.whenFalse);
    return ok;
  }
  if (node.kind != Kind::conjunction && node.kind != Kind::disjunction) {
    context_.report(diagnose(node.span, diag::NotACondition));
    return false;
  }
  const bool both = node.kind == Kind::conjunction;
  Exits left;
  if (!condition(node.first, left)) {
    return false;
  }
  block_.patch(both ? left.whenTrue : left.whenFalse, block_.next());
  if (!condition(values_.tree()[node.first].next, exits)) {
    return false;
  }
  append(both ? exits.whenFalse : exits.whenTrue, both ? left.whenFalse : left.whenTrue);
  return true;
}

void Control::openCondition(Open& open) {
  Exits exits;
  open.broken = !condition(values_.tree().value, exits);
  block_.patch(exits.whenTrue, block_.next());
  open.toElse = exits.whenFalse;
}

void Control::ifBlock() {
  Open open;
  open.span = block_.origin().span;
  openCondition(open);
  open_.push_back(std::move(open));
}

Control::Open* Control::innermost(bool isDo, std::string_view end, std::string_view start) {
  if (open_.empty() || open_.back().isDo != isDo) {
    context_.report(diagnose(block_.origin().span, diag::BlockEndAlone, end, start));
    return nullptr;
  }
  return &open_.back();
}

void Control::elsePart(Open& open, bool jumpOver) {
  if (jumpOver) {
    open.toEnd.push_back({block_.emit(ir::Jump{}), 0});
  }
  block_.patch(open.toElse, block_.next());
  open.toElse.clear();
}

void Control::elseIf() {
  Open* open = innermost(false, "ELSEIF", "IF");
  if (open == nullptr || open->elseSeen) {
    if (open != nullptr) {
      context_.report(
          diagnose(block_.origin().span, diag::BlockEndAlone, "ELSEIF after ELSE", "a new IF"));
    }
    return;
  }
  elsePart(*open, true);
  openCondition(*open);
}

void Control::elseWord() {
  Open* open = innermost(false, "ELSE", "IF");
  if (open == nullptr) {
    return;
  }
  if (std::exchange(open->elseSeen, true)) {
    context_.report(
        diagnose(block_.origin().span, diag::BlockEndAlone, "a second ELSE", "a new IF"));
    return;
  }
  elsePart(*open, true);
}

void Control::endIf() {
  Open* open = innermost(false, "ENDIF", "IF");
  if (open == nullptr) {
    return;
  }
  elsePart(*open, false);
  block_.patch(open->toEnd, block_.next());
  open_.pop_back();
}

/// Leaves the loop when the counter has passed the last value by more than rounding. `last` and the
/// step are computed again at every pass.
bool Control::emitTest(Open& open, ir::ExprId last) {
  const Span span = open.span;
  ir::Expr counter;
  counter.kind = ir::Expr::Kind::symbol;
  counter.span = open.counter.span;
  counter.target = open.counter;
  const ir::ExprId i = values_.add(std::move(counter));
  const ir::ExprId past = values_.binary(ir::Expr::Kind::subtract, i, last, span);
  const ir::ExprId slack = values_.binary(ir::Expr::Kind::multiply, open.step,
                                          values_.number(tolerance::loopCount, span), span);
  const ir::ExprId beyond = values_.binary(ir::Expr::Kind::subtract, past, slack, span);
  // Multiplied by the step, `beyond` is positive past the end whatever the direction.
  const ir::ExprId test = values_.binary(ir::Expr::Kind::multiply, beyond, open.step, span);
  const std::uint32_t at = block_.emit(ir::Branch{test, {}, {}, {}});
  block_.patch({{at, 0}, {at, 1}}, block_.next());
  open.toEnd.push_back({at, 2});
  return true;
}

void Control::doBlock() {
  const StatementTree& tree = values_.tree();
  Open open;
  open.isDo = true;
  open.span = block_.origin().span;
  open.wasLenient = context_.lenient;
  const NodeId from = tree.arguments;
  const NodeId to = tree[from].next;
  const NodeId by = tree[to].next;
  const auto first = values_.expression(from);
  const auto last = values_.expression(to);
  const auto step =
      by == noNode ? std::optional(values_.number(1.0, open.span)) : values_.expression(by);
  const auto counter = values_.target(tree.target, NameFacts::Class::scalar, {});
  values_.markDefined(tree.target);
  context_.lenient = true;
  open.broken = !first || !last || !step || !counter;
  if (!open.broken && values_.literal(*step) == 0.0) {
    context_.report(diagnose(tree[by].span, diag::StepIsZero));
    open.broken = true;
  }
  if (!open.broken) {
    open.counter = *counter;
    open.step = *step;
    block_.emit(ir::Assign{*counter, *first});
    open.top = block_.next();
    emitTest(open, *last);
  }
  open_.push_back(std::move(open));
}

void Control::endDo() {
  Open* open = innermost(true, "ENDDO", "DO");
  if (open == nullptr) {
    return;
  }
  if (!open->broken) {
    ir::Expr counter;
    counter.kind = ir::Expr::Kind::symbol;
    counter.span = open->counter.span;
    counter.target = open->counter;
    const ir::ExprId i = values_.add(std::move(counter));
    block_.emit(
        ir::Assign{open->counter, values_.binary(ir::Expr::Kind::add, i, open->step, open->span)});
    block_.patch({{block_.emit(ir::Jump{}), 0}}, open->top);
    block_.patch(open->toEnd, block_.next());
  }
  context_.lenient = open->wasLenient;
  open_.pop_back();
}

void Control::finish() {
  for (const Open& open : open_) {
    context_.report(diagnose(open.span, diag::BlockNotEnded, open.isDo ? "DO" : "IF",
                             open.isDo ? "ENDDO" : "ENDIF"));
  }
  open_.clear();
}

}  // namespace arelem::frontend
