#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/interpret/motion.h"

namespace arelem::runtime {
namespace {

using testing::ElementsAre;

/// A pattern of points (1,0,0), (2,0,0) ... or a PARLEL grid, defined column after column with
/// every second one backwards, where the point of column c and row r has the coordinates c and r.
class Visit {
 public:
  using Modifier = std::variant<double, Word>;

  /// What GOTO/PAT, modifiers visits: "2" for the point of x = 2, "2^3" when lifted by 3, "/" for
  /// CYCLE/NOMORE and "*" for CYCLE/ON.
  std::string line(int count, const std::vector<Modifier>& modifiers) {
    for (int i = 1; i <= count; ++i) {
      entity_->canon.insert(entity_->canon.end(), {double(i), 0, 0});
    }
    return visit(modifiers);
  }
  /// Two columns of three rows: 00 01 02 12 11 10.
  std::string grid(const std::vector<Modifier>& modifiers) {
    entity_->canon = {0, 0, 0, 0, 1, 0, 0, 2, 0, 1, 2, 0, 1, 1, 0, 1, 0, 0};
    entity_->pattern = {PatternShape::Kind::parallel, 2};
    return visit(modifiers);
  }
  [[nodiscard]] std::vector<std::string> reported() const {
    std::vector<std::string> result;
    for (const Diagnostic& d : sink_.all()) {
      result.emplace_back(d.kind().legacy.empty() ? d.kind().code : d.kind().legacy);
    }
    return result;
  }

 private:
  std::string visit(const std::vector<Modifier>& modifiers) {
    entity_->type = EntityType::pattern;
    entity_->name = "PAT";
    interpret::Items items{{EntityPtr(entity_), {}}};
    for (const Modifier& m : modifiers) {
      std::visit([&items](auto value) { items.push_back({value, {}}); }, m);
    }
    const ir::Program program;
    const Options options;
    const ir::Statement statement;
    Evaluation out;
    interpret::State state(program, options, sink_, out);
    state.statement = &statement;
    interpret::gotoPattern(state, items);
    std::string route;
    for (const Action& action : out.actions) {
      route += (route.empty() ? "" : " ") + shown(action);
    }
    return route;
  }

  std::string shown(const Action& action) const {
    if (const auto* locate = std::get_if<Locate>(&action.body)) {
      const Vec3& p = locate->point;
      const bool isGrid = entity_->pattern.kind == PatternShape::Kind::parallel;
      EXPECT_EQ(locate->name, "PAT");
      return fmt::format("{}", p.x()) + (isGrid ? fmt::format("{}", p.y()) : "") +
             (p.z() != 0.0 ? fmt::format("^{}", p.z()) : "");
    }
    const auto& post = std::get<cl::Post>(std::get<Pass>(action.body).body);
    EXPECT_EQ(post.word, Word::CYCLE);
    return post.arguments[0] == cl::Value(Word::NOMORE) ? "/" : "*";
  }

  std::shared_ptr<Entity> entity_ = std::make_shared<Entity>();
  CollectingSink sink_;
};

TEST(Pattern, DefinitionOrderAndInverse) {
  Visit plain;
  EXPECT_EQ(plain.line(4, {}), "1 2 3 4");
  Visit inverse;
  EXPECT_EQ(inverse.line(4, {Word::INVERS}), "4 3 2 1");
}

TEST(Pattern, OmitAndRetainCountInTheOrderOfTheOutput) {
  Visit omit;
  EXPECT_EQ(omit.line(5, {Word::OMIT, 2.0, 4.0}), "1 3 5");
  Visit retain;
  EXPECT_EQ(retain.line(5, {Word::RETAIN, 2.0, 4.0}), "2 4");
  Visit manual;  // the example of the language reference
  EXPECT_EQ(manual.line(12, {Word::INVERS, Word::RETAIN, 2.0, Word::THRU, 4.0, 6.0, 8.0}),
            "11 10 9 7 5");
}

TEST(Pattern, ConstCountsInTheOrderOfTheDefinition) {
  Visit v;
  EXPECT_EQ(v.line(5, {Word::INVERS, Word::CONST, Word::RETAIN, 5.0, 2.0, Word::THRU, 1.0}),
            "5 2 1");
}

TEST(Pattern, AvoidLiftsToTheNextVisitedPoint) {
  Visit v;
  EXPECT_EQ(v.line(4, {Word::AVOID, 2.5, 2.0, 3.0}), "1 2 / 2^2.5 3^2.5 * 3 / 3^2.5 4^2.5 * 4");
  Visit omit;
  EXPECT_EQ(omit.line(4, {Word::OMIT, 3.0, Word::AVOID, 1.0, 2.0}), "1 2 / 2^1 4^1 * 4");
}

TEST(Pattern, AvoidAtTheLastPointWarns) {
  Visit v;
  EXPECT_EQ(v.line(2, {Word::AVOID, 1.0, 2.0}), "1 2 / 2^1");
  EXPECT_THAT(v.reported(), ElementsAre("W0464"));
}

TEST(Pattern, ZigzagVisitsRows) {
  Visit plain;
  EXPECT_EQ(plain.grid({}), "00 01 02 12 11 10");
  Visit zigzag;
  EXPECT_EQ(zigzag.grid({Word::ZIGZAG}), "00 10 11 01 02 12");
  Visit both;
  EXPECT_EQ(both.grid({Word::INVERS, Word::ZIGZAG}), "12 02 01 11 10 00");
}

struct Wrong {
  std::vector<Visit::Modifier> modifiers;
  std::string number;
};
class PatternErrors : public testing::TestWithParam<Wrong> {};
TEST_P(PatternErrors, KeepTheirNumbers) {
  Visit v;
  EXPECT_EQ(v.line(5, GetParam().modifiers), "");
  EXPECT_THAT(v.reported(), ElementsAre(GetParam().number));
}
INSTANTIATE_TEST_SUITE_P(Modifiers,
                         PatternErrors,
                         testing::Values(Wrong{{Word::OMIT, 1.0, Word::RETAIN, 2.0}, "811"},
                                         Wrong{{Word::OMIT, 6.0}, "812"},
                                         Wrong{{Word::OMIT, 0.0}, "812"},
                                         Wrong{{Word::OMIT, 1.5}, "812"},
                                         Wrong{{2.0}, "830"},
                                         Wrong{{Word::XAXIS}, "832"},
                                         Wrong{{Word::OMIT, 1.0, Word::INVERS}, "833"},
                                         Wrong{{Word::INVERS, Word::INVERS}, "834"},
                                         Wrong{{Word::ZIGZAG}, "835"},
                                         Wrong{{Word::OMIT}, "836"},
                                         Wrong{{Word::AVOID, 1.0}, "836"},
                                         Wrong{{Word::OMIT, 1.0, Word::THRU}, "836"},
                                         Wrong{{Word::OMIT, 3.0, 2.0}, "838"},
                                         Wrong{{Word::OMIT, 2.0, Word::AVOID, 1.0, 2.0}, "838"}));

TEST(Pattern, RangesUnderZigzagAndConstStayInAColumn) {
  Visit v;
  v.grid({Word::ZIGZAG, Word::CONST, Word::OMIT, 3.0, Word::THRU, 4.0});
  EXPECT_THAT(v.reported(), ElementsAre("837"));
}

}  // namespace
}  // namespace arelem::runtime
