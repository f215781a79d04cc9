#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/runtime/interpret/builder.h"

namespace arelem::runtime {
namespace {

using Kind = ir::Expr::Kind;
using test::Builder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

double scalarOf(const Evaluation& e, std::string_view name) {
  for (const Defined& d : e.defined) {
    if (d.name == name) {
      return d.scalar;
    }
  }
  return -1e99;
}

/// I = 0, S = 0; A) S = S + I; I = I + 1; IF(I - last) A, A, B; B) the end.
struct Loop {
  ir::SymbolId i, sum;
  explicit Loop(Builder& b, double last) : i(b.scalar("I")), sum(b.scalar("S")) {
    b.assign(i, b.num(0));
    b.assign(sum, b.num(0));
    const auto top = b.assign(sum, b.op(Kind::add, b.use(sum), b.use(i)), "A");
    b.assign(i, b.op(Kind::add, b.use(i), b.num(1)));
    b.put(ir::Branch{b.op(Kind::subtract, b.use(i), b.num(last)), b.to(top), b.to(top), b.to(5)});
    b.assign(b.scalar("END"), b.num(1), "B");
  }
};

TEST(Control, BranchesOnTheSign) {
  Builder b;
  Loop loop(b, 10);
  const Evaluation e = b.run();
  EXPECT_EQ(scalarOf(e, "S"), 55.0);
  EXPECT_EQ(scalarOf(e, "I"), 11.0);
  EXPECT_EQ(scalarOf(e, "END"), 1.0);
  EXPECT_EQ(e.steps, 2U + 3U * 11U + 1U);
  EXPECT_TRUE(e.complete);
}

TEST(Control, DecimalStepsCountAsOnPaper) {
  // I = .2 in steps of .03 reaches .5 at the tenth; IF(.5 - I) then finds zero and goes round once
  // more.
  Builder b;
  const ir::SymbolId i = b.scalar("I"), n = b.scalar("N");
  b.assign(i, b.num(0.2));
  b.assign(n, b.num(0));
  const auto top = b.assign(i, b.op(Kind::add, b.use(i), b.num(0.03)), "A");
  b.assign(n, b.op(Kind::add, b.use(n), b.num(1)));
  b.put(ir::Branch{b.op(Kind::subtract, b.num(0.5), b.use(i)), b.to(5), b.to(top), b.to(top)});
  b.assign(b.scalar("END"), b.num(1), "B");
  EXPECT_EQ(scalarOf(b.run(), "N"), 11.0);
}

TEST(Control, StepLimitNamesTheLoop) {
  Builder b;
  b.options.limits.steps = 1000;
  Loop loop(b, 1e9);
  const Evaluation e = b.run();
  EXPECT_FALSE(e.complete);
  EXPECT_EQ(e.steps, 1000U);
  EXPECT_THAT(b.reported(), ElementsAre("E0801"));
  ASSERT_EQ(b.sink.all()[0].labels.size(), 1U);
  EXPECT_THAT(b.sink.all()[0].labels[0].text, HasSubstr("loop from `A` went round 332 times"));
}

TEST(Control, InterruptStopsTheRun) {
  Builder b;
  InterruptFlag flag{true};
  b.options.interrupted = &flag;
  Loop loop(b, 1e9);
  EXPECT_FALSE(b.run().complete);
  EXPECT_THAT(b.reported(), ElementsAre("E0810"));
}

TEST(Control, BranchWithoutValueGoesOn) {
  Builder b;
  const ir::SymbolId x = b.scalar("X");
  b.put(ir::Branch{b.op(Kind::divide, b.num(1), b.num(0)), b.to(0), b.to(0), b.to(0)});
  b.assign(x, b.num(4));
  EXPECT_EQ(scalarOf(b.run(), "X"), 4.0);
  EXPECT_THAT(b.reported(), ElementsAre("63"));
}

TEST(Control, ErrorsInALoopAreReportedOnce) {
  Builder b;
  const ir::SymbolId i = b.scalar("I"), x = b.scalar("X");
  b.assign(i, b.num(0));
  const auto top = b.assign(x, b.op(Kind::divide, b.num(1), b.num(0)), "A");
  b.assign(i, b.op(Kind::add, b.use(i), b.num(1)));
  b.put(ir::Branch{b.op(Kind::subtract, b.use(i), b.num(50)), b.to(top), b.to(4), b.to(4)});
  EXPECT_EQ(scalarOf(b.run(), "I"), 50.0);
  EXPECT_THAT(b.reported(), ElementsAre("63"));
}

TEST(Call, RunsTheBlockAndComesBack) {
  Builder b;
  const ir::SymbolId x = b.scalar("X"), y = b.scalar("Y");
  b.put(ir::Call{ir::BlockId{1}, "MAC"});
  b.assign(y, b.op(Kind::add, b.use(x), b.num(1)));
  b.newBlock("MAC");
  b.assign(x, b.num(5));
  EXPECT_EQ(scalarOf(b.run(), "Y"), 6.0);
}

TEST(Call, DiagnosticsAndActionsTellWhereTheyWereCalledFrom) {
  Builder b;
  b.put(ir::Call{ir::BlockId{1}, "OUTER"});
  b.newBlock("OUTER");
  b.put(ir::Call{ir::BlockId{2}, "INNER"});
  b.newBlock("INNER");
  b.assign(b.scalar("X"), b.op(Kind::divide, b.num(1), b.num(0)));
  b.locate(Word::GOTO, b.numbers({1, 2, 3}));
  const Evaluation e = b.run();
  ASSERT_THAT(b.reported(), ElementsAre("63"));
  const Span outer = b.program.blocks[0].statements[0].span;
  const Span inner = b.program.blocks[1].statements[0].span;
  EXPECT_THAT(b.sink.all()[0].calledFrom, ElementsAre(inner, outer));
  ASSERT_EQ(e.actions.size(), 1U);
  EXPECT_EQ(e.actions[0].calls->call, inner);
  EXPECT_EQ(e.actions[0].calls->outer->call, outer);
}

TEST(Call, RecursionEndsAtTheDepthLimit) {
  Builder b;
  b.put(ir::Call{ir::BlockId{1}, "MAC"});
  b.newBlock("MAC");
  b.put(ir::Call{ir::BlockId{1}, "MAC"});
  EXPECT_TRUE(b.run().complete);
  EXPECT_THAT(b.reported(), ElementsAre("231"));
  EXPECT_EQ(b.sink.all()[0].calledFrom.size(), 64U);
}

TEST(Fini, EndsTheProgram) {
  Builder b;
  b.put(ir::Fini{});
  b.assign(b.scalar("X"), b.num(1));
  const Evaluation e = b.run();
  ASSERT_EQ(e.actions.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<Fini>(e.actions[0].body));
  EXPECT_THAT(e.defined, IsEmpty());
}

TEST(RunControl, WithoutEffectIsCounted) {
  Builder b;
  b.command(Word::NOPOST);
  b.command(Word::NOPOST);
  b.command(Word::CLPRNT);
  b.run();
  EXPECT_THAT(b.reported(), ElementsAre("W0474", "W0474"));
  EXPECT_THAT(b.sink.all()[0].message, HasSubstr("(2 times)"));
}

TEST(RunControl, WhatIsNotAvailableIsAnError) {
  Builder b;
  b.command(Word::OBTAIN, {Word::OFF});
  b.run();
  EXPECT_THAT(b.reported(), ElementsAre("E0473"));
}

}  // namespace
}  // namespace arelem::runtime
