// The line that tells how far a long search is: it must never wrap.
#include "app/progress_bar.h"

#include <gtest/gtest.h>

namespace arelem::app {
namespace {

TEST(ProgressLine, FillsUpWithTheWork) {
  EXPECT_EQ(progressLine("MINCST", 0, 8, 41, 90.0), "MINCST [                ] 0/8, 90 s left");
  EXPECT_EQ(progressLine("MINCST", 4, 8, 41, 4.2), "MINCST [########         ] 4/8, 5 s left");
  EXPECT_EQ(progressLine("MINCST", 7, 8, 200, 1.0),
            "MINCST [###################################     ] 7/8, 1 s left");
  EXPECT_EQ(progressLine("MINCST", 1, 900, 80, 6000.0),
            "MINCST [                                        ] 1/900, 100 min left");
}

TEST(ProgressLine, LeavesOutWhatHasNoRoom) {
  EXPECT_EQ(progressLine("MINCST", 4, 8, 28, 90.0), "MINCST [#######       ] 4/8");
  EXPECT_EQ(progressLine("MINCST", 4, 8, 20, 90.0), "MINCST 4/8");
  EXPECT_EQ(progressLine("MINCST", 4, 8, 5, 90.0), "MINC");
  for (int columns = 0; columns < 300; ++columns) {
    EXPECT_LT(progressLine("MINCST", 123456, 1000000, columns, 1e9).size(),
              static_cast<std::size_t>(std::max(columns, 2)));
  }
}

}  // namespace
}  // namespace arelem::app
