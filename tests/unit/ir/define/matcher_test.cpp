#include "ir/define/matcher.h"

#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace arelem::define {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;
using Symbols = std::vector<Symbol>;
using T = EntityType;
using W = Word;

Symbol w(Word word) {
  return Symbol::of(word);
}
Symbol e(EntityType type) {
  return Symbol::of(type);
}
Symbol s() {
  return Symbol::scalar();
}

std::string formOf(Word noun, const Symbols& symbols) {
  const auto found = match(noun, symbols);
  const auto* form = std::get_if<FormId>(&found);
  return form != nullptr ? std::string(row(*form).idText) : "none";
}

Mismatch mismatchOf(Word noun, const Symbols& symbols) {
  const auto found = match(noun, symbols);
  EXPECT_TRUE(std::holds_alternative<Mismatch>(found));
  return std::holds_alternative<Mismatch>(found) ? std::get<Mismatch>(found) : Mismatch{};
}

Symbol example(const Expectation& wanted) {
  if (wanted.sort != Symbol::Sort::entity) {
    return {wanted.sort, wanted.word, {}};
  }
  unsigned code = 0;
  while ((wanted.types >> code & 1U) == 0) {
    ++code;
  }
  return e(static_cast<EntityType>(code));
}

/// Every way through the automaton that passes no node more than `visits` times, as example
/// symbols.
class Paths {
 public:
  Paths(const Pattern& pattern, int visits)
      : pattern_(pattern), left_(pattern.nodes.size(), visits) {
    walk(pattern.start);
  }
  std::vector<Symbols> all;

 private:
  void walk(int at) {
    if (at < 0 || left_[static_cast<std::size_t>(at)] == 0 || all.size() > 3000) {
      return;
    }
    --left_[static_cast<std::size_t>(at)];
    const Pattern::Node& node = pattern_.nodes[static_cast<std::size_t>(at)];
    if (node.kind == Pattern::Node::Kind::end) {
      all.push_back(now_);
    } else if (node.kind == Pattern::Node::Kind::take) {
      now_.push_back(example(node.wanted));
      walk(node.next);
      now_.pop_back();
    } else {
      walk(node.next);
      walk(node.other);
    }
    ++left_[static_cast<std::size_t>(at)];
  }
  const Pattern& pattern_;
  std::vector<int> left_;
  Symbols now_;
};

Word nounOf(const FormRow& form) {
  return form.anyNoun ? W::SPHERE : form.noun;
}

TEST(Forms, EveryPatternCompiles) {
  for (const FormRow& form : formTable()) {
    std::string error;
    EXPECT_FALSE(compile(form.pattern, &error).nodes.empty());
    EXPECT_EQ(error, "") << form.idText;
  }
}

TEST(Forms, CountOfTheReference) {
  // The reference has 142 ids. TC-08, TC-09, CN-03, CN-04, NS-01 to NS-03 and RV-01 are no forms of
  // their own; TORUS (2), the XYZ format of TC-07 and points of path splines (2) are more rows.
  // Nouns that are arelem's own are counted apart.
  const std::map<std::string_view, std::size_t> own = {
      {"GUN", 6}, {"REGION", 3}, {"REVOLV", 1}, {"MESH", 1}, {"BSPLIN", 5}};
  std::map<std::string_view, std::size_t> found;
  std::size_t reference = 0;
  for (const FormRow& form : formTable()) {
    if (own.contains(spell(form.noun)) && !form.anyNoun) {
      ++found[spell(form.noun)];
    } else {
      ++reference;
    }
  }
  EXPECT_EQ(reference, 142U - 8U + 3U + 2U);
  EXPECT_EQ(found, own);
}

