#include "runtime/path/transform.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace arelem::path {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

/// Feeds records by hand and shows what comes out, one short text a record.
class Tape {
 public:
  explicit Tape(const Limits& limits = {}) : transformer_(makeTransformer(out_, sink_, limits)) {}

  Tape& go(double x, double y, double z) {
    cl::Motion motion;
    motion.coordinates = {x, y, z};
    return put(motion);
  }
  Tape& goWithAxis(std::vector<double> six) {
    cl::Motion motion;
    motion.withAxis = true;
    motion.coordinates = std::move(six);
    return put(motion);
  }
  Tape& post(Word word, std::vector<cl::Value> arguments) {
    return put(cl::Post{word, "", std::move(arguments)});
  }
  Tape& put(cl::Body body) {
    cl::Record record;
    record.isn = ++isn_;
    record.body = std::move(body);
    transformer_->accept(record);
    return *this;
  }
  Tape& finish() {
    transformer_->finish();
    return *this;
  }

  [[nodiscard]] std::vector<std::string> shown() const {
    std::vector<std::string> result;
    for (const cl::Record& record : out_.records) {
      if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
        result.push_back(fmt::format("{:g} {:g} {:g}", motion->coordinates[0] + 0.0,
                                     motion->coordinates[1] + 0.0, motion->coordinates[2] + 0.0));
      } else if (const auto* post = std::get_if<cl::Post>(&record.body)) {
        const bool ends = post->arguments.size() == 2 && post->word == Word::INDEX;
        result.push_back(std::string(spell(post->word)) + (ends ? "-" : ""));
      } else {
        result.emplace_back("other");
      }
    }
    return result;
  }
  [[nodiscard]] const std::vector<cl::Record>& records() const { return out_.records; }
  [[nodiscard]] std::vector<std::string> codes() const {
    std::vector<std::string> result;
    for (const Diagnostic& d : sink_.all()) {
      result.emplace_back(d.kind().code);
    }
    return result;
  }

 private:
  cl::Recording out_;
  CollectingSink sink_;
  std::unique_ptr<Transformer> transformer_;
  int isn_ = 0;
};

cl::SurfaceValue matrix(std::vector<double> rows) {
  return {EntityType::matrix, "M1", 0, std::move(rows)};
}
cl::SurfaceValue shift(double x, double y, double z) {
  return matrix({1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z});
}

TEST(Tracut, MovesUntilNomore) {
  Tape tape;
  tape.go(1, 2, 3).post(Word::TRACUT, {shift(10, 0, 0)}).go(1, 2, 3);
  tape.post(Word::TRACUT, {Word::NOMORE}).go(1, 2, 3);
  EXPECT_THAT(tape.shown(), ElementsAre("1 2 3", "TRACUT", "11 2 3", "TRACUT", "1 2 3"));
}

TEST(Tracut, ReplacesTheMatrixInForce) {
  Tape tape;
  tape.post(Word::TRACUT, {shift(10, 0, 0)}).post(Word::TRACUT, {shift(0, 5, 0)}).go(1, 2, 3);
  EXPECT_EQ(tape.shown().back(), "1 7 3");
}

TEST(Tracut, TurnsAxesAndKeepsThemUnit) {
  Tape tape;  // scaled by 2 and turned by 90 degrees about Z
  tape.post(Word::TRACUT, {matrix({0, -2, 0, 0, 2, 0, 0, 0, 0, 0, 2, 0})});
  tape.goWithAxis({1, 0, 0, 0.6, 0, 0.8});
  const auto& motion = std::get<cl::Motion>(tape.records().back().body);
  EXPECT_THAT(motion.coordinates,
              ElementsAre(0, 2, 0, 0, DoubleNear(0.6, 1e-15), DoubleNear(0.8, 1e-15)));
}

