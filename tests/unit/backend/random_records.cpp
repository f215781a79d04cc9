#include "tests/unit/backend/random_records.h"

#include <array>
#include <cmath>
#include <string>

namespace arelem::test {

namespace {
class Maker {
 public:
  explicit Maker(std::mt19937_64& random) : random_(random) {}

  cl::Record next() {
    record_.isn += chance(3) ? 0 : below(4);
    record_.cardId = chance(10) ? name() : "";
    record_.body = body();
    return record_;
  }

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
  bool chance(int of) { return below(of) == 0; }
  double number() {
    switch (below(4)) {
      case 0:
        return below(2000) - 1000;
      case 1:
        return 0.0;
      default:
        return std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random_), below(40) - 20);
    }
  }
  std::vector<double> numbers(int count) {
    std::vector<double> values(static_cast<std::size_t>(count));
    for (double& value : values) {
      value = number();
    }
    return values;
  }
  std::string name() {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
    std::string text;
    for (int i = 0, length = 1 + below(6); i < length; ++i) {
      text += letters[static_cast<std::size_t>(below(36))];
    }
    return text;
  }
  std::string maybeName() { return chance(3) ? "" : name(); }
  int subscript() { return chance(3) ? below(1000) : 0; }

  cl::SurfaceValue surface(EntityType type) {
    return {type, maybeName(), subscript(), numbers(canonicalCount(type))};
  }
  /// Text that the vocabulary does not hold, sometimes longer than a word of the tape.
  std::string foreign() { return chance(2) ? name() + "_" : "CSI_SET_FLUTE_LENGTH_" + name(); }

  cl::Value value() {
    constexpr std::array words = {Word::ON,   Word::OFF,   Word::CLW,  Word::CCLW,   Word::IPM,
                                  Word::MMPM, Word::MM,    Word::FEET, Word::NOMORE, Word::XYPLAN,
                                  Word::RPM,  Word::RAPID, Word::LEFT};
    switch (below(3)) {
      case 0:
        return words[static_cast<std::size_t>(below(static_cast<int>(words.size())))];
      case 1:
        return foreign();
      default:
        return number();
    }
  }
  std::vector<cl::Value> values() {
    std::vector<cl::Value> list;
    for (int i = 0, count = below(6); i < count; ++i) {
      list.push_back(value());
    }
    return list;
  }
  cl::Body post() {
    constexpr std::array words = {Word::SPINDL, Word::COOLNT, Word::FEDRAT,
                                  Word::LOADTL, Word::CYCLE,  Word::RAPID};
    switch (below(7)) {
      case 0:
        return cl::Post{Word::TRACUT, "", {surface(EntityType::matrix)}};
      case 1:
        return cl::Post{
            Word::COPY, "", {number(), Word::MODIFY, surface(EntityType::matrix), number()}};
      case 2:
        return cl::Post{Word::CLRSRF, "", {surface(EntityType::plane)}};
      case 3:
        return cl::Post{Word::CLEARP,
                        "",
                        {surface(chance(2) ? EntityType::cylinder : EntityType::sphere), number()}};
      case 4:
        return cl::Post{Word::END, foreign(), values()};
      case 5:
        return cl::Post{Word::MACHIN, "", {name() + "_", number()}};
      default:
        return cl::Post{words[static_cast<std::size_t>(below(6))], "", values()};
    }
  }
  cl::Body motion() {
    cl::Motion body;
    constexpr std::array kinds = {cl::Motion::Kind::from, cl::Motion::Kind::go,
                                  cl::Motion::Kind::continuation};
    body.kind = kinds[static_cast<std::size_t>(below(3))];
    body.name = maybeName();
    body.subscript = subscript();
    body.withAxis = axis_;
    body.coordinates = numbers(static_cast<int>(body.stride()) * (1 + below(40)));
    return body;
  }
  cl::Body body() {
    constexpr std::array switches = {Word::CUT, Word::DNTCUT, Word::W_2DCALC, Word::W_3DCALC,
                                     Word::NDTEST};
    constexpr std::array units = {Word::MM, Word::CM, Word::INCHES, Word::FEET};
    switch (below(12)) {
      case 0:
        return cl::Text{chance(2) ? Word::PPRINT : Word::PARTNO, " " + foreign() + " " + foreign()};
      case 1:
        return cl::Surface{1 + below(5), below(9),
                           surface(chance(2) ? EntityType::circle : EntityType::cylinder)};
      case 2:
        return cl::Switch{switches[static_cast<std::size_t>(below(5))]};
      case 3:
        return cl::Values{Word::CUTTER, numbers(1 + below(7))};
      case 4:
        return cl::Values{chance(2) ? Word::INTOL : Word::OUTTOL, numbers(4)};
      case 5:
        axis_ = chance(2);
        return cl::Multax{axis_};
      case 6:
        return cl::Units{units[static_cast<std::size_t>(below(4))]};
      case 7:
        return chance(2) ? cl::Body(cl::Diagnostic{below(4000) - 2000})
                         : cl::Body(cl::Listing{chance(2)});
      case 8:
        return chance(2) ? cl::Body(cl::Card{})
                         : cl::Body(cl::Raw{10000 + below(9), below(50), {random_(), random_()}});
      case 9:
      case 10:
        return post();
      default:
        return motion();
    }
  }

  std::mt19937_64& random_;
  cl::Record record_;
  bool axis_ = false;
};
}  // namespace

std::vector<cl::Record> randomRecords(std::mt19937_64& random, int count) {
  Maker maker(random);
  std::vector<cl::Record> records;
  for (int i = 0; i < count; ++i) {
    records.push_back(maker.next());
  }
  records.push_back({records.empty() ? 1 : records.back().isn + 1, "", Span{}, cl::Fini{}});
  return records;
}

}  // namespace arelem::test
