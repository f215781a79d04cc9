#include "runtime/interpret/spray_words.h"

#include <array>
#include <set>

#include "ir/diag/spray.h"

namespace arelem::runtime::interpret {

namespace {
constexpr std::string_view form =
    "SPRAY/ region, GUN, gun, FILM, h [, OVRLAP, {beta|AVG|RMS|MAX}] [, INSET, "
    "{c|EDGE|MEAN|COMPAT}] "
    "[, ATANGL, deg] [, SPEED, v] [, REVERS] [, MINCST, k1, k2, k3, k4] [, HEIGHT, b1, b2, db] "
    "[, ANGLE, t1, t2, dt]";

class Reader {
 public:
  explicit Reader(Items items) { words_.items = std::move(items); }

  Result<SprayWords> run() {
    const Items& items = words_.items;
    const EntityPtr* work = items.empty() ? nullptr : items[0].entity();
    if (work == nullptr || (*work)->type != EntityType::region) {
      return wrong(items.empty() ? "no parameters" : describe(items[0]) + " in front",
                   "the first parameter is a REGION");
    }
    words_.work = *work;
    next_ = 1;
    while (next_ < items.size()) {
      if (auto failure = one()) {
        return *std::move(failure);
      }
    }
    if (!words_.gun) {
      return wrong("no gun", "GUN, gun is needed");
    }
    if (seen_.count(Word::FILM) == 0) {
      return wrong("no film", "FILM, h is needed");
    }
    if ((words_.sizes || words_.angles) && !words_.prices) {
      return wrong("HEIGHT or ANGLE without MINCST", "a range is searched for the least cost");
    }
    return std::move(words_);
  }

 private:
  static Failure wrong(std::string what, std::string rule) {
    return fail(diag::SprayForm, std::move(what), std::move(rule))
        .withHelp("the form is " + std::string(form));
  }

  std::optional<Failure> one() {
    const Item& item = words_.items[next_];
    const Word* word = std::get_if<Word>(&item.value);
    if (word == nullptr) {
      return wrong(describe(item) + fmt::format(" as parameter {}", next_ + 1),
                   "a word belongs there");
    }
    if (!seen_.insert(*word).second) {
      return wrong(fmt::format("{} twice", spell(*word)), "each word stands once");
    }
    ++next_;
    return value(*word);
  }

  std::optional<Failure> value(Word word) {
    switch (word) {
      case Word::GUN:
        return gun();
      case Word::FILM:
        return numbers(word, {&words_.film});
      case Word::OVRLAP:
        return overlap();
      case Word::INSET:
        return inset();
      case Word::ATANGL:
        return numbers(word, {&words_.degrees});
      case Word::SPEED:
        return numbers(word, {&words_.speed.emplace()});
      case Word::REVERS:
        words_.otherSide = true;
        return std::nullopt;
      case Word::MINCST: {
        spray::Prices& p = words_.prices.emplace();
        return numbers(word, {&p.time, &p.material, &p.overspray, &p.sprayBy});
      }
      case Word::HEIGHT:
        return range(word, words_.sizes);
      case Word::ANGLE:
        return range(word, words_.angles);
      default:
        return wrong(fmt::format("the word {}", spell(word)), "it has no meaning there");
    }
  }

  std::optional<Failure> gun() {
    const EntityPtr* entity =
        next_ < words_.items.size() ? words_.items[next_].entity(EntityType::gun) : nullptr;
    if (entity == nullptr) {
      return wrong(next_ < words_.items.size() ? describe(words_.items[next_]) + " behind GUN"
                                               : "nothing behind GUN",
                   "a GUN belongs there");
    }
    words_.gun = *entity;
    ++next_;
    return std::nullopt;
  }

  std::optional<Failure> numbers(Word word, std::initializer_list<double*> into) {
    for (double* place : into) {
      const double* value = next_ < words_.items.size() ? words_.items[next_].number() : nullptr;
      if (value == nullptr) {
        return wrong(fmt::format("{} with too few numbers", spell(word)),
                     fmt::format("it needs {}", into.size()));
      }
      *place = *value;
      ++next_;
    }
    return std::nullopt;
  }

  std::optional<Failure> range(Word word, std::optional<spray::Range>& into) {
    spray::Range& r = into.emplace();
    return numbers(word, {&r.from, &r.to, &r.step});
  }

  /// A word of a list or a number.
  template <class Choice, std::size_t n>
  std::optional<Failure> choice(Word word,
                                const std::array<std::pair<Word, Choice>, n>& choices,
                                std::variant<double, Choice>& into) {
    for (const auto& [name, meaning] : choices) {
      if (next_ < words_.items.size() && words_.items[next_].is(name)) {
        into = meaning;
        ++next_;
        return std::nullopt;
      }
    }
    double value = 0.0;
    auto failure = numbers(word, {&value});
    into = value;
    return failure;
  }

  std::optional<Failure> overlap() {
    using spray::Measure;
    return choice(
        Word::OVRLAP,
        std::array{std::pair{Word::AVG, Measure::average}, std::pair{Word::RMS, Measure::rms},
                   std::pair{Word::MAX, Measure::largest}},
        words_.overlap);
  }
  std::optional<Failure> inset() {
    using spray::InsetRule;
    return choice(
        Word::INSET,
        std::array{std::pair{Word::EDGE, InsetRule::edge}, std::pair{Word::MEAN, InsetRule::mean},
                   std::pair{Word::COMPAT, InsetRule::program}},
        words_.inset);
  }

  SprayWords words_;
  std::size_t next_ = 0;
  std::set<Word> seen_;
};
}  // namespace

Result<SprayWords> readSprayWords(Items items) {
  return Reader(std::move(items)).run();
}

}  // namespace arelem::runtime::interpret
