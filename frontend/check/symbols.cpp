#include <cmath>

#include <fmt/format.h>

#include "frontend/check/old_number.h"
#include "frontend/check/values.h"
#include "ir/define/matcher.h"
#include "ir/diag/frontend.h"

namespace arelem::frontend {

namespace {
std::string classOf(const NameFacts& facts) {
  switch (facts.kind) {
    case NameFacts::Class::scalar:
      return "a scalar";
    case NameFacts::Class::entity:
      return fmt::format("a {}", spell(facts.type));
    case NameFacts::Class::macro:
      return "a macro";
    case NameFacts::Class::unknown:
      break;
  }
  return "unknown";
}

/// Types that are too large to be stored without a name.
bool needsName(EntityType type) {
  return type == EntityType::tabulatedCylinder || type == EntityType::polyconic ||
         type == EntityType::ruledSurface || type == EntityType::pattern ||
         type == EntityType::mesh || type == EntityType::pathSpline;
}

/// Digits, an E and perhaps digits make a name: `3E` of 3E-05, `1E300`. The digits before the E,
/// else nothing.
std::string_view mantissaOf(std::string_view name) {
  constexpr std::string_view digits = "0123456789";
  const std::size_t e = name.find_first_not_of(digits);
  return e != 0 && e != std::string_view::npos && name[e] == 'E' &&
                 name.find_first_not_of(digits, e + 1) == std::string_view::npos
             ? name.substr(0, e)
             : std::string_view();
}

/// Blanks do not count: `TO L1` is the name TOL1. Where a word and a name would make it, both with
/// the comma between them, else nothing.
std::string withComma(std::string_view name, Names& names) {
  for (std::size_t i = 1; i < name.size(); ++i) {
    const NameFacts* behind = findWord(name.substr(0, i)) ? names.find(name.substr(i)) : nullptr;
    if (behind != nullptr && behind->defined) {
      return fmt::format("{},{}", name.substr(0, i), name.substr(i));
    }
  }
  return {};
}
}  // namespace

ir::SymbolId Values::symbol(std::string_view name, NameFacts& facts) {
  if (!facts.symbol.valid()) {
    ir::Symbol s;
    s.name = name;
    s.kind = facts.kind == NameFacts::Class::entity ? ir::Symbol::Kind::entity
                                                    : ir::Symbol::Kind::scalar;
    s.type = facts.type;
    s.arraySize = facts.arraySize;
    s.definition = facts.definition;
    context_.program.symbols.push_back(std::move(s));
    facts.symbol = {static_cast<std::uint32_t>(context_.program.symbols.size() - 1)};
  }
  return facts.symbol;
}

void Values::undefined(const Node& node) {
  const std::string_view name = node.text;
  NameFacts& facts = context_.names.at(name);
  const DiagRow& cause = node.hasList ? old_number::undefinedArray : diag::UndefinedSymbolRow;
  Diagnostic d = old_number::as(cause, diagnose(node.span, diag::UndefinedSymbol, name));
  if (facts.kind != NameFacts::Class::unknown && !facts.defined) {
    d.labels.push_back({facts.definition, "it is defined here, after this use"});
  } else if (const std::string_view mantissa = mantissaOf(name); !mantissa.empty()) {
    d.help = fmt::format("a number with an exponent has a decimal point: {}.{}", mantissa,
                         name.substr(mantissa.size()));
  } else if (const std::string apart = withComma(name, context_.names); !apart.empty()) {
    d.help = fmt::format("blanks do not count; with a comma: {}", apart);
  } else {
    for (const std::string& near : context_.names.similar(name, true)) {
      d.help += (d.help.empty() ? "did you mean `" : ", `") + near + "`";
    }
  }
  context_.report(std::move(d));
  facts.poisoned = true;
}

bool Values::usable(const Node& node, NameFacts* facts) {
  if (facts == nullptr) {
    undefined(node);
    return false;
  }
  if (facts->poisoned) {
    return false;
  }
  if (facts->kind == NameFacts::Class::macro) {
    context_.report(diagnose(node.span, diag::MacroMisused, node.text));
    return false;
  }
  if (facts->kind == NameFacts::Class::unknown || (!facts->defined && !context_.lenient)) {
    undefined(node);
    return false;
  }
  return true;
}

std::optional<ir::Target> Values::use(const Node& node, NameFacts& facts) {
  ir::Target t;
  t.span = node.span;
  if (facts.arraySize == 0 && node.hasList) {
    context_.report(diagnose(node.span, diag::NotReserved, node.text));
    return std::nullopt;
  }
  if (facts.arraySize != 0) {
    if (!node.hasList) {
      context_.report(diagnose(node.span, diag::SubscriptMissing, node.text, facts.arraySize));
      return std::nullopt;
    }
    const auto index = subscript(node, facts);
    if (!index) {
      return std::nullopt;
    }
    t.subscript = *index;
  }
  t.symbol = symbol(node.text, facts);
  return t;
}

std::optional<ir::ExprId> Values::subscript(const Node& node, const NameFacts& facts) {
  if (node.first == noNode) {
    context_.report(diagnose(node.span, diag::EmptyParentheses));
    return std::nullopt;
  }
  const Node& inner = (*tree_)[node.first];
  if (inner.next != noNode) {
    context_.report(diagnose(node.span, diag::SubscriptSyntax));
    return std::nullopt;
  }
  if (!context_.options.takes(&DialectRules::laterForms) && inner.kind == Node::Kind::name &&
      inner.hasList) {
    context_.report(diagnose(inner.span, diag::NestedSubscript));
    return std::nullopt;
  }
  const auto value = expression(node.first);
  if (!value) {
    return std::nullopt;
  }
  if (const auto fixed = literal(*value)) {
    const double index = std::trunc(*fixed);
    if (index < 1.0 || index > facts.arraySize) {
      context_.report(
          diagnose(node.span, diag::SubscriptRange, node.text, *fixed, facts.arraySize));
      return std::nullopt;
    }
  }
  return value;
}

std::optional<ir::Target> Values::target(NodeId id, NameFacts::Class kind, EntityType type) {
  const Node& node = (*tree_)[id];
  if (node.kind == Node::Kind::word) {
    context_.report(diagnose(node.span, diag::WordAsName, node.text));
    return std::nullopt;
  }
  NameFacts& facts = context_.names.at(node.text);
  if (facts.kind == NameFacts::Class::unknown) {
    facts.kind = kind;
    facts.type = type;
    facts.definition = node.span;
  }
  const bool same = facts.kind == kind && (kind != NameFacts::Class::entity || facts.type == type);
  if (!same) {
    NameFacts wanted;
    wanted.kind = kind;
    wanted.type = type;
    Diagnostic d =
        diagnose(node.span, diag::RedefinedClass, node.text, classOf(facts), classOf(wanted));
    if (facts.arraySize != 0 || facts.kind == NameFacts::Class::macro) {
      d.row = facts.arraySize != 0 ? &old_number::arrayClass : &old_number::macroClass;
    }
    if (facts.definition != node.span) {
      d.labels.push_back({facts.definition, "first defined here"});
    }
    context_.report(std::move(d));
    return std::nullopt;
  }
  return use(node, facts);
}

void Values::markDefined(NodeId id) {
  const Node& node = (*tree_)[id];
  if (node.kind == Node::Kind::name) {
    context_.names.at(node.text).defined = true;
  }
}

std::optional<ir::DefinitionId> Values::definition(NodeId id, NodeId targetNode) {
  const Node& node = (*tree_)[id];
  const auto type = entityType(node.word);
  if (!type || (!context_.options.takes(&DialectRules::laterForms) &&
                (*type == EntityType::mesh || *type == EntityType::torus))) {
    context_.reporter.used(ir::Feature::RV_01);
    context_.report(diagnose(node.wordSpan, diag::ReservedType, spell(node.word)));
    if (targetNode != noNode && (*tree_)[targetNode].kind == Node::Kind::name) {
      context_.names.at((*tree_)[targetNode].text).poisoned = true;
    }
    return std::nullopt;
  }
  ArgumentRules rules;
  rules.owner = spell(node.word);
  rules.ranges = true;
  rules.shortPoints = true;
  rules.strings = define::takesText(node.word);
  for (NodeId a = node.first; a != noNode; a = (*tree_)[a].next) {
    const bool canon = (*tree_)[a].kind == Node::Kind::word && (*tree_)[a].word == Word::CANON;
    rules.omitted = rules.omitted || canon;
  }
  rules.ranges = !rules.omitted;
  auto list = arguments(node.first, rules);
  std::optional<ir::Target> name = ir::Target{};
  if (targetNode != noNode) {
    name = target(targetNode, NameFacts::Class::entity, *type);
    markDefined(targetNode);
  } else if (needsName(*type)) {
    context_.report(diagnose(node.span, diag::UnnamedLargeNest, spell(*type)));
    return std::nullopt;
  }
  if (!list || !name) {
    return std::nullopt;
  }
  ir::Definition d;
  d.type = *type;
  d.typeSpan = node.wordSpan;
  d.target = *name;
  d.arguments = std::move(*list);
  d.span = node.span;
  context_.program.definitions.push_back(std::move(d));
  return ir::DefinitionId{static_cast<std::uint32_t>(context_.program.definitions.size() - 1)};
}

}  // namespace arelem::frontend
