// Statements whose parameters have a fixed meaning: OBTAIN, RESERV, REFSYS, ZSURF, PSIS, PRINT,
// PUNCH, READ, POCKET.
#include <algorithm>
#include <cmath>

#include "frontend/check/old_number.h"
#include "frontend/check/statements.h"
#include "ir/diag/frontend.h"

namespace arelem::frontend {

namespace {
using Kind = Node::Kind;

bool isLarge(EntityType type) {
  return type == EntityType::tabulatedCylinder || type == EntityType::polyconic ||
         type == EntityType::ruledSurface || type == EntityType::pattern ||
         type == EntityType::mesh || type == EntityType::pathSpline;
}
}  // namespace

/// Names (or nothing) to store the items in. Empty positions skip an item.
bool Statements::obtainTargets(NodeId first, ir::Obtain& obtain) {
  const StatementTree& tree = values_.tree();
  bool ok = true;
  for (NodeId id = first; id != noNode; id = tree[id].next) {
    if (tree[id].kind == Kind::omitted) {
      obtain.targets.emplace_back();
      continue;
    }
    if (tree[id].kind != Kind::name || tree[id].parenthesized) {
      context_.report(diagnose(tree[id].span, diag::ObtainTarget));
      ok = false;
      continue;
    }
    const auto target = values_.target(id, NameFacts::Class::scalar, {});
    values_.markDefined(id);
    ok = ok && target;
    obtain.targets.push_back(target);
  }
  return ok;
}

void Statements::obtain(const Parts& p) {
  const StatementTree& tree = values_.tree();
  const NodeId typeNode = tree[tree.head].next;
  const auto type = typeNode != noNode && tree[typeNode].kind == Kind::word
                        ? entityType(tree[typeNode].word)
                        : std::nullopt;
  NodeId source = tree.arguments;
  if (type && !tree.slash) {
    source = tree[typeNode].next;
    if (source != noNode && context_.options.takes(&DialectRules::obtainComma)) {
      context_.report(diagnose(tree[typeNode].span, diag::CommaForSlash));
    } else {
      source = noNode;
    }
  }
  if (!type || source == noNode) {
    const DiagRow& cause = type ? diag::ObtainFormatRow : old_number::obtainWithoutType;
    context_.report(old_number::as(cause, diagnose(p.span, diag::ObtainFormat)));
    for (const NodeId chain :
         {tree.head, tree.arguments}) {  // no further errors for names it would have set
      for (NodeId id = chain; id != noNode; id = tree[id].next) {
        if (tree[id].kind == Kind::name && !tree[id].hasList) {
          values_.markDefined(id);
        }
      }
    }
    return;
  }
  ir::Obtain result;
  result.type = *type;
  auto argument = values_.argument(
      source,
      {.owner = "OBTAIN", .shortPoints = context_.options.takes(&DialectRules::laterForms)});
  const bool named = obtainTargets(tree[source].next, result);
  if (!argument || !named) {
    return;
  }
  const auto actual = values_.entityOf(*argument);
  if (actual != type) {
    context_.report(diagnose(argument->span, diag::ObtainType,
                             context_.sources.text(argument->span), values_.describe(*argument),
                             spell(*type)));
    return;
  }
  if (isLarge(*type)) {
    context_.report(diagnose(p.span, diag::ObtainLarge, spell(*type)));
    return;
  }
  const int items = canonicalCount(*type);
  if (result.targets.size() > static_cast<std::size_t>(items)) {
    context_.report(
        diagnose(p.span, diag::ObtainCount, spell(*type), items, result.targets.size()));
    return;
  }
  result.source = std::move(*argument);
  block_.emit(std::move(result));
}

bool Statements::reservPair(const Node& name, const Node& size) {
  const double most = static_cast<double>(context_.options.limits.array);
  const bool whole =
      size.kind == Kind::number && size.number >= 1.0 && std::trunc(size.number) == size.number;
  if (name.kind != Kind::name || name.hasList || !whole) {
    const DiagRow& cause = !whole && size.kind != Kind::word    ? old_number::reservedSize
                           : whole && name.kind == Kind::number ? old_number::reservedNumber
                                                                : diag::ReservFormatRow;
    context_.report(
        old_number::as(cause, diagnose(join(name.span, size.span), diag::ReservFormat)));
    return false;
  }
  NameFacts& facts = context_.names.at(name.text);
  if (size.number > most) {
    context_.reporter.limit(size.span, "array", context_.options.limits.array,
                            "elements of one array");
    facts.poisoned = true;
    return false;
  }
  if (facts.kind == NameFacts::Class::macro || facts.defined || facts.symbol.valid() ||
      facts.arraySize != 0) {
    context_.report(diagnose(name.span, diag::ReservLate, name.text));
    return false;
  }
  facts.arraySize = static_cast<std::uint32_t>(size.number);
  if (!facts.definition.length) {
    facts.definition = name.span;
  }
  return true;
}

void Statements::reserv(const Parts& p) {
  const StatementTree& tree = values_.tree();
  if (block_.inArea()) {
    context_.report(diagnose(p.span, diag::ReservPlace));
    return;
  }
  if (p.first == noNode) {
    context_.report(diagnose(p.span, diag::ReservFormat));
    return;
  }
  const bool nameFirst = tree[p.first].kind == Kind::name;
  for (NodeId id = p.first; id != noNode;) {
    const Node& a = tree[id];
    if (a.next == noNode) {
      context_.report(
          old_number::as(old_number::reservedSize, diagnose(a.span, diag::ReservFormat)));
      return;
    }
    const Node& b = tree[a.next];
    reservPair(nameFirst ? a : b, nameFirst ? b : a);
    id = b.next;
  }
}

void Statements::refsys(const Parts& p) {
  auto list = values_.arguments(p.first, {.owner = "REFSYS"});
  if (!list) {
    return;
  }
  const Word* word = list->size() == 1 ? std::get_if<Word>(&list->front().value) : nullptr;
  const auto* nested =
      list->size() == 1 ? std::get_if<ir::DefinitionId>(&list->front().value) : nullptr;
  const bool unnamed = nested != nullptr && !context_.program[*nested].target.symbol.valid();
  const bool matrix = list->size() == 1 && values_.entityOf(list->front()) == EntityType::matrix;
  if (unnamed && matrix) {
    context_.report(diagnose(list->front().span, diag::UnnamedLargeNest, "matrix of REFSYS"));
  } else if (matrix || (word != nullptr && *word == Word::NOMORE)) {
    emitCommand(p, std::move(*list));
  } else {
    context_.report(diagnose(p.span, diag::RefsysFormat));
  }
}

void Statements::surfaceOrNumbers(const Parts& p) {
  const bool zsurf = p.word == Word::ZSURF;
  auto list = values_.arguments(p.first, {.owner = spell(p.word)});
  if (!list) {
    return;
  }
  std::optional<EntityType> type;
  if (list->size() == 1) {
    type = values_.entityOf(list->front());
  }
  const bool numbers =
      zsurf && list->size() == 4 &&
      std::all_of(list->begin(), list->end(), [&](const auto& a) { return values_.isScalar(a); });
  const bool fits = zsurf ? (type && *type == EntityType::plane) || numbers
                          : type && *type != EntityType::point && *type != EntityType::vector &&
                                *type != EntityType::matrix && *type != EntityType::pattern;
  if (!fits) {
    const DiagRow& cause = zsurf           ? old_number::zsurfPlane
                           : list->empty() ? diag::ZsurfFormatRow
                                           : old_number::partSurfaceType;
    context_.report(
        old_number::as(cause, diagnose(p.span, diag::ZsurfFormat, spell(p.word),
                                       zsurf ? "plane or its four numbers" : "surface")));
    return;
  }
  emitCommand(p, std::move(*list));
}

void Statements::print(const Parts& p) {
  ArgumentRules rules{.owner = spell(p.word), .ranges = true};
  rules.unknownAsText = true;  // undefined names are listed as undefined
  auto list = values_.arguments(p.first, rules);
  if (!list) {
    return;
  }
  const auto mode = list->empty() ? std::nullopt : values_.literal(list->front());
  const Word* word = list->empty() ? nullptr : std::get_if<Word>(&list->front().value);
  const double lowest = p.word == Word::PRINT ? 0.0 : 1.0;
  const double highest = p.word == Word::PRINT ? 4.0 : p.word == Word::PUNCH ? 3.0 : 2.0;
  const bool onOff =
      p.word == Word::PRINT && word != nullptr && (*word == Word::ON || *word == Word::OFF);
  const bool number = mode && *mode >= lowest && *mode <= highest && std::trunc(*mode) == *mode;
  if (!number && !(onOff && list->size() == 1)) {
    const std::string_view wanted = p.word == Word::PRINT   ? "0 to 4 and a list, ON or OFF"
                                    : p.word == Word::PUNCH ? "1 to 3 and a list"
                                                            : "1 and names, or 2 and a name";
    const DiagRow& cause = p.word == Word::READ ? old_number::readFormat : diag::PrintFormatRow;
    context_.report(
        old_number::as(cause, diagnose(p.span, diag::PrintFormat, spell(p.word), wanted)));
    return;
  }
  emitCommand(p, std::move(*list));
}

void Statements::pocket(const Parts& p) {
  auto list = values_.arguments(p.first, {.owner = "POCKET"});
  if (!list) {
    return;
  }
  constexpr std::size_t scalars = 8;
  const auto scalar = [&](const ir::Argument& a) { return values_.isScalar(a); };
  const auto point = [&](const ir::Argument& a) {
    return scalar(a) || values_.entityOf(a) == EntityType::point;
  };
  const bool head =
      list->size() > scalars && std::all_of(list->begin(), list->begin() + scalars, scalar);
  const bool numbers =
      !list->empty() &&
      std::all_of(list->begin(), list->begin() + std::min(scalars, list->size()), scalar);
  if (!p.slash || !head || !std::all_of(list->begin() + scalars, list->end(), point)) {
    const DiagRow& cause = numbers ? old_number::pocketPoints : old_number::pocketHead;
    context_.report(old_number::as(cause, diagnose(p.span, diag::ParameterExpected, "POCKET",
                                                   "eight numbers and the points of the outline")));
    return;
  }
  emitCommand(p, std::move(*list));
}

}  // namespace arelem::frontend
