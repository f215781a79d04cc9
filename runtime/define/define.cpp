#include "runtime/define/define.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <variant>

#include "ir/define/matcher.h"
#include "ir/diag/diagnostic.h"
#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/parameter_symbol.h"
#include "runtime/define/resolve.h"
#include "runtime/geometry/built.h"

namespace arelem::define {

namespace {

using Method = Result<Resolved> (*)(const Arguments&);
constexpr std::array methods = {
#define ARELEM_FORM(id, noun, method, pattern, meaning) Method{&method},
#define ARELEM_ANY_FORM(id, method, pattern, meaning) Method{&method},
#include "ir/define/forms.def"
#undef ARELEM_FORM
#undef ARELEM_ANY_FORM
};
static_assert(methods.size() == static_cast<std::size_t>(FormId::count));

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;
}  // namespace

Symbol symbolOf(const Parameter& parameter) {
  return std::visit(
      Overloaded{[](Omitted) { return Symbol::empty(); }, [](double) { return Symbol::scalar(); },
                 [](Word word) { return Symbol::of(word); },
                 [](const EntityPtr& entity) { return Symbol::of(entity->type); },
                 [](const std::string&) { return Symbol::text(); }},
      parameter);
}

namespace {
/// "CENTER", "`XLARGE` or `XSMALL`", "a circle, a line or a scalar" ...
std::string choiceOf(const std::vector<std::string>& texts) {
  std::string list;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i != 0) {
      list += i + 1 == texts.size() ? " or " : ", ";
    }
    list += "`" + texts[i] + "`";
  }
  return list;
}

std::string formsHelp(Word noun, const std::vector<FormId>& forms) {
  std::string text = "forms that come near:";
  for (const FormId form : forms) {
    text += "\n  " + syntaxLine(noun, form) + "  (" + std::string(row(form).meaning) + ")";
  }
  return text;
}

Failure failureOf(Word noun, const std::vector<Symbol>& symbols, const Mismatch& mismatch) {
  const std::string_view name = spell(noun);
  const std::size_t number = mismatch.position + 1;
  const auto describeAt = [&] { return describe(symbols[mismatch.position]); };
  Failure failure;
  switch (mismatch.kind) {
    case Mismatch::Kind::noneIsNear:
      failure = fail(diag::NoSuchForm, name, signature(noun, symbols));
      break;
    case Mismatch::Kind::wrongWord:
      failure = fail(diag::WrongModifier, number, name, describeAt(), choiceOf(mismatch.expected));
      break;
    case Mismatch::Kind::wrongType:
      failure =
          fail(diag::WrongParameterType, number, name, describeAt(), choiceOf(mismatch.expected));
      break;
    case Mismatch::Kind::missing:
      failure =
          fail(diag::MissingParameter, number, name, symbols.size(), choiceOf(mismatch.expected));
      break;
    case Mismatch::Kind::surplus:
      failure = fail(diag::SurplusParameter, number, name, describeAt());
      break;
  }
  failure.notes.push_back("written was " + signature(noun, symbols));
  failure.help = formsHelp(noun, mismatch.nearest);
  return failure;
}

bool allFinite(const geometry::Canon& canon) {
  return std::all_of(canon.begin(), canon.end(), [](double v) { return std::isfinite(v); });
}

/// LINE/CANON and PLANE/CANON take any numbers, and programs keep other things in them; only
/// copies may go on with a normal of length 0.
std::optional<Failure> nullNormal(std::span<const Parameter> parameters) {
  std::optional<Failure> failure;
  for (const Parameter& parameter : parameters) {
    if (const Word* word = std::get_if<Word>(&parameter); word != nullptr && *word == Word::CANON) {
      return std::nullopt;
    }
    const EntityPtr* entity = std::get_if<EntityPtr>(&parameter);
    if (entity == nullptr ||
        ((*entity)->type != EntityType::line && (*entity)->type != EntityType::plane)) {
      continue;
    }
    const geometry::Canon& c = (*entity)->canon;
    const double largest = std::max({std::abs(c[0]), std::abs(c[1]), std::abs(c[2])});
    if (!(largest > tolerance::nullDirection)) {
      failure =
          fail(diag::NullDirection, spell((*entity)->type), largest, tolerance::nullDirection);
    }
  }
  return failure;
}

/// Minus zero prints badly and means nothing.
void clearMinusZeros(geometry::Canon& canon) {
  for (double& v : canon) {
    v += 0.0;
  }
}

}  // namespace

Result<Entity> define(EntityType type,
                      std::span<const Parameter> parameters,
                      const Context& context) {
  std::vector<Symbol> symbols(parameters.size());
  std::transform(parameters.begin(), parameters.end(), symbols.begin(), symbolOf);
  const std::optional<Word> noun = findWord(spell(type));
  if (!noun) {
    return fail(diag::NoSuchForm, spell(type), "");
  }
  const std::variant<FormId, Mismatch> found = match(*noun, symbols);
  if (const auto* mismatch = std::get_if<Mismatch>(&found)) {
    return failureOf(*noun, symbols, *mismatch);
  }
  const auto form = static_cast<std::size_t>(std::get<FormId>(found));
  if (auto failure = nullNormal(parameters)) {
    return *std::move(failure);
  }
  Result<Resolved> resolved = methods[form](Arguments(type, parameters, context));
  if (!resolved) {
    return resolved.takeFailure();
  }
  if (!allFinite(resolved->canon)) {
    return fail(diag::NotFinite, spell(type));
  }
  clearMinusZeros(resolved->canon);
  Entity entity;
  entity.type = type;
  entity.form = std::get<FormId>(found);
  entity.canon = std::move(resolved->canon);
  entity.pattern = resolved->pattern;
  entity.built = surface::builtOf(type, entity.canon);
  return entity;
}

}  // namespace arelem::define
