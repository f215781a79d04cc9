#include "runtime/interpret/expression.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/interpret/function.h"
#include "tests/unit/runtime/interpret/builder.h"

namespace arelem::runtime {
namespace {

using Kind = ir::Expr::Kind;
using test::Builder;
using testing::ElementsAre;

/// The value of X = expression, or NaN when it has none.
double valueOf(Builder& b, ir::ExprId expr) {
  b.assign(b.scalar("X"), expr);
  const Evaluation e = b.run();
  for (const Defined& d : e.defined) {
    if (d.name == "X") {
      return d.scalar;
    }
  }
  return NAN;
}

TEST(Expression, ComputesTheFourOperations) {
  Builder b;  // (7 - 3) * 2.5 / 4 + 1 = 3.5
  const auto difference = b.op(Kind::subtract, b.num(7), b.num(3));
  const auto product = b.op(Kind::multiply, difference, b.num(2.5));
  EXPECT_EQ(valueOf(b, b.op(Kind::add, b.op(Kind::divide, product, b.num(4)), b.num(1))), 3.5);
  EXPECT_EQ(b.sink.errors(), 0U);
}

TEST(Expression, NegatesWithoutMinusZero) {
  Builder b;
  EXPECT_FALSE(std::signbit(valueOf(b, b.op(Kind::negate, b.num(0)))));
}

TEST(Expression, DivisionByZeroHasNoValue) {
  Builder b;
  EXPECT_TRUE(std::isnan(valueOf(b, b.op(Kind::divide, b.num(0), b.num(0)))));
  EXPECT_THAT(b.reported(), ElementsAre("63"));
}

TEST(Expression, OverflowIsAnErrorOfTheOperation) {
  Builder b;
  EXPECT_TRUE(std::isnan(valueOf(b, b.op(Kind::multiply, b.num(1e308), b.num(10)))));
  EXPECT_THAT(b.reported(), ElementsAre("E0403"));
}

TEST(Expression, LongChainsDoNotExhaustTheStack) {
  Builder b;
  ir::ExprId sum = b.num(0);
  for (int i = 0; i < 200000; ++i) {
    sum = b.op(Kind::add, sum, b.num(1));
  }
  EXPECT_EQ(valueOf(b, sum), 200000.0);
}

TEST(Expression, DeepNestingIsRefused) {
  Builder b;
  ir::ExprId e = b.num(1);
  for (int i = 0; i < 100000; ++i) {
    e = b.op(Kind::negate, e);
  }
  EXPECT_TRUE(std::isnan(valueOf(b, e)));
  EXPECT_THAT(b.reported(), ElementsAre("56"));
}

TEST(Expression, NestedAssignmentStoresItsValue) {
  Builder b;  // X = (A = 2) + A
  const ir::SymbolId a = b.scalar("A");
  const ir::ExprId sum = b.op(Kind::add, b.nestedAssign(a, b.num(2)), b.use(a));
  EXPECT_EQ(valueOf(b, sum), 4.0);
}

TEST(Expression, UseBeforeValueIsReportedOnce) {
  Builder b;
  const ir::SymbolId a = b.scalar("A");
  b.assign(b.scalar("X"), b.use(a));
  b.assign(b.scalar("Y"), b.use(a));
  b.assign(a, b.num(1));
  EXPECT_EQ(b.run().defined.size(), 1U);
  EXPECT_THAT(b.reported(), ElementsAre("255"));
}

TEST(Expression, NamesThatLostTheirDefinitionToTheFrontendStaySilent) {
  Builder b;  // no statement assigns A: its own was refused and reported before
  EXPECT_TRUE(std::isnan(valueOf(b, b.use(b.scalar("A")))));
  EXPECT_TRUE(b.sink.all().empty());
}

TEST(Expression, EntitiesAreNotNumbers) {
  Builder b;
  const ir::SymbolId p = b.entity("P1", EntityType::point);
  b.define(p, b.numbers({1, 2, 3}));
  EXPECT_TRUE(std::isnan(valueOf(b, b.use(p))));
  EXPECT_THAT(b.reported(), ElementsAre("51"));
}

TEST(Power, WholeExponentsMultiply) {
  EXPECT_EQ(*interpret::power(2, 10), 1024.0);
  EXPECT_EQ(*interpret::power(-2, 3), -8.0);
  EXPECT_EQ(*interpret::power(2, -1), 0.5);
  EXPECT_EQ(*interpret::power(0, 0), 1.0);
  EXPECT_EQ(*interpret::power(-3, 2.0000005), 9.0);  // within 1e-6 of a whole number
  EXPECT_EQ(*interpret::power(1, 1e9), 1.0);
}

TEST(Power, OtherExponentsTakeTheRoot) {
  EXPECT_EQ(*interpret::power(16, 0.25), 2.0);
}

TEST(Power, FailuresNameTheirOldNumbers) {
  const auto legacy = [](const Result<double>& r) { return std::string(r.failure().row->legacy); };
  EXPECT_EQ(legacy(interpret::power(-4, 0.5)), "68");
  EXPECT_EQ(legacy(interpret::power(0, -1)), "63");
  EXPECT_FALSE(interpret::power(10, 400).ok());
}

struct NumberCase {
  Word function;
  std::vector<double> x;
  double value;
};
class Functions : public testing::TestWithParam<NumberCase> {};
TEST_P(Functions, HaveTheirValue) {
  const auto& [function, x, value] = GetParam();
  EXPECT_DOUBLE_EQ(*interpret::functionOfNumbers(function, x), value) << spell(function);
}
INSTANTIATE_TEST_SUITE_P(Numbers,
                         Functions,
                         testing::Values(NumberCase{Word::SQRTF, {2.25}, 1.5},
                                         NumberCase{Word::SQRTF, {-4}, 2},
                                         NumberCase{Word::SINF, {30}, 0.5},
                                         NumberCase{Word::COSF, {60}, 0.5},
                                         NumberCase{Word::SINF, {3.6e9}, 0},
                                         NumberCase{Word::SINF, {-90}, -1},
                                         NumberCase{Word::COSF, {270}, 0},
                                         NumberCase{Word::SINF, {37}, 0.60181502315204827},
                                         NumberCase{Word::TANF, {45}, 1},
                                         NumberCase{Word::TANF, {135}, -1},
                                         NumberCase{Word::TANF, {180}, 0},
                                         NumberCase{Word::ATANF, {1}, 45},
                                         NumberCase{Word::ATANF, {-1e30}, -90},
                                         NumberCase{Word::ATAN2F, {1, -1}, 135},
                                         NumberCase{Word::ATAN2F, {0, -2}, 180},
                                         NumberCase{Word::ATAN2F, {-0.0, -2}, 180},
                                         NumberCase{Word::ATAN2F, {-3, 0}, -90},
                                         NumberCase{Word::EXPF, {0}, 1},
                                         NumberCase{Word::LOGF, {std::exp(2.0)}, 2},
                                         NumberCase{Word::LOG10F, {1000}, 3},
                                         NumberCase{Word::ABSF, {-7.5}, 7.5}));

class NoFunctionValue : public testing::TestWithParam<NumberCase> {};
TEST_P(NoFunctionValue, IsAnError) {
  EXPECT_FALSE(interpret::functionOfNumbers(GetParam().function, GetParam().x).ok());
}
INSTANTIATE_TEST_SUITE_P(Numbers,
                         NoFunctionValue,
                         testing::Values(NumberCase{Word::TANF, {90}, 0},
                                         NumberCase{Word::TANF, {-270}, 0},
                                         NumberCase{Word::LOGF, {0}, 0},
                                         NumberCase{Word::LOG10F, {-1}, 0},
                                         NumberCase{Word::ATAN2F, {0, 0}, 0},
                                         NumberCase{Word::EXPF, {1000}, 0}));

EntityPtr entity(EntityType type, std::vector<double> canon) {
  auto e = std::make_shared<Entity>();
  e->type = type;
  e->canon = std::move(canon);
  return e;
}

TEST(EntityFunctions, HaveTheirValue) {
  const auto v = entity(EntityType::vector, {1, 2, 2});
  const auto w = entity(EntityType::vector, {2, 0, 3});
  const auto p = entity(EntityType::point, {3, 4, 0});
  const auto circle = entity(EntityType::circle, {1, 1, 0, 0, 0, 1, 5});
  using interpret::functionOfEntities;
  EXPECT_EQ(*functionOfEntities(Word::DOTF, {v, w}), 8.0);
  EXPECT_EQ(*functionOfEntities(Word::LNTHF, {v}), 3.0);
  EXPECT_EQ(*functionOfEntities(Word::LNTHF, {p}), 5.0);
  EXPECT_DOUBLE_EQ(
      *functionOfEntities(Word::ANGLF, {circle, entity(EntityType::point, {1, -3, 9})}), 270.0);
  EXPECT_EQ(*functionOfEntities(Word::NUMF, {entity(EntityType::pattern, std::vector(12, 0.0))}),
            4.0);
  EXPECT_EQ(*functionOfEntities(Word::DISTF, {p, entity(EntityType::point, {0, 0, 12})}), 13.0);
  // Parallel lines with opposite normals: y = 2 and -y = 1, three apart.
  EXPECT_EQ(*functionOfEntities(Word::DISTF, {entity(EntityType::line, {0, 1, 0, 2}),
                                              entity(EntityType::line, {0, -1, 0, 1})}),
            3.0);
}

TEST(EntityFunctions, RefuseOtherOperands) {
  const auto v = entity(EntityType::vector, {1, 2, 2});
  const auto p = entity(EntityType::point, {1, 1, 0});
  const auto circle = entity(EntityType::circle, {1, 1, 0, 0, 0, 1, 5});
  using interpret::functionOfEntities;
  EXPECT_FALSE(functionOfEntities(Word::DOTF, {v, p}).ok());
  EXPECT_FALSE(functionOfEntities(Word::LNTHF, {circle}).ok());
  EXPECT_FALSE(functionOfEntities(Word::ANGLF, {circle, p}).ok());  // the center itself
  EXPECT_FALSE(functionOfEntities(Word::DISTF, {entity(EntityType::line, {0, 1, 0, 2}),
                                                entity(EntityType::line, {1, 0, 0, 2})})
                   .ok());
}

TEST(FunctionCall, RootOfANegativeNumberWarnsAndGoesOn) {
  Builder b;
  EXPECT_EQ(valueOf(b, b.call(Word::SQRTF, {b.num(-9)})), 3.0);
  EXPECT_EQ(b.sink.errors(), 0U);
  EXPECT_THAT(b.reported(), ElementsAre("67"));
}

TEST(FunctionCall, CountAndKindOfArgumentsAreChecked) {
  Builder b;
  valueOf(b, b.call(Word::ATAN2F, {b.num(1)}));
  EXPECT_THAT(b.reported(), ElementsAre("65"));
  Builder c;
  const ir::SymbolId p = c.entity("P1", EntityType::point);
  c.define(p, c.numbers({1, 2, 3}));
  valueOf(c, c.call(Word::SINF, {c.at(p)}));
  EXPECT_THAT(c.reported(), ElementsAre("61"));
}

TEST(FunctionCall, TakesNestedDefinitions) {
  Builder b;  // LNTHF((POINT/3,4,12)) = 13
  const auto nested = b.definition(EntityType::point, {}, b.numbers({3, 4, 12}));
  EXPECT_EQ(valueOf(b, b.call(Word::LNTHF, {nested})), 13.0);
}

}  // namespace
}  // namespace arelem::runtime