TEST(Forms, NamesOfScalarsAreNoMisspeltKinds) {
  const std::set<std::string_view> known = {
      "x", "y", "z", "x1", "y1", "z1", "x2", "y2", "z2", "x3", "y3", "x4", "y4", "x5", "y5", "r",
      "deg", "s", "s1", "s2", "v", "b", "a", "c", "d", "e", "f", "g", "h", "p", "q", "t", "dist",
      "i", "j", "k", "cos", "len", "dx", "dy", "dz", "n", "u", "major", "minor", "a1", "b1", "c1",
      "d1", "a2", "b2", "c2", "d2", "a3", "b3", "c3", "d3", "m1", "m2", "m3", "m4", "m5", "m6",
      "m7", "m8", "m9", "value", "start", "stop",
      // of guns, regions and meshes
      "litersPerMinute", "share", "mmPerSecond", "on", "off", "c0", "kPa", "place", "film", "tol",
      "width"};
  for (const FormRow& form : formTable()) {
    for (const Pattern::Node& node : compile(form.pattern).nodes) {
      if (node.kind == Pattern::Node::Kind::take && node.wanted.sort == Symbol::Sort::scalar) {
        EXPECT_TRUE(known.contains(node.wanted.text)) << form.idText << " " << node.wanted.text;
      }
    }
  }
}

TEST(Forms, EveryWayOfWritingAFormIsFoundAndNoRowHidesAnother) {
  for (const FormRow& form : formTable()) {
    const Pattern pattern = compile(form.pattern);
    const Paths paths(pattern, 2);
    EXPECT_FALSE(paths.all.empty()) << form.idText;
    for (const Symbols& symbols : paths.all) {
      EXPECT_EQ(formOf(nounOf(form), symbols), form.idText) << signature(nounOf(form), symbols);
    }
  }
}

TEST(Forms, AWordOrEntityInTheWrongPlaceIsNotTaken) {
  for (const FormRow& form : formTable()) {
    const Pattern pattern = compile(form.pattern);
    Symbols symbols = Paths(pattern, 1).all.front();
    for (Symbol& symbol : symbols) {
      const Symbol kept = symbol;
      for (const Symbol& wrong : {w(W::FINI), e(T::mesh)}) {
        symbol = wrong;
        if (!form.anyNoun || !(wrong.sort == Symbol::Sort::entity)) {
          EXPECT_NE(formOf(nounOf(form), symbols), form.idText) << signature(nounOf(form), symbols);
        }
      }
      symbol = kept;
    }
  }
}

TEST(Forms, OneMoreOrOneLessIsAnotherFormOrNone) {
  for (const FormRow& form : formTable()) {
    if (form.pattern.find("...") != std::string_view::npos ||
        form.pattern.find('[') != std::string_view::npos) {
      continue;
    }
    const Pattern pattern = compile(form.pattern);
    Symbols more = Paths(pattern, 1).all.front();
    Symbols less = more;
    more.push_back(s());
    less.pop_back();
    EXPECT_FALSE(accepts(pattern, more)) << form.idText;
    EXPECT_FALSE(accepts(pattern, less)) << form.idText;
  }
}

TEST(Matcher, TellsOptionalParts) {
  EXPECT_EQ(formOf(W::LINE, {e(T::point), w(W::ATANGL), s()}), "LN_06");
  EXPECT_EQ(formOf(W::LINE, {e(T::point), w(W::ATANGL), s(), w(W::XAXIS)}), "LN_06");
  EXPECT_EQ(formOf(W::LINE, {e(T::point), w(W::ATANGL), s(), w(W::YAXIS)}), "LN_07");
  EXPECT_EQ(formOf(W::LINE, {e(T::point), w(W::ATANGL), s(), e(T::line)}), "LN_11");
}

TEST(Matcher, TellsRepetitions) {
  EXPECT_EQ(
      formOf(W::PATERN, {w(W::LINEAR), e(T::point), e(T::vector), w(W::INCR), s(), w(W::AT), s()}),
      "PA_03");
  EXPECT_EQ(formOf(W::PATERN, {w(W::LINEAR), e(T::point), e(T::vector), w(W::INCR), s(), s(), s()}),
            "PA_04");
  EXPECT_EQ(formOf(W::PATERN, {w(W::LINEAR), e(T::point), e(T::vector), w(W::INCR), s(), w(W::AT),
                               s(), w(W::INCR), s(), w(W::AT), s()}),
            "PA_03");
}

