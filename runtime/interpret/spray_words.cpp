#include "runtime/interpret/spray_words.h"

#include <algorithm>
#include <array>

#include "ir/diag/spray.h"
#include "runtime/interpret/worded.h"

namespace arelem::runtime::interpret {

namespace {
constexpr std::string_view regionForm =
    "SPRAY/ region, GUN, gun, FILM, h [, OVRLAP, {beta|AVG|RMS|MAX}] [, INSET, "
    "{c|EDGE|MEAN|COMPAT}] "
    "[, ATANGL, deg] [, SPEED, v] [, REVERS] [, MINCST, k1, k2, k3, k4] [, HEIGHT, b1, b2, db] "
    "[, ANGLE, t1, t2, dt]";
constexpr std::string_view surfaceForm =
    "SPRAY/ surface, GUN, gun, FILM, h, {ULINES|VLINES|SECTN, plane|RADIAL, point, vector} "
    "[, LIMITS [, u1, u2, v1, v2] [, {XLARGE|XSMALL|YLARGE|YSMALL|ZLARGE|ZSMALL}, plane]...] [, "
    "STEP, r] [, CHORD, tol] [, PAST, d] [, CLEARP, c] [, SPEED, v] [, REVERS] [, MINRAD, OFF]";

constexpr std::array sideWords = {Word::XLARGE, Word::XSMALL, Word::YLARGE,
                                  Word::YSMALL, Word::ZLARGE, Word::ZSMALL};

class Reader : private WordedReader {
 public:
  explicit Reader(const Items& items) : WordedReader(items), given_(items) {}

  Result<SprayWords> run() {
    const EntityPtr* work = given_.empty() ? nullptr : given_[0].entity();
    if (work == nullptr) {
      return wrong(given_.empty() ? "no parameters" : describe(given_[0]) + " in front",
                   "the first parameter is a region or a surface");
    }
    words_.work = *work;
    if (auto failure = readWords(1)) {
      return *std::move(failure);
    }
    if (!words_.gun) {
      return wrong("no gun", "GUN, gun is needed");
    }
    if (!has(Word::FILM)) {
      return wrong("no film", "FILM, h is needed");
    }
    if ((words_.sizes || words_.angles) && !words_.prices) {
      return wrong("HEIGHT or ANGLE without MINCST", "a range is searched for the least cost");
    }
    if (!words_.ofRegion() && words_.lines == SprayWords::Lines::none) {
      return wrong("no lines", "a surface needs ULINES, VLINES, SECTN or RADIAL");
    }
    return std::move(words_);
  }

 private:
  [[nodiscard]] bool ofRegion() const { return words_.work && words_.ofRegion(); }
  [[nodiscard]] Failure wrong(std::string what, std::string rule) const override {
    return fail(diag::SprayForm, std::move(what), std::move(rule))
        .withHelp("the form is " +
                  std::string(words_.work && !ofRegion() ? surfaceForm : regionForm));
  }

  [[nodiscard]] Failure refused(std::string_view name,
                                double value,
                                std::string_view rule) const override {
    return fail(diag::SprayValue, name, value, rule);
  }

  std::optional<Failure> value(Word word) override {
    return ofRegion() ? regionValue(word) : surfaceValue(word);
  }

  /// What both kinds of work take; none where the word is not one of them.
  std::optional<std::optional<Failure>> commonValue(Word word) {
    switch (word) {
      case Word::GUN:
        return gun();
      case Word::FILM:
        return numbers(word, {&words_.film});
      case Word::SPEED:
        return numbers(word, {&words_.speed.emplace()});
      case Word::REVERS:
        words_.otherSide = true;
        return std::optional<Failure>();
      default:
        return std::nullopt;
    }
  }

  std::optional<Failure> regionValue(Word word) {
    switch (word) {
      case Word::OVRLAP:
        return overlap();
      case Word::INSET:
        return inset();
      case Word::ATANGL:
        return numbers(word, {&words_.degrees});
      case Word::MINCST: {
        spray::Prices& p = words_.prices.emplace();
        return numbers(word, {&p.time, &p.material, &p.overspray, &p.sprayBy});
      }
      case Word::HEIGHT:
        return range(word, words_.sizes);
      case Word::ANGLE:
        return range(word, words_.angles);
      default:
        return otherValue(word);
    }
  }

