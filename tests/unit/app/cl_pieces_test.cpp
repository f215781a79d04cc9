// Where CL text may be cut.
#include "app/cl_pieces.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

namespace arelem::app {
namespace {

TEST(ClPieces, CutsBeforeTheLastMoveThatNothingRunsInto) {
  EXPECT_EQ(lastCut("GOTO/1,2,3\nGOTO/4,5,6\nRAPID\n"), 11U);
  EXPECT_EQ(lastCut("RAPID\n  goto/1,2,3\n"), 6U);
  EXPECT_EQ(lastCut("RAPID\r\nGODLTA/1\r\n"), 7U);
  EXPECT_EQ(lastCut("GOTO/1,2,3 $$ here\nGOTO/4,5,6\n"), 19U);
}

TEST(ClPieces, CutsNoStatementAndNoComment) {
  EXPECT_EQ(lastCut("TPRINT/a$\nGOTO/1,2,3\n"), 0U);
  EXPECT_EQ(lastCut("RAPID $ more\nGOTO/1,2,3\n"), 0U);
  EXPECT_EQ(lastCut("RAPID $ $$ more\nGOTO/1,2,3\n"), 0U);
  EXPECT_EQ(lastCut("$$-> CSYS / 1.0, $\nGOTO/1,2,3\n"), 0U);
  EXPECT_EQ(lastCut("RAPID\nSTOP\n"), 0U);
  EXPECT_EQ(lastCut(""), 0U);
  EXPECT_EQ(lastCut("\n"), 0U);
}

TEST(ClPieces, TellWhereTheyBegin) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("arelem_pieces_" + std::to_string(::getpid()) + ".cls");
  const std::string text = "PARTNO A\r\nGOTO/1,2,3\nRAPID\rSTOP\nGOTO/4,5,6\nFINI\n";
  std::ofstream(path, std::ios::binary) << text;
  ClPieces pieces(path.string(), 30);
  std::string joined;
  std::vector<std::uint32_t> lines;
  while (auto piece = pieces.next()) {
    EXPECT_EQ(piece->start.bytes, joined.size());
    joined += piece->text;
    lines.push_back(piece->start.lines);
    EXPECT_EQ(piece->last, joined.size() == text.size());
  }
  std::filesystem::remove(path);
  EXPECT_EQ(joined, text);
  // The second piece begins with the second line; the last one behind a lone carriage return.
  EXPECT_EQ(lines, (std::vector<std::uint32_t>{0, 1, 4}));
}

}  // namespace
}  // namespace arelem::app