TEST(Matcher, ALineIsAPlaneButAPlaneIsNoLine) {
  EXPECT_EQ(formOf(W::POINT, {w(W::INTOF), e(T::plane), e(T::line), e(T::plane)}), "PT_09");
  EXPECT_EQ(formOf(W::POINT, {w(W::INTOF), e(T::plane), e(T::plane)}), "none");
}

TEST(Mismatch, NamesAWrongWordAndWhatWouldFit) {
  const Mismatch m = mismatchOf(W::POINT, {w(W::ZLARGE), w(W::INTOF), e(T::line), e(T::circle)});
  EXPECT_EQ(m.kind, Mismatch::Kind::wrongWord);
  EXPECT_EQ(m.position, 0U);
  EXPECT_THAT(m.expected, UnorderedElementsAre("XLARGE", "XSMALL", "YLARGE", "YSMALL"));
  ASSERT_FALSE(m.nearest.empty());
  EXPECT_EQ(m.nearest.front(), FormId::PT_04);
}

TEST(Mismatch, NamesAWrongTypeAndEverythingThatWouldFit) {
  const Mismatch m = mismatchOf(W::POINT, {w(W::XLARGE), w(W::INTOF), e(T::line), e(T::plane)});
  EXPECT_EQ(m.kind, Mismatch::Kind::wrongType);
  EXPECT_EQ(m.position, 3U);
  EXPECT_THAT(m.expected, UnorderedElementsAre("circle", "conic"));
}

TEST(Mismatch, NamesAMissingParameter) {
  const Mismatch m = mismatchOf(W::CIRCLE, {w(W::CENTER), e(T::point), w(W::RADIUS)});
  EXPECT_EQ(m.kind, Mismatch::Kind::missing);
  EXPECT_EQ(m.position, 3U);
  EXPECT_THAT(m.expected, ElementsAre("r"));
}

TEST(Mismatch, TrustsAWordThatBeginsAForm) {
  // Another word would cost less than the second half axis; ELLIPS says that an ellipse is meant.
  const Mismatch m = mismatchOf(W::GUN, {w(W::ELLIPS), s(), w(W::SPEED), s()});
  EXPECT_EQ(m.kind, Mismatch::Kind::missing);
  EXPECT_EQ(m.position, 2U);  // before or behind the number: the last is told
  EXPECT_EQ(m.nearest.front(), FormId::GN_01);
  EXPECT_THAT(m.expected, ElementsAre("b"));
}

TEST(Mismatch, NamesASurplusParameter) {
  const Mismatch m = mismatchOf(W::POINT, {s(), s(), s(), s()});
  EXPECT_EQ(m.kind, Mismatch::Kind::surplus);
  EXPECT_EQ(m.nearest.front(), FormId::PT_01);
}

TEST(Mismatch, NothingNearIsSaidSo) {
  const Mismatch m = mismatchOf(W::CONE, {w(W::XAXIS), w(W::YAXIS)});
  EXPECT_EQ(m.kind, Mismatch::Kind::noneIsNear);
  EXPECT_THAT(m.nearest, Contains(FormId::CO_01));
}

TEST(Mismatch, LongListsStayCheap) {
  Symbols symbols{w(W::RANDOM)};
  symbols.insert(symbols.end(), 100'000, e(T::point));
  EXPECT_EQ(formOf(W::PATERN, symbols), "PA_12");
  symbols[500] = e(T::circle);
  EXPECT_EQ(formOf(W::PATERN, symbols), "none");
}

TEST(Signature, ShortensLongLists) {
  EXPECT_EQ(signature(W::POINT, Symbols{w(W::INTOF), e(T::line), e(T::circle)}),
            "POINT/ INTOF, line, circle");
  EXPECT_THAT(signature(W::PATERN, Symbols(200, s())), HasSubstr("(200 parameters)"));
}

TEST(Pattern, SaysWhatIsWrong) {
  std::string error;
  EXPECT_EQ(compile("{XLARGE | YLARGE", &error).nodes.size(), 1U);
  EXPECT_THAT(error, HasSubstr("`}` is missing"));
  EXPECT_EQ(compile("point ]", &error).nodes.size(), 1U);
  EXPECT_THAT(error, HasSubstr("surplus text"));
}

}  // namespace
}  // namespace arelem::define
