#include "runtime/spray/overlap.h"

#include <cmath>

#include <gtest/gtest.h>

namespace arelem::spray {
namespace {

using Points = std::vector<std::pair<double, double>>;

/// p(u) = 1 - |u|. Passes side by side: the film is 2 (1 - |u|).
TEST(Overlap, TrianglesSideBySide) {
  const Profile triangle = Profile::normalized(Points{{-1, 0}, {0, 1}, {1, 0}});
  const Uniformity u = uniformity(triangle, 0.0);
  EXPECT_NEAR(u.average, 0.5, 1e-12);
  EXPECT_NEAR(u.rms, std::sqrt(1.0 / 3.0), 1e-12);
  EXPECT_NEAR(u.largest, 1.0, 1e-12);
}

TEST(Overlap, TrianglesHalfOverEachOtherAreEven) {
  const Profile triangle = Profile::normalized(Points{{-1, 0}, {0, 1}, {1, 0}});
  EXPECT_NEAR(uniformity(triangle, 0.5).largest, 0.0, 1e-12);
  EXPECT_NEAR(optimalOverlap(triangle, Measure::average), 0.5, 1e-5);
}

/// Passes 1.5 b apart: a third of the work has twice the film of the rest, 1.5 and 0.75.
TEST(Overlap, AFanOverlapsByAQuarter) {
  for (const Profile& fan : {Profile::flat(), Profile::normalized(Points{{-1, 3}, {1, 3}})}) {
    const Uniformity u = uniformity(fan, 0.25);
    EXPECT_NEAR(u.average, 1.0 / 3.0, 1e-12);
    EXPECT_NEAR(u.rms, std::sqrt(0.125), 1e-12);
    EXPECT_NEAR(u.largest, 0.5, 1e-12);
  }
}

/// A piece on which the departure changes its sign: p falls from 1 to 0, side by side.
TEST(Overlap, AWedgeCrossesTheMean) {
  const Profile wedge = Profile::normalized(Points{{-1, 1}, {1, 0}});
  const Uniformity u = uniformity(wedge, 0.0);
  EXPECT_NEAR(u.average, 0.5, 1e-12);
  EXPECT_NEAR(u.rms, std::sqrt(1.0 / 3.0), 1e-12);
  EXPECT_NEAR(u.largest, 1.0, 1e-12);
}

}  // namespace
}  // namespace arelem::spray