  std::optional<Failure> surfaceValue(Word word) {
    using Lines = SprayWords::Lines;
    switch (word) {
      case Word::ULINES:
        return lines(Lines::alongU);
      case Word::VLINES:
        return lines(Lines::alongV);
      case Word::SECTN: {
        auto failure = lines(Lines::sections);
        return failure ? failure
                       : entity(word, {EntityType::plane, EntityType::line}, words_.plane);
      }
      case Word::RADIAL: {
        auto failure = lines(Lines::radial);
        failure = failure ? failure : entity(word, {EntityType::point}, words_.axisPlace);
        return failure ? failure : entity(word, {EntityType::vector}, words_.axisVector);
      }
      case Word::LIMITS:
        return limits();
      case Word::STEP:
        return step();
      case Word::CHORD:
        return numbers(word, {&words_.chord.emplace()});
      case Word::PAST:
        return numbers(word, {&words_.past});
      case Word::CLEARP:
        return numbers(word, {&words_.clear.emplace()});
      case Word::MINRAD:
        return radiusOff();
      default:
        return otherValue(word);
    }
  }

  std::optional<Failure> otherValue(Word word) {
    if (auto common = commonValue(word)) {
      return *std::move(common);
    }
    return meaningless(word);
  }

  std::optional<Failure> step() {
    auto failure = numbers(Word::STEP, {&words_.step});
    return failure || words_.step > 0.0 ? failure : refused("STEP", words_.step, "above 0");
  }

  std::optional<Failure> lines(SprayWords::Lines kind) {
    if (words_.lines != SprayWords::Lines::none) {
      return wrong("lines twice", "one of ULINES, VLINES, SECTN and RADIAL stands once");
    }
    words_.lines = kind;
    return std::nullopt;
  }

  std::optional<Failure> entity(Word word,
                                std::initializer_list<EntityType> types,
                                EntityPtr& into) {
    const EntityPtr* found = next() != nullptr ? next()->entity() : nullptr;
    if (found == nullptr || std::find(types.begin(), types.end(), (*found)->type) == types.end()) {
      return wrong(fmt::format("no {} behind {}", spell(*types.begin()), spell(word)),
                   "it says how the surface is cut");
    }
    into = *found;
    skip();
    return std::nullopt;
  }

  /// Four numbers, planes with the side that is kept, or both.
  std::optional<Failure> limits() {
    const auto sideNext = [this] {
      const Word* word = next() != nullptr ? std::get_if<Word>(&next()->value) : nullptr;
      const bool side = word != nullptr &&
                        std::find(sideWords.begin(), sideWords.end(), *word) != sideWords.end();
      return side ? word : nullptr;
    };
    if (sideNext() == nullptr) {
      spray::Limits4& l = words_.limits.emplace();
      if (auto failure = numbers(Word::LIMITS, {&l.u0, &l.u1, &l.v0, &l.v1})) {
        return failure;
      }
    }
    while (const Word* side = sideNext()) {
      SprayWords::Side& one = words_.sides.emplace_back();
      one.modifier = *side;
      skip();
      if (auto failure = entity(*side, {EntityType::plane, EntityType::line}, one.plane)) {
        return failure;
      }
    }
    return std::nullopt;
  }

  std::optional<Failure> radiusOff() {
    if (next() == nullptr || !next()->is(Word::OFF)) {
      return wrong("MINRAD without OFF", "MINRAD, OFF leaves out the check of curvature");
    }
    words_.checkRadius = false;
    skip();
    return std::nullopt;
  }

  std::optional<Failure> gun() {
    words_.gun = take(EntityType::gun);
    return words_.gun ? std::nullopt
                      : std::optional(wrong(next() != nullptr ? describe(*next()) + " behind GUN"
                                                              : "nothing behind GUN",
                                            "a GUN belongs there"));
  }

  std::optional<Failure> numbers(Word word, std::initializer_list<double*> into) {
    for (double* place : into) {
      if (!more()) {
        return wrong(fmt::format("{} with too few numbers", spell(word)),
                     fmt::format("it needs {}", into.size()));
      }
      *place = *next()->number();
      skip();
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
      if (next() != nullptr && next()->is(name)) {
        into = meaning;
        skip();
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

  const Items& given_;
  SprayWords words_;
};
}  // namespace

Result<SprayWords> readSprayWords(Items items) {
  Result<SprayWords> words = Reader(items).run();
  if (words) {
    words->items = std::move(items);
  }
  return words;
}

}  // namespace arelem::runtime::interpret
