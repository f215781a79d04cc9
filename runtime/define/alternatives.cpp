#include "runtime/define/alternatives.h"

#include <algorithm>
#include <cmath>

#include "ir/define/continuation.h"
#include "ir/space/tolerance.h"
#include "runtime/define/parameter_symbol.h"
#include "runtime/geometry/tabulated_cylinder.h"
#include "runtime/spline/cubic.h"

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

/// A place where the distance is least, and how far apart the neighbors are between which it lies.
struct Foot {
  Vec3 place;
  double reach;
};

/// Where the distance from a point of a path spline to `p` is least among its neighbors, ends
/// included; in the order of the parameter.
std::vector<Foot> feetOn(const spline::CubicSpline& curve, const Vec3& p) {
  constexpr int inEachSpan = 24;
  constexpr int halvings = 48;
  const int count = inEachSpan * static_cast<int>(curve.spans());
  const double step = (curve.end() - curve.begin()) / count;
  const auto off = [&](double t) { return (curve.at(t) - p).norm(); };
  std::vector<Foot> feet;
  for (int i = 0; i <= count; ++i) {
    const double t = curve.begin() + step * i;
    const double reach = (curve.at(t + step) - curve.at(t - step)).norm();
    double low = curve.closed() || i > 0 ? t - step : t;
    double high = curve.closed() || i < count ? t + step : t;
    if (off(low) < off(t) || off(high) < off(t) || (curve.closed() && i == count)) {
      continue;
    }
    for (int k = 0; k < halvings; ++k) {  // one least value lies between: thirds
      const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
      (off(a) <= off(b) ? high : low) = off(a) <= off(b) ? b : a;
    }
    feet.push_back({curve.at((low + high) / 2.0), reach});
  }
  return feet;
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

  /// Of a point that is next to another one on a path spline.
  void runFeet(Alternatives& out) {
    const auto* spline = std::get_if<EntityPtr>(parameters_.data());
    const auto* point = std::get_if<EntityPtr>(&parameters_[1]);
    const auto curve = spline::CubicSpline::of((*spline)->canon);
    const Vec3 chosen(out.chosen.canon.data());
    for (const Foot& foot : feetOn(*curve, Vec3((*point)->canon.data()))) {
      ++out.tried;
      if ((foot.place - chosen).norm() > foot.reach) {
        out.others.push_back({{}, foot.place, Result<Entity>(Entity(*pointAt(foot.place)))});
      }
    }
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
    if (found.form == FormId::PT_14) {
      trials.runFeet(found);
    }
    if (const auto near = nearPointOf(found.form, parameters.size())) {
      trials.runAlong(*near, found);
    }
  }
  return found;
}

}  // namespace arelem::define
