#include "runtime/pieces.h"

#include <gtest/gtest.h>

#include "tests/unit/whole/interpret/section_one.h"

// Long programs through Section 2 in pieces: the same records as with all actions at once.
namespace arelem {
namespace {

/// Passes of four actions each: a place, a startup, a motion up to a check surface, and up.
std::string passes(int count, const std::string& check) {
  return "PARTNO PIECES\nINTOL/0\nOUTTOL/.01\nCUTTER/10\nPS=PLANE/0,0,1,0\nLA=LINE/0,0,100,0\n"
         "LB=LINE/50,0,50,100\nFROM/0,-20,10\nLOOPST\nI=0\nA) GOTO/0,-20,10\nGO/TO,LA,TO,PS\n"
         "TLRGT,GORGT/LA," +
         check + "\nB) GODLTA/0,0,10\nI=I+1\nIF(I-" + std::to_string(count) +
         ")A,C,C\nC) LOOPND\nFINI\n";
}

struct Compiled {
  SourceMap sources;
  CollectingSink sink;
  ir::Program program;

  explicit Compiled(std::string text) {
    const BufferId buffer = sources.add("test.apt", std::move(text));
    program = frontend::compile(sources, buffer, {}, sink);
  }
};

/// The numbers of a motion; none of other records.
std::vector<double> placesOf(const cl::Record& record) {
  const auto* motion = std::get_if<cl::Motion>(&record.body);
  return motion != nullptr ? motion->coordinates : std::vector<double>();
}

TEST(Pieces, GiveTheRecordsOfTheWhole) {
  const int count = static_cast<int>(runtime::pieceSize) / 2;  // 5 actions a pass
  Compiled run(passes(count, "PAST,LB"));
  cl::Recording whole;
  const auto all = runtime::evaluate(run.program, {}, run.sink);
  const auto outcome = runtime::execute(all.actions, {}, whole, run.sink);

  cl::Recording pieced;
  runtime::Execution execution({}, pieced, run.sink);
  std::size_t taken = 0;
  int pieces = 0;
  const auto rest = runtime::evaluateInPieces(
      run.program, {}, run.sink, [&](std::vector<runtime::Action>& actions) {
        EXPECT_TRUE(std::holds_alternative<runtime::Locate>(actions.back().body));
        ++pieces;
        taken += actions.size();
        execution.feed(actions);
        actions.clear();
      });
  execution.feed(rest.actions);
  const auto inPieces = execution.finish();

  EXPECT_EQ(run.sink.errors(), 0U);
  EXPECT_EQ(pieces, 2);
  EXPECT_EQ(taken + rest.actions.size(), all.actions.size());
  EXPECT_LT(rest.actions.size(), runtime::pieceSize);
  EXPECT_EQ(inPieces.cutVectors, outcome.cutVectors);
  EXPECT_EQ(inPieces.length, outcome.length);
  ASSERT_EQ(pieced.records.size(), whole.records.size());
  for (std::size_t i = 0; i < whole.records.size(); ++i) {
    ASSERT_EQ(pieced.records[i].body.index(), whole.records[i].body.index()) << i;
    ASSERT_EQ(placesOf(pieced.records[i]), placesOf(whole.records[i])) << i;
  }
}

TEST(Pieces, AreNotMadeWhereMotionsGoOnAtLabels) {
  Compiled run(passes(static_cast<int>(runtime::pieceSize) / 4, "PAST,LB,B,PAST,LA,B"));
  int pieces = 0;
  const auto all = runtime::evaluateInPieces(run.program, {}, run.sink,
                                             [&](std::vector<runtime::Action>&) { ++pieces; });
  EXPECT_EQ(pieces, 0);
  EXPECT_GT(all.actions.size(), runtime::pieceSize);
}

TEST(Pieces, EndBehindTheMotionsThatUseACutter) {
  // Only places behind the last CUTTER: none of them may end a piece.
  Compiled run("PARTNO CUTTER\nFROM/0,0,0\nCUTTER/10\nLOOPST\nI=0\nA) GOTO/I,0,0\nI=I+1\nIF(I-" +
               std::to_string(runtime::pieceSize + 10) + ")A,C,C\nC) LOOPND\nFINI\n");
  int pieces = 0;
  static_cast<void>(runtime::evaluateInPieces(run.program, {}, run.sink,
                                              [&](std::vector<runtime::Action>&) { ++pieces; }));
  EXPECT_EQ(pieces, 0);
}

TEST(Pieces, ThatAreKeptAreNotOfferedAgain) {
  Compiled run("PARTNO KEPT\nFROM/0,0,0\nLOOPST\nI=0\nA) GOTO/I,0,0\nI=I+1\nIF(I-" +
               std::to_string(runtime::pieceSize + 10) + ")A,C,C\nC) LOOPND\nFINI\n");
  int pieces = 0;
  const auto all = runtime::evaluateInPieces(run.program, {}, run.sink,
                                             [&](std::vector<runtime::Action>&) { ++pieces; });
  EXPECT_EQ(pieces, 1);
  EXPECT_GT(all.actions.size(), runtime::pieceSize + 10);
}

}  // namespace
}  // namespace arelem
