#include "frontend/check/values.h"
#include "ir/diag/frontend.h"

namespace arelem::frontend {

namespace {
using Kind = Node::Kind;

bool isOperation(Kind kind) {
  return kind == Kind::add || kind == Kind::subtract || kind == Kind::multiply ||
         kind == Kind::divide || kind == Kind::power;
}
}  // namespace

std::optional<std::vector<ir::Argument>> Values::arguments(NodeId first,
                                                           const ArgumentRules& rules) {
  std::vector<ir::Argument> list;
  bool ok = true;
  for (NodeId id = first; id != noNode; id = (*tree_)[id].next) {
    auto one = argument(id, rules);
    ok = ok && one;
    if (ok) {
      list.push_back(std::move(*one));
    }
  }
  if (!ok) {
    return std::nullopt;
  }
  return list;
}

/// Outside functions an expression must stand in parentheses unless it is a number or name with a
/// sign.
bool Values::checkBare(const Node& node, const ArgumentRules& rules) {
  const Node* inner = &node;
  while ((inner->kind == Kind::negate || inner->kind == Kind::plus) && !inner->parenthesized) {
    inner = &(*tree_)[inner->first];
  }
  if (rules.bare || inner->parenthesized || !isOperation(inner->kind)) {
    return true;
  }
  if (!context_.options.takes(&DialectRules::bareExpressions)) {
    context_.report(diagnose(node.span, diag::UnparenthesizedExpression));
    return false;
  }
  if (context_.options.warns(&DialectRules::bareExpressions)) {
    context_.report(diagnose(node.span, diag::BareExpression));
  }
  return true;
}

std::optional<ir::Argument> Values::argument(NodeId id, const ArgumentRules& rules) {
  const Node& node = (*tree_)[id];
  switch (node.kind) {
    case Kind::omitted:
      if (!rules.omitted) {
        context_.report(diagnose(node.span, diag::EmptyParameter, rules.owner));
        return std::nullopt;
      }
      return ir::Argument{ir::Omitted{}, node.span};
    case Kind::word:
      return ir::Argument{node.word, node.span};
    case Kind::string:
      if (!rules.unknownAsText && !rules.strings) {
        context_.report(diagnose(node.span, diag::StringPlace, rules.owner));
        return std::nullopt;
      }
      return ir::Argument{std::string(node.text), node.span};
    case Kind::name:
      return nameArgument(node, rules);
    case Kind::list:
      return shortPoint(node, rules);
    case Kind::definition: {
      const auto nested = definition(id, node.target);
      return nested ? std::optional(ir::Argument{*nested, node.span}) : std::nullopt;
    }
    default:
      break;
  }
  if (!checkBare(node, rules)) {
    return std::nullopt;
  }
  const auto value = expression(id);
  return value ? std::optional(ir::Argument{*value, node.span}) : std::nullopt;
}

std::optional<ir::Argument> Values::shortPoint(const Node& node, const ArgumentRules& rules) {
  std::vector<ir::Argument> list;
  for (NodeId id = node.first; id != noNode; id = (*tree_)[id].next) {
    const auto value = expression(id);
    if (!value) {
      return std::nullopt;
    }
    list.push_back({*value, (*tree_)[id].span});
  }
  if (!rules.shortPoints || list.size() > 3) {
    context_.report(diagnose(node.span, diag::ShortPointPlace));
    return std::nullopt;
  }
  ir::Definition point;
  point.typeSpan = node.span;
  point.span = node.span;
  point.arguments = std::move(list);
  context_.program.definitions.push_back(std::move(point));
  const auto index = static_cast<std::uint32_t>(context_.program.definitions.size() - 1);
  return ir::Argument{ir::DefinitionId{index}, node.span};
}

std::optional<ir::Argument> Values::nameArgument(const Node& node, const ArgumentRules& rules) {
  NameFacts* facts = context_.names.find(node.text);
  const bool known =
      facts != nullptr && (facts->kind != NameFacts::Class::unknown || facts->poisoned);
  if (!known && rules.unknownAsText && !node.hasList) {
    if (!rules.silentText) {
      Diagnostic d = diagnose(node.span, diag::WordAsText, node.text);
      for (const std::string& near : context_.names.similar(node.text, true)) {
        d.help += (d.help.empty() ? "did you mean `" : ", `") + near + "`";
      }
      context_.report(std::move(d));
    }
    return ir::Argument{std::string(node.text), node.span};
  }
  if (!usable(node, facts)) {
    return std::nullopt;
  }
  if (isRange(node)) {
    return range(node, *facts, rules);
  }
  if (facts->kind == NameFacts::Class::scalar) {
    const auto value = nameValue(node);
    return value ? std::optional(ir::Argument{*value, node.span}) : std::nullopt;
  }
  const auto used = use(node, *facts);
  return used ? std::optional(ir::Argument{*used, node.span}) : std::nullopt;
}

bool Values::isRange(const Node& node) const {
  for (NodeId id = node.first; node.hasList && id != noNode; id = (*tree_)[id].next) {
    if ((*tree_)[id].kind == Kind::word) {
      return true;
    }
  }
  return false;
}

/// [a,] THRU, {b|ALL} [, {INCR|DECR}, c]   or   ALL [, {INCR|DECR}, c]
std::optional<ir::Argument> Values::range(const Node& node,
                                          NameFacts& facts,
                                          const ArgumentRules& rules) {
  if (!rules.ranges) {
    context_.report(diagnose(node.span, diag::RangeMisplaced));
    return std::nullopt;
  }
  if (facts.arraySize == 0) {
    context_.report(diagnose(node.span, diag::NotReserved, node.text));
    return std::nullopt;
  }
  ir::ElementRange r;
  r.symbol = symbol(node.text, facts);
  r.span = node.span;
  NodeId at = node.first;
  bool failed = false;
  const auto is = [&](Word word) {
    return at != noNode && (*tree_)[at].kind == Kind::word && (*tree_)[at].word == word;
  };
  const auto skip = [&] { at = (*tree_)[at].next; };
  const auto scalar = [&](ir::ExprId& into) {
    if (at == noNode || (*tree_)[at].kind == Kind::word) {
      return false;
    }
    const auto value = expression(at);
    failed = failed || !value;
    into = value.value_or(ir::ExprId{});
    skip();
    return true;
  };
  bool ok = true;
  if (is(Word::ALL)) {
    skip();
  } else {
    scalar(r.low);
    ok = is(Word::THRU);
    if (ok) {
      skip();
      if (is(Word::ALL)) {
        skip();
      } else {
        ok = scalar(r.high);
      }
    }
  }
  if (ok && (is(Word::INCR) || is(Word::DECR))) {
    r.descending = is(Word::DECR);
    skip();
    ok = scalar(r.step);
  }
  if (!ok || at != noNode) {
    context_.report(diagnose(node.span, diag::SubscriptSyntax));
    return std::nullopt;
  }
  return failed ? std::nullopt : std::optional(ir::Argument{r, node.span});
}

std::optional<EntityType> Values::entityOf(const ir::Argument& argument) const {
  if (const auto* t = std::get_if<ir::Target>(&argument.value)) {
    return context_.program[t->symbol].type;
  }
  if (const auto* d = std::get_if<ir::DefinitionId>(&argument.value)) {
    return context_.program[*d].type;
  }
  if (const auto* r = std::get_if<ir::ElementRange>(&argument.value)) {
    const ir::Symbol& s = context_.program[r->symbol];
    return s.kind == ir::Symbol::Kind::entity ? std::optional(s.type) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<double> Values::literal(ir::ExprId id) const {
  const ir::Expr& e = context_.program[id];
  return e.kind == ir::Expr::Kind::number ? std::optional(e.number) : std::nullopt;
}

std::optional<double> Values::literal(const ir::Argument& argument) const {
  const auto* e = std::get_if<ir::ExprId>(&argument.value);
  return e == nullptr ? std::nullopt : literal(*e);
}

bool Values::isScalar(const ir::Argument& argument) const {
  return std::holds_alternative<ir::ExprId>(argument.value);
}

std::string_view Values::describe(const ir::Argument& argument) const {
  if (const auto type = entityOf(argument)) {
    return spell(*type);
  }
  if (const auto* word = std::get_if<Word>(&argument.value)) {
    return spell(*word);
  }
  return isScalar(argument)                                    ? "a number"
         : std::holds_alternative<ir::Omitted>(argument.value) ? "nothing"
                                                               : "text";
}

}  // namespace arelem::frontend
