#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/runtime/interpret/builder.h"

namespace arelem::runtime {
namespace {

using test::Builder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

template <class Body>
std::vector<Body> all(const Evaluation& e) {
  std::vector<Body> result;
  for (const Action& action : e.actions) {
    if (const Body* body = std::get_if<Body>(&action.body)) {
      result.push_back(*body);
    }
  }
  return result;
}

/// A program with a point P1 = 1,2,3 and a vector V1 = 0,0,2.
struct Places : Builder {
  ir::SymbolId p1 = entity("P1", EntityType::point);
  ir::SymbolId v1 = entity("V1", EntityType::vector);
  ir::SymbolId l1 = entity("L1", EntityType::line);
  ir::SymbolId l2 = entity("L2", EntityType::line);
  Places() {
    define(p1, numbers({1, 2, 3}));
    define(v1, numbers({0, 0, 2}));
    define(l1, numbers({0, 0, 1, 0}));
    define(l2, numbers({0, 5, 1, 5}));
  }
  std::optional<Locate> place(Word word, std::vector<ir::Argument::Value> arguments) {
    locate(word, std::move(arguments));
    const std::vector<Locate> found = all<Locate>(run());
    return found.empty() ? std::nullopt : std::optional(found.back());
  }
};

TEST(Locating, ReadsEveryCountOfNumbers) {
  for (const std::size_t count : {2U, 3U, 4U, 6U, 7U}) {
    Places b;
    const std::vector<double> all{1, 2, 3, 0, 0, 1, 50};
    std::vector<double> given(all.begin(), all.begin() + static_cast<long>(count));
    if (count == 4) {
      given = {1, 2, 3, 50};
    }
    const auto locate = b.place(Word::GOTO, b.numbers(given));
    ASSERT_TRUE(locate) << count;
    EXPECT_EQ(locate->point, Vec3(1, 2, count == 2 ? 0 : 3)) << count;
    EXPECT_EQ(locate->axis.has_value(), count >= 6) << count;
    EXPECT_EQ(locate->feed, count == 4 || count == 7 ? std::optional(50.0) : std::nullopt) << count;
    EXPECT_EQ(locate->name, "");
  }
}

TEST(Locating, ReadsPointsWithAxisAndFeed) {
  {
    Places b;
    const auto locate = b.place(Word::FROM, {b.at(b.p1)});
    EXPECT_EQ(locate->name, "P1");
    EXPECT_EQ(locate->word, Word::FROM);
  }
  {
    Places b;
    EXPECT_EQ(b.place(Word::GOTO, {b.at(b.p1), b.num(30)})->feed, 30.0);
  }
  {
    Places b;
    const auto locate = b.place(Word::GOTO, {b.at(b.p1), b.num(0), b.num(1), b.num(0), b.num(30)});
    EXPECT_EQ(*locate->axis, Vec3(0, 1, 0));
    EXPECT_EQ(locate->feed, 30.0);
  }
  {
    Places b;
    const auto locate = b.place(Word::GOTO, {b.at(b.p1), b.at(b.v1), b.num(30)});
    EXPECT_EQ(*locate->axis, Vec3(0, 0, 2));
    EXPECT_EQ(locate->feed, 30.0);
  }
}

TEST(Locating, ReadsSteps) {
  {
    Places b;
    EXPECT_EQ(b.place(Word::GODLTA, {b.at(b.v1), b.num(30)})->point, Vec3(0, 0, 2));
  }
  {
    Places b;
    const auto locate = b.place(Word::GODLTA, b.numbers({2.25, 30}));
    EXPECT_EQ(locate->axial, 2.25);
    EXPECT_EQ(locate->feed, 30.0);
  }
  {
    Places b;
    EXPECT_EQ(b.place(Word::GODLTA, b.numbers({1, 2, 3}))->point, Vec3(1, 2, 3));
  }
}

TEST(Locating, WrongCountsNameTheForms) {
  for (const std::size_t count : {1U, 5U, 8U}) {
    Places b;
    EXPECT_FALSE(b.place(Word::GOTO, b.numbers(std::vector<double>(count, 1.0))));
    EXPECT_THAT(b.reported(), ElementsAre("129")) << count;
    EXPECT_THAT(b.sink.all()[0].message, HasSubstr("x,y,z,i,j,k[,u,v,w][,feed]"));
  }
  Places b;
  EXPECT_FALSE(b.place(Word::GOTO, {b.at(b.l1)}));
  EXPECT_THAT(b.reported(), ElementsAre("132"));
  EXPECT_THAT(b.sink.all()[0].message, HasSubstr("the LINE `L1`"));
  Places c;
  EXPECT_FALSE(c.place(Word::GOTO, {Word::ON}));
  EXPECT_THAT(c.reported(), ElementsAre("133"));
  Places d;
  EXPECT_FALSE(d.place(Word::GOTO, d.numbers({1, 2, 3, 0, 0, 0})));
  EXPECT_THAT(d.reported(), ElementsAre("3"));
}

TEST(Locating, FastLaneAgreesWithTheSlowOne) {
  for (const std::uint8_t count : {2, 3, 4, 5, 6, 7, 8, 9, 10}) {
    const std::array<double, 10> n{1, 2, 3, 0.5, 0.25, 1, 50, 1, 0, 20};
    Builder slow;
    slow.locate(Word::GOTO, slow.numbers(std::vector<double>(n.begin(), n.begin() + count)));
    Builder fast;
    fast.put(ir::LocateNumbers{Word::GOTO, count, n});
    const auto a = all<Locate>(slow.run());
    const auto b = all<Locate>(fast.run());
    EXPECT_EQ(slow.reported(), fast.reported());
    ASSERT_EQ(a.size(), b.size()) << int(count);
    if (!a.empty()) {
      EXPECT_EQ(a[0].point, b[0].point);
      EXPECT_EQ(a[0].axis, b[0].axis);
      EXPECT_EQ(a[0].side, b[0].side);
      EXPECT_EQ(a[0].feed, b[0].feed);
    }
  }
}

TEST(Locating, CarriesStatementNumberAndCard) {
  Builder b;
  const auto s = b.locate(Word::GOTO, b.numbers({1, 2, 3}));
  b.program.blocks[0].statements[s].cardId = "00040000";
  const Evaluation e = b.run();
  EXPECT_EQ(e.actions[0].isn, 1);
  EXPECT_EQ(e.actions[0].cardId, "00040000");
  EXPECT_EQ(e.actions[0].origin, b.program.blocks[0].statements[s].span);
}

ir::SurfaceUse use(Builder& b,
                   ir::SymbolId surface,
                   ir::Condition condition = ir::Condition::automatic) {
  return {condition, b.arg(b.at(surface)), {}};
}

TEST(Startups, KeepTheirSurfacesInOrder) {
  Places b;
  b.put(ir::Startup{false, {use(b, b.l1, ir::Condition::past), use(b, b.l2)}, b.num(20)});
  const auto go = all<Startup>(b.run());
  ASSERT_EQ(go.size(), 1U);
  EXPECT_EQ(go[0].surfaces[0].surface->name, "L1");
  EXPECT_EQ(go[0].surfaces[0].condition, ir::Condition::past);
  EXPECT_EQ(go[0].surfaces[1].surface->name, "L2");
  EXPECT_EQ(go[0].feed, 20.0);
}

TEST(Startups, RefuseWhatIsNoSurface) {
  Places b;
  b.put(ir::Startup{false, {use(b, b.p1)}, {}});
  b.put(ir::Startup{true, {use(b, b.l1), use(b, b.l2), use(b, b.l1)}, {}});
  b.put(ir::Startup{false, {use(b, b.l1, ir::Condition::tanto)}, {}});
  EXPECT_THAT(all<Startup>(b.run()), IsEmpty());
  EXPECT_THAT(b.reported(), ElementsAre("139", "129", "133"));
}

TEST(Follows, KeepChecksNumbersAndLabels) {
  Places b;
  const auto target = b.assign(b.scalar("X"), b.num(1), "HERE");
  ir::CheckUse first{use(b, b.l1, ir::Condition::past), b.num(2), b.to(target)};
  ir::CheckUse second{use(b, b.l2), {}, b.to(target)};
  b.put(ir::Follow{ir::Heading::left, b.arg(b.at(b.l1)), {first, second}, {}});
  const Evaluation e = b.run();
  const auto follow = all<Follow>(e);
  ASSERT_EQ(follow.size(), 1U);
  EXPECT_EQ(follow[0].heading, ir::Heading::left);
  EXPECT_EQ(follow[0].checks[0].nth, 2);
  const auto labels = all<Label>(e);
  ASSERT_EQ(labels.size(), 1U);
  EXPECT_EQ(follow[0].checks[0].label, labels[0].key);
  EXPECT_EQ(labels[0].key, target);
}

TEST(Follows, ErrorsKeepTheirNumbers) {
  Places b;
  const ir::CheckUse plain{use(b, b.l2), {}, {}};
  const ir::CheckUse half{use(b, b.l2), b.num(1.5), {}};
  b.put(ir::Follow{ir::Heading::left, b.arg(b.at(b.l1)), {plain, plain}, {}});
  const std::vector<ir::CheckUse> many(Limits{}.checks + 1, plain);
  b.put(ir::Follow{ir::Heading::left, b.arg(b.at(b.l1)), many, {}});
  b.put(ir::Follow{ir::Heading::left, b.arg(b.at(b.l1)), {half}, {}});
  b.put(ir::Follow{ir::Heading::up, b.arg(b.at(b.l1)), {}, {}});
  EXPECT_THAT(all<Follow>(b.run()), IsEmpty());
  EXPECT_THAT(b.reported(), ElementsAre("453", "302", "133", "129"));
}

TEST(Follows, ImpliedChecksNeedAFollowingMotion) {
  Places b;
  const auto follow = [&b](ir::Heading heading, std::vector<ir::CheckUse> checks) {
    b.put(ir::Follow{heading, b.arg(b.at(b.l1)), std::move(checks), {}});
  };
  const ir::CheckUse check{use(b, b.l2), {}, {}};
  follow(ir::Heading::left, {});
  follow(ir::Heading::forward, {check});  // supplies the check surface: fine
  follow(ir::Heading::left, {});
  follow(ir::Heading::up, {check});  // 136
  follow(ir::Heading::left, {});
  b.locate(Word::GOTO, b.numbers({1, 2, 3}));  // 137
  follow(ir::Heading::left, {});
  b.put(ir::Fini{});  // 650
  b.run();
  EXPECT_THAT(b.reported(), ElementsAre("136", "137", "650"));
}

TEST(Parameters, PassWithTheirValues) {
  Builder b;
  b.command(Word::CUTTER, b.numbers({10, 2}));
  b.command(Word::INTOL, b.numbers({0.01, 0.02, 0.03, 0.04}));
  b.command(Word::CUTTER, {Word::OPTION, b.num(2), b.num(0.109), b.num(0)});
  b.command(Word::CUTTER, {Word::OPTION, b.num(2), Word::OFF});
  b.command(Word::MULTAX);
  b.command(Word::GOUGE, {Word::OFF});
  b.command(Word::TLLFT);
  const Evaluation e = b.run();
  ASSERT_THAT(b.reported(), IsEmpty());
  ASSERT_EQ(e.actions.size(), 7U);
  EXPECT_THAT(std::get<Parameter>(e.actions[0].body).values, ElementsAre(10, 2));
  EXPECT_EQ(std::get<Parameter>(e.actions[1].body).values.size(), 4U);
  EXPECT_THAT(*std::get<CutterOption>(e.actions[2].body).ring, ElementsAre(0.109, 0));
  EXPECT_FALSE(std::get<CutterOption>(e.actions[3].body).ring);
  EXPECT_TRUE(std::get<Toggle>(e.actions[4].body).on);
  EXPECT_EQ(std::get<Toggle>(e.actions[5].body).word, Word::GOUGCK);
  EXPECT_FALSE(std::get<Toggle>(e.actions[5].body).on);
  EXPECT_EQ(std::get<ToolRelation>(e.actions[6].body).word, Word::TLLFT);
}

TEST(Parameters, AreChecked) {
  Builder b;
  b.command(Word::CUTTER, b.numbers({10, 2, 3}));
  b.command(Word::INTOL, b.numbers({-0.01}));
  b.command(Word::NUMPTS, b.numbers({0}));
  b.command(Word::MAXDP, {Word::ON});
  b.command(Word::CUTTER, {Word::OPTION, b.num(3), Word::OFF});
  b.command(Word::NOPS, {Word::ON});
  EXPECT_THAT(b.run().actions, IsEmpty());
  EXPECT_THAT(b.reported(), ElementsAre("129", "129", "129", "132", "129", "129"));
}

TEST(ToolAxes, AllForms) {
  Places b;
  b.command(Word::TLAXIS, {b.at(b.v1)});
  b.command(Word::TLAXIS, b.numbers({0, 1, 2}));
  b.command(Word::TLAXIS, {Word::NORMPS});
  b.command(Word::TLAXIS, {b.num(1)});
  b.command(Word::TLAXIS, {Word::PARLEL, b.num(2)});
  b.command(Word::TLAXIS, {Word::ATANGL, b.num(1), b.num(30)});
  b.command(Word::TLAXIS, {Word::ATANGL, b.num(1), b.num(30), b.at(b.v1)});
  b.command(Word::TLAXIS, {Word::ATANGL, b.num(1), b.num(30), Word::CUTANG, b.num(-5)});
  const auto axes = all<ToolAxis>(b.run());
  ASSERT_EQ(axes.size(), 8U);
  EXPECT_EQ(axes[0].vector, Vec3(0, 0, 2));
  EXPECT_EQ(axes[1].vector, Vec3(0, 1, 2));
  EXPECT_EQ(axes[2].kind, ToolAxis::Kind::normalPart);
  EXPECT_EQ(axes[3].kind, ToolAxis::Kind::keep);
  EXPECT_EQ(axes[4].surface, 2);
  EXPECT_EQ(axes[5].alphaDegrees, 30.0);
  EXPECT_TRUE(axes[6].fourAxis);
  EXPECT_EQ(axes[7].cutAngleDegrees, -5.0);
}

TEST(ToolAxes, ErrorsKeepTheirNumbers) {
  Places b;
  const auto null = b.definition(EntityType::vector, {}, b.numbers({0, 0, 0}));
  b.command(Word::TLAXIS, {b.num(2)});
  b.command(Word::TLAXIS, b.numbers({0, 0, 0}));
  b.command(Word::TLAXIS, {Word::PARLEL, b.num(3)});
  b.command(Word::TLAXIS, {Word::ATANGL, b.num(1), b.num(91)});
  b.command(Word::TLAXIS, {Word::ATANGL, b.num(1), b.num(30), Word::CUTANG, b.num(100)});
  b.command(Word::TLAXIS, {Word::ATANGL, b.num(1)});
  b.command(Word::TLAXIS, {Word::ATANGL, b.num(1), b.num(30), null});
  EXPECT_THAT(all<ToolAxis>(b.run()), IsEmpty());
  EXPECT_THAT(b.reported(), ElementsAre("2", "3", "5", "16", "17", "18", "19"));
}

TEST(Directions, FillEmptyPlaces) {
  Places b;
  b.command(Word::INDIRV, {ir::Omitted{}, b.at(b.v1)});
  b.command(Word::INDIRV, b.numbers({1, 1, 0}));
  b.command(Word::INDIRP, {b.at(b.p1)});
  b.command(Word::SRFVCT, b.numbers({0, 0, 0}));
  b.command(Word::INDIRV, b.numbers({0, 0, 0}));
  const auto directions = all<Direction>(b.run());
  ASSERT_EQ(directions.size(), 3U);
  EXPECT_FALSE(directions[0].values[0]);
  EXPECT_EQ(*directions[0].values[1], Vec3(0, 0, 2));
  EXPECT_EQ(*directions[1].values[0], Vec3(1, 1, 0));
  EXPECT_EQ(*directions[2].values[0], Vec3(1, 2, 3));
  EXPECT_THAT(b.reported(), ElementsAre("8", "7"));
}

TEST(Pockets, TakePointsByNameAndByNumber) {
  Places b;
  auto arguments = b.numbers({0.5, 1, 1, 5, 10, 20, 0, 1, 0, 0, 0, 4, 0, 0});
  arguments.emplace_back(b.at(b.p1));
  b.command(Word::POCKET, arguments);
  b.command(Word::POCKET, b.numbers({0.5, 1, 1, 5, 10, 20, 0}));
  b.command(Word::POCKET, b.numbers({0.5, 1, 1, 5, 10, 20, 0, 1, 0, 0}));
  const auto pockets = all<Pocket>(b.run());
  ASSERT_EQ(pockets.size(), 1U);
  EXPECT_THAT(pockets[0].points, ElementsAre(Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(1, 2, 3)));
  EXPECT_EQ(pockets[0].parameters[7], 1.0);
  EXPECT_THAT(b.reported(), ElementsAre("376", "377"));
}

TEST(Posts, ConvertTheirParameters) {
  Places b;
  const ir::SymbolId plane = b.entity("PL1", EntityType::plane);
  b.define(plane, b.numbers({0, 0, 1, 4}));
  b.command(Word::SPINDL, {b.num(2000), Word::CLW});
  b.command(Word::MACHIN, {std::string("PMILL"), b.num(5)});
  b.command(Word::CLRSRF, {b.at(plane), b.num(2)});
  b.put(ir::ForeignCommand{"TPRINT", true, b.args({std::string("T1")})});
  const auto posts = all<Pass>(b.run());
  ASSERT_EQ(posts.size(), 4U);
  const auto post = [&posts](std::size_t i) { return std::get<cl::Post>(posts[i].body); };
  EXPECT_EQ(post(0).arguments, (std::vector<cl::Value>{2000.0, Word::CLW}));
  EXPECT_EQ(post(1).arguments, (std::vector<cl::Value>{std::string("PMILL"), 5.0}));
  EXPECT_EQ(
      post(2).arguments,
      (std::vector<cl::Value>{cl::SurfaceValue{EntityType::plane, "PL1", 0, {0, 0, 1, 4}}, 2.0}));
  EXPECT_EQ(post(3).foreign, "TPRINT");
}

TEST(Posts, ErrorsKeepTheirNumbers) {
  Places b;
  b.command(Word::COOLNT, {b.at(b.l1)});
  b.command(Word::CLRSRF, {b.at(b.p1)});
  b.command(Word::COOLNT, {Word::GOTO});
  b.command(Word::TRACUT, {b.num(1)});
  b.command(Word::COPY, {b.num(1), Word::TRANSL, b.num(1)});
  b.command(Word::INDEX, {Word::NOMORE});
  EXPECT_THAT(all<Pass>(b.run()), IsEmpty());
  EXPECT_THAT(b.reported(), ElementsAre("501", "1006", "W0583", "503", "506", "507", "507"));
}

TEST(Posts, ParametersOfWordsWithoutThemPassWithAWarning) {
  Builder b;
  b.command(Word::STOP, {b.num(1)});
  EXPECT_EQ(all<Pass>(b.run()).size(), 1U);
  EXPECT_EQ(b.sink.errors(), 0U);
  EXPECT_THAT(b.reported(), ElementsAre("505"));
}

TEST(Texts, PassButRemarksDoNot) {
  Builder b;
  b.put(ir::Text{Word::PARTNO, " TEST"});
  b.put(ir::Text{Word::REMARK, " SAYS NOTHING"});
  const auto texts = all<Pass>(b.run());
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_EQ(std::get<cl::Text>(texts[0].body).text, " TEST");
}

}  // namespace
}  // namespace arelem::runtime
