#include "backend/html/detail.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ir/space/vector.h"

namespace arelem::backend {
namespace {

constexpr auto start = static_cast<std::uint8_t>(SceneMove::start);
constexpr auto rapid = static_cast<std::uint8_t>(SceneMove::rapid);
constexpr auto feed = static_cast<std::uint8_t>(SceneMove::feed);

std::vector<std::uint8_t> feeds(std::size_t count) {
  std::vector<std::uint8_t> kinds(count, feed);
  kinds[0] = start;
  return kinds;
}

Vec3 at(const std::vector<double>& places, std::size_t i) {
  return {places[3 * i], places[3 * i + 1], places[3 * i + 2]};
}

double offChord(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double length2 = (b - a).squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * (b - a)).norm();
}

TEST(Detail, NothingAndOnePlace) {
  EXPECT_TRUE(detailOf({}, {}).levels.empty());
  const Detail one = detailOf({1, 2, 3}, {start});
  EXPECT_THAT(one.levels, testing::ElementsAre(Detail::highest));
  EXPECT_EQ(one.size, 0.0);
  ASSERT_EQ(one.boxes.size(), 6U);
  EXPECT_FLOAT_EQ(one.boxes[1], 2.0F);
}

TEST(Detail, PlacesOfAStraightLineAreInLevelZeroOnly) {
  const Detail line = detailOf({0, 0, 0, 1, 0, 0, 2, 0, 0, 5, 0, 0}, feeds(4));
  EXPECT_THAT(line.levels, testing::ElementsAre(Detail::highest, 0, 0, Detail::highest));
}

TEST(Detail, LevelsDoubleTheirTolerance) {
  // 0.01 off a chord of 2: the size is 2.00002, the tolerance of level 1 2/16384 = 0.000122; 64
  // times that is below 0.01 and 128 times above: level 7.
  const Detail bend = detailOf({0, 0, 0, 1, 0.01, 0, 2, 0, 0}, feeds(3));
  EXPECT_THAT(bend.levels, testing::ElementsAre(Detail::highest, 7, Detail::highest));
  EXPECT_NEAR(bend.tolerance(1), 2.0 / 16384, 1e-8);
  EXPECT_NEAR(bend.tolerance(7), 64 * 2.0 / 16384, 1e-6);
  EXPECT_EQ(bend.tolerance(0), 0.0);
}

TEST(Detail, ARunOfAKindStaysWhileItIsLongerThanTheTolerance) {
  // Rapid for 1 of 8, on a straight line: its ends stay until the tolerance is 1 = 8/16384 * 2048,
  // which level 12 has; a location within the run does not.
  std::vector<std::uint8_t> kinds = {start, feed, rapid, rapid, feed};
  const Detail runs = detailOf({0, 0, 0, 3, 0, 0, 3.5, 0, 0, 4, 0, 0, 8, 0, 0}, kinds);
  EXPECT_THAT(runs.levels, testing::ElementsAre(Detail::highest, 11, 0, 11, Detail::highest));
}

TEST(Detail, ABreakStays) {
  const Detail broken = detailOf({0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0}, {start, feed, start, feed});
  EXPECT_THAT(broken.levels, testing::Each(Detail::highest));
}

TEST(Detail, WhatALevelDrawsIsWithinItsToleranceOfThePath) {
  std::mt19937 random(8);
  std::normal_distribution<double> step(0.0, 1.0);
  std::vector<double> places(3 * 5000);
  for (std::size_t i = 3; i < places.size(); ++i) {
    places[i] = places[i - 3] + step(random) + std::sin(static_cast<double>(i) / 500.0);
  }
  const Detail detail = detailOf(places, feeds(5000));
  std::size_t before = 5000;
  for (int level = 1; level <= Detail::highest; ++level) {
    std::size_t from = 0, kept = 1;
    for (std::size_t i = 1; i < 5000; ++i) {
      if (detail.levels[i] < level) {
        continue;
      }
      for (std::size_t k = from + 1; k < i; ++k) {
        ASSERT_LE(offChord(at(places, k), at(places, from), at(places, i)), detail.tolerance(level))
            << "level " << level << ", location " << k;
      }
      from = i;
      ++kept;
    }
    EXPECT_EQ(from, 4999U);
    EXPECT_LE(kept, before);
    before = kept;
  }
  EXPECT_LT(before, 60U);  // the ends of five blocks, and what is further off than a quarter
}

TEST(Detail, BlocksShareTheirEndsAndHaveBoxes) {
  std::vector<double> places(3 * 2049);
  for (std::size_t i = 0; i < 2049; ++i) {
    places[3 * i] = static_cast<double>(i);
    places[3 * i + 2] = -1.0;
  }
  const Detail detail = detailOf(places, feeds(2049));
  ASSERT_EQ(detail.boxes.size(), 12U);
  EXPECT_NEAR(detail.boxes[3], 1024.0F, 1e-3);  // high x of the first, low x of the second
  EXPECT_NEAR(detail.boxes[6], 1024.0F, 1e-3);
  EXPECT_LT(detail.boxes[8], -1.0F);
  EXPECT_GT(detail.boxes[11], -1.0F);
  EXPECT_EQ(detail.levels[1024], Detail::highest);
  EXPECT_EQ(std::count(detail.levels.begin(), detail.levels.end(), 0), 2049 - 3);
}

}  // namespace
}  // namespace arelem::backend
