#include "runtime/motion/pocket.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "runtime/motion/convex_inset.h"

namespace arelem::motion {
namespace {

State withCutter(double diameter) {
  State state;
  state.cutter = *tool::makeProfile(std::vector<double>{diameter});
  return state;
}

double distanceToPath(const std::vector<std::vector<Vec3>>& passes, const Vec3& p) {
  double nearest = 1e9;
  for (const auto& pass : passes) {
    for (std::size_t i = 0; i < pass.size(); ++i) {
      const Vec3 side = pass[(i + 1) % pass.size()] - pass[i];
      const double share = std::clamp((p - pass[i]).dot(side) / side.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (p - pass[i] - share * side).norm());
    }
  }
  return nearest;
}

// Pockets with random vertices on an ellipse: every place inside the outer pass is within Re of the
// path, and no step is longer than c radii.
TEST(Pocket, NothingInsideIsFartherFromThePathThanRe) {
  std::mt19937 random(11);
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  int made = 0;
  for (int trial = 0; trial < 60; ++trial) {
    runtime::Pocket pocket;
    const double reach = between(0.3, 0.5), step = between(0.5, 1.9);
    pocket.parameters = {reach, step, between(0.3, 1.9), 1, 2, 3, 0, 0};
    const int count = 3 + trial % 5;
    const double turn = between(0, 1);
    const Vec3 radii(between(2, 6), between(2, 6), 0);
    for (int i = 0; i < count; ++i) {
      const double angle = turn + (i + between(-0.3, 0.3)) * 2 * M_PI / count;
      pocket.points.emplace_back(radii.x() * std::cos(angle), radii.y() * std::sin(angle), 0.7);
    }
    const auto plan = planPocket(withCutter(1.0), pocket);
    if (!plan) {
      continue;  // three corners nearly in line
    }
    ++made;
    EXPECT_LT(plan->missed, 1e-5);
    const std::vector<Vec3>& outer = plan->passes.back();
    ASSERT_EQ(outer.size(), pocket.points.size());
    for (int k = 0; k < 2000; ++k) {
      // A random place inside: a mean of the corners with random weights.
      Vec3 p = Vec3::Zero();
      double sum = 0.0;
      for (const Vec3& corner : outer) {
        const double weight = std::pow(between(0, 1), 4);
        p += weight * corner;
        sum += weight;
      }
      EXPECT_LE(distanceToPath(plan->passes, p / sum), reach * 1.0001) << trial;
    }
  }
  EXPECT_GT(made, 50);
}

TEST(Pocket, ThePassesRunAsThePointsDo) {
  runtime::Pocket pocket;
  pocket.parameters = {0.5, 1, 1, 1, 2, 3, 0, 0};
  pocket.points = {{0, 0, 0}, {0, 3, 0}, {4, 3, 0}, {4, 0, 0}};
  const auto plan = planPocket(withCutter(1.0), pocket);
  ASSERT_TRUE(plan);
  ASSERT_EQ(plan->passes.size(), 3u);
  EXPECT_LT((plan->passes[0][0] - Vec3(1, 1, 0)).norm(), 1e-12);
  EXPECT_LT((plan->passes[0][1] - Vec3(1, 2, 0)).norm(), 1e-12);
  EXPECT_LT((plan->passes[1][2] - Vec3(3.5, 2.5, 0)).norm(), 1e-12);
}

TEST(Pocket, LongStepsThatAreKeptMissTheCorners) {
  // o = 1, steps of 1 in a square: the place at Re from both sides of a corner, (0.5, 0.5), is
  // sqrt(0.5) from the next pass's corner (1, 1), 0.2071 more than Re.
  runtime::Pocket pocket;
  pocket.parameters = {0.5, 2, 2, 1, 2, 3, 1, 0};
  pocket.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  const auto plan = planPocket(withCutter(1.0), pocket);
  ASSERT_TRUE(plan);
  EXPECT_NEAR(plan->missed, std::sqrt(0.5) - 0.5, 1e-9);
}

}  // namespace
}  // namespace arelem::motion
