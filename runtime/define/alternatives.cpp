#include "runtime/define/alternatives.h"

#include <algorithm>
#include <cmath>

#include "ir/define/continuation.h"
#include "ir/space/tolerance.h"
#include "runtime/define/parameter_symbol.h"

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
    const bool known = std::any_of(out.others.begin(), out.others.end(), [&](const Alternative& a) {
      return sameOutcome(a.result, result);
    });
    if (!known) {
      out.others.push_back({changed_, std::move(result)});
    }
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
    Trials(type, parameters, context).run(choices(found.form, parameters), found);
  }
  return found;
}

}  // namespace arelem::define
