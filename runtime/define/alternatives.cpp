#include "runtime/define/alternatives.h"

#include <algorithm>
#include <cmath>

#include "ir/define/continuation.h"
#include "ir/space/tolerance.h"
#include "runtime/define/parameter_symbol.h"
#include "runtime/geometry/tabulated_cylinder.h"

namespace arelem::define {

namespace {
struct Choice {
  std::size_t position = 0;
  std::vector<Word> words;  ///< the written one first
};

std::vector<Choice> choices(FormId form, std::span<const Parameter> parameters) {
  std::vector<Symbol> symbols;
  std::transform(parameters.begin(), parameters.end(), std::back_inserter(symbols), symbolOf);
  std::vector<Choice> found;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Word* written = std::get_if<Word>(&parameters[i]);
    if (written == nullptr) {
      continue;
    }
    Choice choice{i, wordsInPlace(form, symbols, i)};
    std::stable_partition(choice.words.begin(), choice.words.end(),
                          [written](Word w) { return w == *written; });
    if (choice.words.size() > 1) {
      found.push_back(std::move(choice));
    }
  }
  return found;
}

bool same(const Entity& a, const Entity& b) {
  if (a.canon.size() != b.canon.size()) {
    return false;
  }
  double size = 1.0;
  for (std::size_t i = 0; i < a.canon.size(); ++i) {
    size = std::max({size, std::abs(a.canon[i]), std::abs(b.canon[i])});
  }
  for (std::size_t i = 0; i < a.canon.size(); ++i) {
    if (std::abs(a.canon[i] - b.canon[i]) > tolerance::coincidence * size) {
      return false;
    }
  }
  return true;
}

bool sameOutcome(const Result<Entity>& a, const Result<Entity>& b) {
  if (a.ok() != b.ok()) {
    return false;
  }
  return a.ok() ? same(*a, *b)
                : a.failure().row == b.failure().row && a.failure().message == b.failure().message;
}

/// The point by which a form chooses among the solutions on a tabulated cylinder.
std::optional<std::size_t> nearPointOf(FormId form, std::size_t parameters) {
  const std::size_t at = form == FormId::CI_13 ? 5 : 3;
  const bool chooses = form == FormId::PT_11 || form == FormId::LN_18 || form == FormId::LN_19 ||
                       form == FormId::CI_13;
  return chooses && at < parameters ? std::optional(at) : std::nullopt;
}

/// Places along the curve of the tabulated cylinder among the parameters.
std::vector<Vec3> placesAlong(std::span<const Parameter> parameters) {
  constexpr int inEachInterval = 8;
  std::vector<Vec3> places;
  for (const Parameter& parameter : parameters) {
    const auto* entity = std::get_if<EntityPtr>(&parameter);
    if (entity == nullptr || (*entity)->type != EntityType::tabulatedCylinder) {
      continue;
    }
    const auto curve = geometry::TabulatedCylinder::of((*entity)->canon);
    for (const auto& interval : curve.intervals) {
      for (int k = 0; k <= inEachInterval; ++k) {
        places.push_back(curve.inSpace(interval.at(interval.length * k / inEachInterval).place));
      }
    }
  }
  return places;
}

EntityPtr pointAt(const Vec3& place) {
  Entity entity;
  entity.type = EntityType::point;
  entity.canon = {place.x(), place.y(), place.z()};
  return std::make_shared<const Entity>(std::move(entity));
}

/// Goes through all combinations of words, those with few changes first.
class Trials {
 public:
  Trials(EntityType type, std::span<const Parameter> parameters, const Context& context)
      : type_(type), parameters_(parameters.begin(), parameters.end()), context_(context) {
    context_.remarks = nullptr;
  }

  void run(const std::vector<Choice>& choices, Alternatives& out) {
    for (std::size_t changes = 1; changes <= choices.size(); ++changes) {
      go(choices, 0, changes, out);
    }
    std::stable_partition(out.others.begin(), out.others.end(),
                          [](const Alternative& a) { return a.result.ok(); });
  }

  /// Tries other near points; those that lead to nothing new are forgotten.
  void runAlong(std::size_t position, Alternatives& out) {
    const Parameter written = parameters_[position];
    for (const Vec3& place : placesAlong(parameters_)) {
      if (out.tried >= mostAlternatives) {
        out.all = false;
        break;
      }
      parameters_[position] = pointAt(place);
      ++out.tried;
      Result<Entity> result = define(type_, parameters_, context_);
      if (result.ok() && !same(*result, out.chosen) && !isKnown(result, out)) {
        out.others.push_back({{}, place, std::move(result)});
      }
    }
    parameters_[position] = written;
  }

 private:
  void go(const std::vector<Choice>& choices,
          std::size_t from,
          std::size_t changes,
          Alternatives& out) {
    if (changes == 0) {
      attempt(out);
      return;
    }
    for (std::size_t i = from; i + changes <= choices.size(); ++i) {
      const Choice& choice = choices[i];
      const Parameter written = parameters_[choice.position];
      for (std::size_t k = 1; k < choice.words.size(); ++k) {
        parameters_[choice.position] = choice.words[k];
        changed_.emplace_back(choice.position, choice.words[k]);
        go(choices, i + 1, changes - 1, out);
        changed_.pop_back();
      }
      parameters_[choice.position] = written;
    }
  }

  void attempt(Alternatives& out) {
    if (out.tried >= mostAlternatives) {
      out.all = false;
      return;
    }
    ++out.tried;
    Result<Entity> result = define(type_, parameters_, context_);
    if (result.ok() && same(*result, out.chosen)) {
      return;
    }
    if (!isKnown(result, out)) {
      out.others.push_back({changed_, std::nullopt, std::move(result)});
    }
  }

  static bool isKnown(const Result<Entity>& result, const Alternatives& out) {
    return std::any_of(out.others.begin(), out.others.end(),
                       [&](const Alternative& a) { return sameOutcome(a.result, result); });
  }

  EntityType type_;
  std::vector<Parameter> parameters_;
  Context context_;
  std::vector<std::pair<std::size_t, Word>> changed_;
};
}  // namespace

Result<Alternatives> alternatives(EntityType type,
                                  std::span<const Parameter> parameters,
                                  const Context& context) {
  Result<Entity> chosen = define(type, parameters, context);
  if (!chosen) {
    return chosen.takeFailure();
  }
  Alternatives found;
  found.chosen = *std::move(chosen);
  found.form = found.chosen.form;
  if (found.form != FormId::count) {
    Trials trials(type, parameters, context);
    trials.run(choices(found.form, parameters), found);
    if (const auto near = nearPointOf(found.form, parameters.size())) {
      trials.runAlong(*near, found);
    }
  }
  return found;
}

}  // namespace arelem::define
