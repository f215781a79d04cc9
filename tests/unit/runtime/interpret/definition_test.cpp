#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/runtime/interpret/builder.h"

namespace arelem::runtime {
namespace {

using Kind = ir::Expr::Kind;
using test::Builder;
using testing::ElementsAre;
using testing::IsEmpty;

const Defined* find(const Evaluation& e, std::string_view name, int subscript = 0) {
  for (const Defined& d : e.defined) {
    if (d.name == name && d.subscript == subscript) {
      return &d;
    }
  }
  return nullptr;
}
std::vector<double> canon(const Evaluation& e, std::string_view name, int subscript = 0) {
  const Defined* d = find(e, name, subscript);
  return d != nullptr && d->entity ? d->entity->canon : std::vector<double>{};
}

TEST(Arrays, TruncateSubscripts) {
  Builder b;
  const ir::SymbolId a = b.scalar("A", 3);
  b.put(ir::Assign{b.at(a, b.num(2.9)), b.num(7)});
  EXPECT_EQ(find(b.run(), "A", 2)->scalar, 7.0);
}

TEST(Arrays, CheckTheRange) {
  Builder b;
  const ir::SymbolId a = b.scalar("A", 3);
  b.put(ir::Assign{b.at(a, b.num(0.9)), b.num(7)});
  b.put(ir::Assign{b.at(a, b.num(4)), b.num(7)});
  b.put(ir::Assign{b.at(a), b.num(7)});
  b.put(ir::Assign{b.at(b.scalar("B"), b.num(1)), b.num(7)});
  EXPECT_THAT(b.run().defined, IsEmpty());
  EXPECT_THAT(b.reported(), ElementsAre("104", "104", "105", "108"));
}

TEST(Arrays, LimitIsTold) {
  Builder b;
  b.options.limits.array = 10;
  b.scalar("A", 11);
  b.run();
  EXPECT_THAT(b.reported(), ElementsAre("E0804"));
}

/// A(1) to A(5) hold 1 to 5; the coordinates of points show which elements a list names.
struct ListCase {
  double low, high, step;  // 0: not written
  bool descending;
  std::vector<double> elements;
};
class Lists : public testing::TestWithParam<ListCase> {};
TEST_P(Lists, ExpandInOrder) {
  Builder b;
  const ir::SymbolId a = b.scalar("A", 5);
  for (int i = 1; i <= 5; ++i) {
    b.put(ir::Assign{b.at(a, b.num(i)), b.num(i)});
  }
  const auto bound = [&b](double v) { return v == 0.0 ? ir::ExprId{} : b.num(v); };
  ir::ElementRange range{a,
                         bound(GetParam().low),
                         bound(GetParam().high),
                         bound(GetParam().step),
                         GetParam().descending,
                         {}};
  b.command(Word::PRINT, {b.num(3), range});
  const Evaluation e = b.run();
  std::vector<double> got;
  for (const Printed& p : e.printed) {
    got.push_back(p.subscript);
  }
  EXPECT_EQ(got, GetParam().elements);
}
INSTANTIATE_TEST_SUITE_P(Forms,
                         Lists,
                         testing::Values(ListCase{0, 0, 0, false, {1, 2, 3, 4, 5}},  // A(ALL)
                                         ListCase{2, 4, 0, false, {2, 3, 4}},        // A(2,THRU,4)
                                         ListCase{0, 3, 0, false, {1, 2, 3}},        // A(THRU,3)
                                         ListCase{2, 0, 2, false, {2, 4}},  // A(2,THRU,ALL,INCR,2)
                                         ListCase{1, 5, 3, true, {5, 2}},   // A(1,THRU,5,DECR,3)
                                         ListCase{0, 0, 2, true, {5, 3, 1}},  // A(ALL,DECR,2)
                                         ListCase{
                                             1, 5, -2, false, {5, 3, 1}},  // A(1,THRU,5,INCR,-2)
                                         ListCase{4, 2, 0, false, {4}},    // low above high
                                         ListCase{4, 2, 1, true, {2}},     //
                                         ListCase{2.9, 3.9, 1.5, false, {2, 3}}));  // truncated

TEST(ListErrors, AreTold) {
  Builder b;
  const ir::SymbolId a = b.scalar("A", 5);
  b.command(Word::PRINT,
            {b.num(3), ir::ElementRange{a, b.num(1), b.num(9), {}, false, {{0}, 1, 1}}});
  b.command(Word::PRINT,
            {b.num(3), ir::ElementRange{a, b.num(1), b.num(3), b.num(0.5), false, {{0}, 2, 1}}});
  b.locate(Word::GOTO, {ir::ElementRange{a, {}, {}, {}, false, {{0}, 3, 1}}});
  b.run();
  EXPECT_THAT(b.reported(), ElementsAre("104", "109", "103"));
}

/// The last nested definition is executed first, as the old system's listings show.
TEST(Definitions, StoreNamedAndNestedEntities) {
  Builder b;  // L1 = LINE/(P1 = POINT/0,0),(POINT/1,0,0)
  const ir::SymbolId p = b.entity("P1", EntityType::point);
  const ir::SymbolId l = b.entity("L1", EntityType::line);
  const auto named = b.definition(EntityType::point, b.at(p), b.numbers({0, 0}));
  const auto unnamed = b.definition(EntityType::point, {}, b.numbers({1, 0, 0}));
  b.define(l, {named, unnamed});
  const Evaluation e = b.run();
  ASSERT_THAT(b.reported(), IsEmpty());
  ASSERT_EQ(e.defined.size(), 3U);
  EXPECT_EQ(e.defined[0].name, "");
  EXPECT_EQ(e.defined[1].name, "P1");
  EXPECT_EQ(e.defined[2].name, "L1");
  EXPECT_THAT(canon(e, "L1"), ElementsAre(0, -1, 0, 0));  // normal to the right of the direction
}

TEST(Definitions, FailuresPointAtTheirOperandsAndPoisonTheName) {
  Builder b;  // parallel lines have no point in common
  const ir::SymbolId l1 = b.entity("L1", EntityType::line);
  const ir::SymbolId l2 = b.entity("L2", EntityType::line);
  const ir::SymbolId p = b.entity("P1", EntityType::point);
  b.define(l1, b.numbers({0, 0, 1, 0}));
  b.define(l2, b.numbers({0, 1, 1, 1}));
  b.define(p, {Word::INTOF, b.at(l1), b.at(l2)});
  b.locate(Word::GOTO, {b.at(p)});
  b.define(b.entity("V1", EntityType::vector), {b.at(p), b.at(p)});
  const Evaluation e = b.run();
  ASSERT_THAT(b.reported(), ElementsAre("1005"));
  const Diagnostic& d = b.sink.all()[0];
  ASSERT_EQ(d.labels.size(), 2U);
  EXPECT_EQ(d.labels[0].text, "`L1` defined here");
  EXPECT_EQ(d.labels[1].text, "`L2` defined here");
  EXPECT_EQ(d.labels[0].span, find(e, "L1")->definition);
  EXPECT_THAT(e.actions, IsEmpty());
}

TEST(Redefinition, NeedsCanon) {
  Builder b;
  const ir::SymbolId p = b.entity("P1", EntityType::point);
  b.define(p, b.numbers({1, 2, 3}));
  b.define(p, b.numbers({4, 5, 6}));
  EXPECT_THAT(canon(b.run(), "P1"), ElementsAre(1, 2, 3));
  EXPECT_THAT(b.reported(), ElementsAre("1002"));
}

TEST(Redefinition, CanonOnAllowsIt) {
  Builder b;
  const ir::SymbolId p = b.entity("P1", EntityType::point);
  b.define(p, b.numbers({1, 2, 3}));
  b.command(Word::CANON, {Word::ON});
  b.define(p, b.numbers({4, 5, 6}));
  b.command(Word::CANON, {Word::OFF});
  b.define(p, b.numbers({7, 8, 9}));
  EXPECT_THAT(canon(b.run(), "P1"), ElementsAre(4, 5, 6));
  EXPECT_THAT(b.reported(), ElementsAre("1002"));
}

TEST(Redefinition, CanonFormsAllowIt) {
  Builder b;
  const ir::SymbolId p = b.entity("P1", EntityType::point);
  b.define(p, {Word::CANON, b.num(1), b.num(2), b.num(3)});
  b.define(p, {Word::CANON, b.num(4), b.num(5), b.num(6)});
  b.define(p, {b.at(p), Word::CANON, ir::Omitted{}, b.num(50)});
  EXPECT_THAT(canon(b.run(), "P1"), ElementsAre(4, 50, 6));
  const auto nested = b.definition(EntityType::point, {}, b.numbers({7, 8, 9}));
  b.define(p, {nested, Word::CANON});
  EXPECT_THAT(canon(b.run(), "P1"), ElementsAre(7, 8, 9));
  EXPECT_THAT(b.reported(), IsEmpty());
}

TEST(Obtain, FillsScalarsAndSkipsEmptyPlaces) {
  Builder b;
  const ir::SymbolId c = b.entity("C1", EntityType::circle);
  const ir::SymbolId y = b.scalar("Y"), r = b.scalar("R");
  b.define(c, b.numbers({3, 4, 5}));
  std::vector<std::optional<ir::Target>> targets(7);
  targets[1] = b.at(y);
  targets[6] = b.at(r);
  b.put(ir::Obtain{EntityType::circle, b.arg(b.at(c)), targets});
  const Evaluation e = b.run();
  EXPECT_EQ(find(e, "Y")->scalar, 4.0);
  EXPECT_EQ(find(e, "R")->scalar, 5.0);
  EXPECT_THAT(b.reported(), IsEmpty());
}

TEST(Obtain, ErrorsKeepTheirNumbers) {
  Builder b;
  const ir::SymbolId p = b.entity("P1", EntityType::point);
  const ir::SymbolId v = b.entity("V1", EntityType::vector);
  const ir::SymbolId x = b.scalar("X");
  b.define(p, b.numbers({3, 4, 5}));
  b.put(ir::Obtain{EntityType::line, b.arg(b.at(p)), {b.at(x)}});
  b.put(ir::Obtain{EntityType::point, b.arg(b.num(1)), {b.at(x)}});
  b.put(ir::Obtain{EntityType::point, b.arg(b.at(p)), {b.at(x), {}, {}, b.at(x)}});
  b.put(ir::Obtain{EntityType::point, b.arg(b.at(p)), {b.at(v)}});
  b.run();
  EXPECT_THAT(b.reported(), ElementsAre("153", "152", "154", "156"));
}

TEST(Refsys, MovesEntitiesThatAreUsedOutside) {
  Builder b;  // the example of the language reference: TRANSL 5,5,0 and P1 = 2,4,0 give 7,9,0
  const ir::SymbolId m = b.entity("M1", EntityType::matrix);
  const ir::SymbolId p = b.entity("P1", EntityType::point);
  const ir::SymbolId q = b.entity("P2", EntityType::point);
  const ir::SymbolId x = b.scalar("X");
  b.define(m, {Word::TRANSL, b.num(5), b.num(5), b.num(0)});
  b.command(Word::REFSYS, {b.at(m)});
  b.define(p, b.numbers({2, 4, 0}));
  b.command(Word::REFSYS, {Word::NOMORE});
  b.locate(Word::GOTO, {b.at(p)});
  b.put(ir::Obtain{EntityType::point, b.arg(b.at(p)), {b.at(x)}});
  b.define(q, {b.at(p), Word::CANON});
  const Evaluation e = b.run();
  ASSERT_EQ(e.actions.size(), 1U);
  EXPECT_EQ(std::get<Locate>(e.actions[0].body).point, Vec3(7, 9, 0));
  EXPECT_THAT(canon(e, "P1"), ElementsAre(2, 4, 0));
  EXPECT_EQ(find(e, "P1")->entity->referenceSystem, "M1");
  EXPECT_EQ(find(e, "X")->scalar, 2.0);
  EXPECT_THAT(canon(e, "P2"), ElementsAre(7, 9, 0));
  EXPECT_THAT(b.reported(), IsEmpty());
}

TEST(Refsys, MovesFromOneSystemToAnother) {
  Builder b;  // M1 shifts by 5 in x, M2 by 2 in y: (1,1,0) of M1 is (6,1,0) at the base and
              // (6,-1,0) in M2
  const ir::SymbolId m1 = b.entity("M1", EntityType::matrix);
  const ir::SymbolId m2 = b.entity("M2", EntityType::matrix);
  const ir::SymbolId p = b.entity("P1", EntityType::point);
  const ir::SymbolId q = b.entity("P2", EntityType::point);
  b.define(m1, {Word::TRANSL, b.num(5), b.num(0), b.num(0)});
  b.define(m2, {Word::TRANSL, b.num(0), b.num(2), b.num(0)});
  b.command(Word::REFSYS, {b.at(m1)});
  b.define(p, b.numbers({1, 1, 0}));
  b.command(Word::REFSYS, {b.at(m2)});
  b.define(q, {b.at(p), Word::CANON});
  b.locate(Word::GOTO, {b.at(q)});
  b.locate(Word::GOTO, b.numbers({6, -1, 0}));
  const Evaluation e = b.run();
  EXPECT_THAT(canon(e, "P2"), ElementsAre(6, -1, 0));
  ASSERT_EQ(e.actions.size(), 2U);
  EXPECT_EQ(std::get<Locate>(e.actions[0].body).point, Vec3(6, 1, 0));
  EXPECT_EQ(std::get<Locate>(e.actions[1].body).point, Vec3(6, 1, 0));
  EXPECT_THAT(b.reported(), ElementsAre("W0428"));
}

TEST(Refsys, TiltedLinesServeAsTheirTraces) {
  Builder b;  // y = 2 seen from a system turned by 60 degrees about X: half of y, so y = 4 in its
              // XY plane
  const ir::SymbolId m = b.entity("M1", EntityType::matrix);
  const ir::SymbolId l1 = b.entity("L1", EntityType::line);
  const ir::SymbolId l2 = b.entity("L2", EntityType::line);
  const ir::SymbolId p = b.entity("P1", EntityType::point);
  b.define(m, {Word::YZROT, b.num(60)});
  b.define(l1, b.numbers({1, 2, 0, 2}));
  b.command(Word::REFSYS, {b.at(m)});
  b.define(l2, b.numbers({3, 0, 3, 1}));
  b.define(p, {Word::INTOF, b.at(l1), b.at(l2)});
  const Evaluation e = b.run();
  ASSERT_THAT(b.reported(), IsEmpty());
  EXPECT_THAT(canon(e, "P1"), ElementsAre(3, testing::DoubleNear(4, 1e-14), 0));
}

TEST(Refsys, ErrorsKeepTheirNumbers) {
  Builder b;
  b.command(Word::REFSYS, {b.num(1)});
  b.command(Word::REFSYS, {b.definition(EntityType::matrix, {}, {Word::SCALE, b.num(2)})});
  b.run();
  EXPECT_THAT(b.reported(), ElementsAre("651", "651"));
}

TEST(Zsurf, SuppliesTheMissingCoordinate) {
  Builder b;
  const ir::SymbolId p = b.entity("P1", EntityType::point);
  b.command(Word::ZSURF, b.numbers({1, 0, 2, 10}));  // z = (10 - x) / 2
  b.define(p, b.numbers({4, 7}));
  b.locate(Word::GOTO, b.numbers({6, 1}));
  const Evaluation e = b.run();
  EXPECT_THAT(canon(e, "P1"), ElementsAre(4, 7, 3));
  EXPECT_EQ(std::get<Locate>(e.actions[0].body).point, Vec3(6, 1, 2));
}

TEST(Zsurf, ErrorsKeepTheirNumbers) {
  Builder b;
  b.command(Word::ZSURF, b.numbers({1, 0, 0, 5}));
  b.command(Word::ZSURF, b.numbers({1, 0, 0}));
  b.run();
  EXPECT_THAT(b.reported(), ElementsAre("26", "576"));
}

TEST(Print, ListsValuesInOrder) {
  Builder b;
  const ir::SymbolId a = b.scalar("A"), u = b.scalar("U");
  const ir::SymbolId p = b.entity("P1", EntityType::point);
  b.assign(a, b.num(2.5));
  b.define(p, b.numbers({1, 2, 3}));
  b.put(ir::Text{Word::TITLES, " HEADING"});
  b.command(Word::PRINT, {b.num(2), b.use(a), b.at(p), b.use(u)});
  b.command(Word::PRINT, {b.num(3), Word::ALL});
  const Evaluation e = b.run();
  ASSERT_EQ(e.printed.size(), 6U);
  EXPECT_EQ(e.printed[0].title, " HEADING");
  EXPECT_EQ(e.printed[1].scalar, 2.5);
  EXPECT_EQ(e.printed[1].mode, 2);
  EXPECT_EQ(e.printed[2].entity->canon[2], 3.0);
  EXPECT_TRUE(e.printed[3].undefined);
  EXPECT_EQ(e.printed[4].name, "A");
  EXPECT_EQ(e.printed[5].name, "P1");
}

TEST(Print, OnListsEveryEntityAsItIsComputed) {
  Builder b;
  const ir::SymbolId p = b.entity("P1", EntityType::point);
  b.command(Word::PRINT, {Word::ON});
  b.define(p, b.numbers({1, 2, 3}));
  b.put(ir::Define{b.definition(EntityType::point, {}, b.numbers({4, 5, 6}))});
  b.command(Word::PRINT, {Word::OFF});
  b.define(b.entity("P2", EntityType::point), b.numbers({7, 8, 9}));
  const Evaluation e = b.run();
  ASSERT_EQ(e.printed.size(), 2U);
  EXPECT_EQ(e.printed[0].name, "P1");
  EXPECT_EQ(e.printed[1].name, "");
}

TEST(Print, ShowsNamesWithoutValueAsUndefined) {
  Builder b;
  b.command(Word::PRINT, {b.num(2), std::string("NUM")});
  const Evaluation e = b.run();
  ASSERT_EQ(e.printed.size(), 1U);
  EXPECT_EQ(e.printed[0].name, "NUM");
  EXPECT_TRUE(e.printed[0].undefined);
}

TEST(Print, WrongModesAreTold) {
  Builder b;
  b.command(Word::PRINT, {b.num(5), Word::ALL});
  b.command(Word::PRINT, {b.num(1.5), Word::ALL});
  b.command(Word::PRINT, {Word::ALL});
  b.command(Word::READ, {b.num(1)});
  b.run();
  EXPECT_THAT(b.reported(), ElementsAre("326", "326", "326", "326"));
}

TEST(Punch, WritesADeck) {
  Builder b;
  const ir::SymbolId a = b.scalar("A");
  const ir::SymbolId p = b.entity("P1", EntityType::point);
  b.assign(a, b.num(0.1));
  b.define(p, b.numbers({1, 2, 3}));
  b.command(Word::PUNCH, {b.num(1), Word::ALL});
  b.command(Word::PUNCH, {b.num(3), Word::ALL});
  EXPECT_EQ(b.run().deck,
            "A,0,SCALAR,1,0.1\nP1,0,POINT,3,1,2,3\nENDPCH\nP1,0,POINT,3,1,2,3\nENDPCH\n");
}

}  // namespace
}  // namespace arelem::runtime