TEST(Tracut, ScalesTheRadiusOfACircleRecord) {
  Tape tape;
  tape.post(Word::TRACUT, {matrix({2, 0, 0, 1, 0, 2, 0, 0, 0, 0, 2, 0})});
  tape.put(cl::Surface{2, 0, {EntityType::circle, "C1", 0, {1, 1, 0, 0, 0, 1, 3}}});
  const auto& circle = std::get<cl::Surface>(tape.records().back().body);
  EXPECT_THAT(circle.surface.canon, ElementsAre(3, 2, 0, 0, 0, 1, DoubleNear(6, 1e-14)));
}

TEST(Tracut, WarnsOnceWhenTheAxisIsNotInTheOutput) {
  Tape tape;
  tape.post(Word::TRACUT, {matrix({1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0})}).go(1, 2, 3).go(1, 2, 4);
  EXPECT_THAT(tape.codes(), ElementsAre("W0490"));
}

TEST(Copy, SameRepeatsTheRange) {
  Tape tape;
  tape.post(Word::INDEX, {1.0}).go(1, 0, 0).post(Word::COPY, {1.0, Word::SAME, 2.0}).go(9, 0, 0);
  EXPECT_THAT(tape.shown(),
              ElementsAre("INDEX", "1 0 0", "INDEX", "1 0 0", "INDEX", "1 0 0", "COPY", "9 0 0"));
}

TEST(Copy, TranslAddsUp) {
  Tape tape;
  tape.post(Word::INDEX, {1.0}).go(1, 0, 0);
  tape.post(Word::COPY, {1.0, Word::TRANSL, 10.0, 1.0, 0.5, 2.0});
  EXPECT_THAT(tape.shown(),
              ElementsAre("INDEX", "1 0 0", "INDEX", "11 1 0.5", "INDEX", "21 2 1", "COPY"));
}

TEST(Copy, XyrotOfRightAnglesIsExact) {
  Tape tape;
  tape.post(Word::INDEX, {1.0}).go(3, 4, 5).post(Word::COPY, {1.0, Word::XYROT, 90.0, 3.0});
  EXPECT_THAT(tape.shown(), ElementsAre("INDEX", "3 4 5", "INDEX", "-4 3 5", "INDEX", "-3 -4 5",
                                        "INDEX", "4 -3 5", "COPY"));
}

TEST(Copy, ModifyMultipliesMatrices) {
  Tape tape;  // doubling: 1, 2, 4
  tape.post(Word::INDEX, {1.0}).go(1, 0, 0);
  tape.post(Word::COPY, {1.0, Word::MODIFY, matrix({2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0}), 2.0});
  EXPECT_THAT(tape.shown(),
              ElementsAre("INDEX", "1 0 0", "INDEX", "2 0 0", "INDEX", "4 0 0", "COPY"));
}

TEST(Copy, NomoreEndsTheRangeBeforeTheCopy) {
  Tape tape;
  tape.post(Word::INDEX, {1.0}).go(1, 0, 0).post(Word::INDEX, {1.0, Word::NOMORE}).go(5, 5, 5);
  tape.post(Word::COPY, {1.0, Word::SAME, 1.0});
  EXPECT_THAT(tape.shown(),
              ElementsAre("INDEX", "1 0 0", "INDEX-", "5 5 5", "INDEX", "1 0 0", "INDEX-", "COPY"));
}

TEST(Copy, InnerCopiesAreRepeatedByTheOuterOne) {
  Tape tape;
  tape.post(Word::INDEX, {1.0}).post(Word::INDEX, {2.0}).go(1, 0, 0);
  tape.post(Word::COPY, {2.0, Word::TRANSL, 1.0, 0.0, 0.0, 1.0});
  tape.post(Word::COPY, {1.0, Word::TRANSL, 0.0, 1.0, 0.0, 1.0}).finish();
  EXPECT_THAT(tape.shown(),
              ElementsAre("INDEX", "INDEX", "1 0 0", "INDEX", "2 0 0", "COPY",  //
                          "INDEX", "INDEX", "1 1 0", "INDEX", "2 1 0", "COPY", "COPY"));
  EXPECT_TRUE(tape.codes().empty());
}

