#include <cmath>

#include "frontend/check/values.h"
#include "ir/diag/frontend.h"

namespace arelem::frontend {

namespace {
using Kind = Node::Kind;

struct FunctionRow {
  Word word;
  int count;
  bool entities;  ///< takes entities instead of scalars
};
constexpr FunctionRow functions[] = {
    {Word::DOTF, 2, true},   {Word::LNTHF, 1, true},   {Word::ANGLF, 2, true},
    {Word::NUMF, 1, true},   {Word::DISTF, 2, true},   {Word::SQRTF, 1, false},
    {Word::SINF, 1, false},  {Word::COSF, 1, false},   {Word::TANF, 1, false},
    {Word::ATANF, 1, false}, {Word::ATAN2F, 2, false}, {Word::EXPF, 1, false},
    {Word::LOGF, 1, false},  {Word::LOG10F, 1, false}, {Word::ABSF, 1, false},
};

bool fitsFunction(Word function, std::size_t position, EntityType type, bool strict) {
  const bool direction = type == EntityType::point || type == EntityType::vector;
  switch (function) {
    case Word::DOTF:
    case Word::LNTHF:
      return direction;
    case Word::ANGLF:
      return position == 0 ? type == EntityType::circle : type == EntityType::point;
    case Word::NUMF:
      return type == EntityType::pattern;
    default: {
      const bool flat = type == EntityType::line || type == EntityType::plane;
      return flat || (!strict && type == EntityType::point);
    }
  }
}
}  // namespace

ir::ExprId Values::add(ir::Expr expr) {
  context_.program.exprs.push_back(std::move(expr));
  return {static_cast<std::uint32_t>(context_.program.exprs.size() - 1)};
}

ir::ExprId Values::number(double value, const Span& span) {
  ir::Expr e;
  e.span = span;
  e.number = value;
  return add(std::move(e));
}

ir::ExprId Values::binary(ir::Expr::Kind kind,
                          ir::ExprId left,
                          ir::ExprId right,
                          const Span& span) {
  ir::Expr e;
  e.kind = kind;
  e.span = span;
  e.left = left;
  e.right = right;
  return add(std::move(e));
}

std::optional<ir::ExprId> Values::expression(NodeId id) {
  const Node& node = (*tree_)[id];
  switch (node.kind) {
    case Kind::number:
      return number(node.number, node.span);
    case Kind::name:
      return nameValue(node);
    case Kind::call:
      return call(node);
    case Kind::nestedAssign:
      return nestedAssign(node);
    case Kind::plus:
      return expression(node.first);
    case Kind::negate:
      return unary(node, ir::Expr::Kind::negate);
    case Kind::add:
      return binaryNode(node, ir::Expr::Kind::add);
    case Kind::subtract:
      return binaryNode(node, ir::Expr::Kind::subtract);
    case Kind::multiply:
      return binaryNode(node, ir::Expr::Kind::multiply);
    case Kind::divide:
      return binaryNode(node, ir::Expr::Kind::divide);
    case Kind::power: {
      const Node& right = (*tree_)[(*tree_)[node.first].next];
      if (right.kind == Kind::power && !right.parenthesized) {
        context_.report(diagnose(node.span, diag::PowerChain));
      }
      return binaryNode(node, ir::Expr::Kind::power);
    }
    case Kind::compare:
    case Kind::conjunction:
    case Kind::disjunction:
    case Kind::negation:
      context_.report(diagnose(node.span, diag::ConditionAsValue));
      return std::nullopt;
    case Kind::list:
      context_.report(diagnose(node.span, diag::ShortPointPlace));
      return std::nullopt;
    case Kind::definition:
      context_.report(
          diagnose(node.span, diag::SurfaceInExpression, "definition", spell(node.word)));
      return std::nullopt;
    case Kind::word:
      context_.report(diagnose(node.span, diag::WordInExpression, node.text));
      return std::nullopt;
    case Kind::string:
      context_.report(diagnose(node.span, diag::StringPlace, "an expression"));
      return std::nullopt;
    case Kind::omitted:
    case Kind::parameter:
    case Kind::label:
      break;
  }
  context_.report(diagnose(node.span, diag::EmptyParameter, "an expression"));
  return std::nullopt;
}

std::optional<ir::ExprId> Values::unary(const Node& node, ir::Expr::Kind kind) {
  const auto child = expression(node.first);
  if (!child) {
    return std::nullopt;
  }
  ir::Expr& operand = context_.program.exprs[child->index];
  if (operand.kind == ir::Expr::Kind::number) {
    operand.number = -operand.number;
    operand.span = node.span;
    return child;
  }
  return binary(kind, *child, {}, node.span);
}

std::optional<ir::ExprId> Values::binaryNode(const Node& node, ir::Expr::Kind kind) {
  const auto left = expression(node.first);
  const auto right = expression((*tree_)[node.first].next);
  if (!left || !right) {
    return std::nullopt;
  }
  return binary(kind, *left, *right, node.span);
}

std::optional<ir::ExprId> Values::nameValue(const Node& node) {
  NameFacts* facts = context_.names.find(node.text);
  if (!usable(node, facts)) {
    return std::nullopt;
  }
  if (facts->kind == NameFacts::Class::entity) {
    context_.report(diagnose(node.span, diag::SurfaceInExpression, node.text, spell(facts->type)));
    return std::nullopt;
  }
  if (isRange(node)) {
    context_.report(diagnose(node.span, diag::RangeMisplaced));
    return std::nullopt;
  }
  const auto used = use(node, *facts);
  if (!used) {
    return std::nullopt;
  }
  ir::Expr e;
  e.kind = ir::Expr::Kind::symbol;
  e.span = node.span;
  e.target = *used;
  return add(std::move(e));
}

std::optional<ir::ExprId> Values::nestedAssign(const Node& node) {
  const auto value = expression(node.target);
  const auto name = target(node.first, NameFacts::Class::scalar, {});
  markDefined(node.first);
  if (!value || !name) {
    return std::nullopt;
  }
  ir::Expr e;
  e.kind = ir::Expr::Kind::assign;
  e.span = node.span;
  e.left = *value;
  e.target = *name;
  return add(std::move(e));
}

std::optional<ir::ExprId> Values::call(const Node& node) {
  if (node.first == noNode) {
    context_.report(diagnose(node.span, diag::EmptyParentheses));
    return std::nullopt;
  }
  ArgumentRules rules;
  rules.owner = spell(node.word);
  rules.bare = true;
  rules.shortPoints = context_.options.takes(&DialectRules::laterForms);
  auto list = arguments(node.first, rules);
  if (!list || !checkFunction(node, *list)) {
    return std::nullopt;
  }
  ir::Expr e;
  e.kind = ir::Expr::Kind::call;
  e.span = node.span;
  e.function = node.word;
  e.arguments = std::move(*list);
  return add(std::move(e));
}

bool Values::checkFunction(const Node& node, const std::vector<ir::Argument>& list) {
  const FunctionRow* found = nullptr;
  for (const FunctionRow& f : functions) {
    found = f.word == node.word ? &f : found;
  }
  if (found == nullptr) {
    context_.report(diagnose(node.wordSpan, diag::WordInExpression, spell(node.word)));
    return false;
  }
  if (list.size() != static_cast<std::size_t>(found->count)) {
    context_.report(
        diagnose(node.span, diag::ArgumentCount, spell(node.word), found->count, list.size()));
    return false;
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto type = entityOf(list[i]);
    const bool fits = found->entities
                          ? type && fitsFunction(node.word, i, *type,
                                                 !context_.options.takes(&DialectRules::laterForms))
                          : isScalar(list[i]);
    if (!fits) {
      context_.report(
          diagnose(list[i].span, diag::ArgumentType, spell(node.word), describe(list[i])));
      return false;
    }
  }
  return true;
}

}  // namespace arelem::frontend