TEST(Copy, SeveralCopiesShareOneRange) {
  Tape tape;
  tape.post(Word::INDEX, {1.0})
      .go(1, 0, 0)
      .post(Word::COPY, {1.0, Word::TRANSL, 1.0, 0.0, 0.0, 1.0});
  tape.post(Word::COPY, {1.0, Word::TRANSL, 0.0, 1.0, 0.0, 1.0});
  EXPECT_THAT(tape.shown(), ElementsAre("INDEX", "1 0 0", "INDEX", "2 0 0", "COPY",  //
                                        "INDEX", "1 1 0", "INDEX", "2 1 0", "COPY", "COPY"));
}

TEST(Copy, TheInnerCopyActsOnWhatTheOuterOneMoved) {
  Tape tape;  // as the old system: turned about the origin where it then is
  tape.post(Word::INDEX, {1.0}).post(Word::INDEX, {2.0}).go(5, 0, 0);
  tape.post(Word::COPY, {2.0, Word::XYROT, 90.0, 1.0});
  tape.post(Word::COPY, {1.0, Word::TRANSL, 10.0, 0.0, 0.0, 1.0}).finish();
  EXPECT_THAT(tape.shown(),
              ElementsAre("INDEX", "INDEX", "5 0 0", "INDEX", "0 5 0", "COPY",  //
                          "INDEX", "INDEX", "15 0 0", "INDEX", "0 15 0", "COPY", "COPY"));
}

TEST(Copy, ARangeEndsWithTheFirstMotionBehindItsCopy) {
  Tape tape;
  tape.post(Word::INDEX, {1.0}).go(1, 0, 0).post(Word::COPY, {1.0, Word::SAME, 1.0}).go(7, 0, 0);
  tape.post(Word::INDEX, {1.0, Word::NOMORE}).finish();
  EXPECT_THAT(tape.shown(),
              ElementsAre("INDEX", "1 0 0", "INDEX", "1 0 0", "COPY", "7 0 0", "INDEX-"));
  EXPECT_TRUE(tape.codes().empty());
}

TEST(Copy, SeesWhatTracutLeft) {
  Tape tape;  // e23 of the old system: copies turn the moved points
  tape.post(Word::TRACUT, {shift(10.25, 0, 0)}).post(Word::INDEX, {1.0}).go(1.25, 2.35, 0.45);
  tape.post(Word::COPY, {1.0, Word::XYROT, 90.0, 1.0});
  EXPECT_THAT(tape.shown(),
              ElementsAre("TRACUT", "INDEX", "11.5 2.35 0.45", "INDEX", "-2.35 11.5 0.45", "COPY"));
}

TEST(Copy, ZeroCopiesAreNone) {
  Tape tape;
  tape.post(Word::INDEX, {1.0}).go(1, 0, 0).post(Word::COPY, {1.0, Word::SAME, 0.0});
  EXPECT_THAT(tape.shown(), ElementsAre("INDEX", "1 0 0", "COPY"));
}

struct Wrong {
  std::vector<cl::Value> values;
  std::string code;
};
class CopyErrors : public testing::TestWithParam<Wrong> {};
TEST_P(CopyErrors, AreTold) {
  Tape tape;
  tape.post(Word::INDEX, {1.0}).go(1, 0, 0).post(Word::COPY, GetParam().values);
  EXPECT_THAT(tape.codes(), ElementsAre(GetParam().code));
}
INSTANTIATE_TEST_SUITE_P(Forms,
                         CopyErrors,
                         testing::Values(Wrong{{1.0, Word::SAME, -1.0}, "E0484"},
                                         Wrong{{1.0, Word::SAME, 1.5}, "E0484"},
                                         Wrong{{1.0, Word::SAME}, "E0483"},
                                         Wrong{{1.0, 2.0, 3.0}, "E0482"},
                                         Wrong{{1.0, Word::YZROT, 3.0, 1.0}, "E0482"},
                                         Wrong{{1.0, Word::MIRROR, 1.0}, "E0485"},
                                         Wrong{{1.0, Word::TRANSL, 1.0, 2.0, 1.0}, "E0483"},
                                         Wrong{{2.0, Word::SAME, 1.0}, "E0486"}));

TEST(Copy, RangesMustNest) {
  Tape tape;
  tape.post(Word::INDEX, {1.0}).post(Word::INDEX, {2.0}).post(Word::COPY, {1.0, Word::SAME, 1.0});
  EXPECT_THAT(tape.codes(), ElementsAre("E0487"));
}

TEST(Copy, NestsThreeDeepAtMost) {
  Tape tape;
  for (const double i : {1.0, 2.0, 3.0, 4.0}) {
    tape.post(Word::INDEX, {i});
  }
  EXPECT_THAT(tape.codes(), ElementsAre("E0481"));
}

TEST(Copy, NumbersAreUsedOnce) {
  Tape tape;
  tape.post(Word::INDEX, {1.0}).post(Word::INDEX, {1.0});
  EXPECT_THAT(tape.codes(), ElementsAre("E0480"));
}

TEST(Copy, UnusedIndexIsAWarning) {
  Tape tape;
  tape.post(Word::INDEX, {1.0}).go(1, 0, 0).finish();
  EXPECT_THAT(tape.codes(), ElementsAre("W0489"));
}

TEST(Copy, StopsAtTheLimitOfRecords) {
  Limits limits;
  limits.records = 100;
  Tape tape(limits);
  tape.post(Word::INDEX, {1.0}).go(1, 0, 0).post(Word::COPY, {1.0, Word::SAME, 1e12});
  EXPECT_LE(tape.records().size(), 100U);
  EXPECT_THAT(tape.codes(), ElementsAre("E0803"));
}

TEST(Tracut, TurnsTheSideOfAPose) {
  cl::Motion pose;
  pose.withAxis = true;
  pose.withSide = true;
  pose.coordinates = {1, 2, 3, 0, 0, 1, 1, 0, 0};
  Tape tape;
  tape.post(Word::TRACUT,
            {cl::SurfaceValue{EntityType::matrix, "", 0, {0, -1, 0, 10, 1, 0, 0, 0, 0, 0, 1, 0}}});
  tape.put(pose).finish();
  const auto& moved = std::get<cl::Motion>(tape.records().back().body);
  // A quarter turn about z, then ten along x: x becomes y.
  EXPECT_THAT(moved.coordinates, ElementsAre(8, 1, 3, 0, 0, 1, 0, 1, 0));
}

TEST(Transform, AMirrorUnderCutterCompensationIsToldOnceAStatement) {
  const cl::SurfaceValue mirror = matrix({-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  Tape before;  // CUTCOM is on when the mirror comes
  before.post(Word::CUTCOM, {Word::LEFT}).post(Word::TRACUT, {mirror}).go(1, 2, 3).go(2, 2, 3);
  EXPECT_THAT(before.codes(), ElementsAre("W0581"));
  Tape within;
  within.post(Word::TRACUT, {mirror}).post(Word::CUTCOM, {Word::RIGHT, Word::XYPLAN}).go(1, 2, 3);
  EXPECT_THAT(within.codes(), ElementsAre("W0581"));
  Tape copied;
  copied.post(Word::INDEX, {1.0}).post(Word::CUTCOM, {Word::LEFT}).go(1, 2, 3);
  copied.post(Word::CUTCOM, {Word::OFF}).post(Word::COPY, {1.0, Word::MODIFY, mirror, 1.0});
  EXPECT_THAT(copied.codes(), ElementsAre("W0581"));
  Tape clean;  // off before the mirror, and a matrix that mirrors nothing
  clean.post(Word::CUTCOM, {Word::LEFT}).post(Word::CUTCOM, {Word::OFF});
  clean.post(Word::TRACUT, {mirror}).go(1, 2, 3).post(Word::TRACUT, {shift(1, 0, 0)});
  clean.post(Word::CUTCOM, {Word::LEFT}).go(1, 2, 3);
  EXPECT_THAT(clean.codes(), ElementsAre());
}

}  // namespace
}  // namespace arelem::path
