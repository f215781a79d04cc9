// Film maps against closed forms.
#include "runtime/film/map.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "runtime/spray/region_job.h"

namespace arelem::film {
namespace {

using namespace spray;

RegionJob square(double side) {
  RegionJob job;
  job.region = *region::regionOf({{region::Boundary::Role::outline,
                                   {{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}}}});
  job.gun.footprint = {30.0, 40.0};
  job.gun.speed = 500.0;
  job.gun.efficiency = 0.6;
  job.film = 0.05;
  return job;
}

Sprayed sprayed(const RegionJob& job) {
  Result<RegionResult> result = sprayRegion(job, nullptr, {});
  if (!result) {
    ADD_FAILURE() << result.failure().message;
    return {};
  }
  return std::move(result->sprayed);
}

TEST(FilmMap, BetweenPassesItIsTheIntervalProfile) {
  RegionJob job = square(2000.0);
  job.overlap = 0.175;
  const Sprayed s = sprayed(job);
  const double interval = 80.0 * (1.0 - 0.175);
  const double y = s.strokes[20].from.y();  // a pass in the middle
  for (const double t : {0.0, 0.1, 0.25, 0.5, 0.9}) {
    EXPECT_NEAR(filmAt(s, {1000.0, y - t * interval}) / job.film,
                intervalFilm(Profile::ellipse(), 0.175, t), 1e-9);
  }
}

TEST(FilmMap, NoPaintIsLost) {
  RegionJob job = square(600.0);
  job.degrees = 25.0;
  const Sprayed s = sprayed(job);
  const Map map = mapOf(s, 1.0);
  const double paint = s.chosen.cost.used * job.gun.efficiency;
  EXPECT_NEAR(map.statistics.deposited + map.statistics.outside, paint, 1e-3 * paint);
  EXPECT_NEAR(map.statistics.area, 600.0 * 600.0, 1e-9);
}

TEST(FilmMap, MeanOverALargePlateIsTheWantedFilm) {
  RegionJob job = square(3000.0);
  const Sprayed s = sprayed(job);
  const Map map = mapOf(s, 5.0);
  // Away from the edges, over whole intervals.
  EXPECT_NEAR(map.statistics.mean, job.film, 0.01 * job.film);
  EXPECT_GT(map.statistics.within10, 0.5);
}

TEST(FilmMap, OnePassIsTheDepositionProfile) {
  RegionJob job = square(40.0);
  job.region = *region::regionOf(
      {{region::Boundary::Role::outline, {{0, 0, 0}, {1000, 0, 0}, {1000, 30, 0}, {0, 30, 0}}}});
  const Sprayed s = sprayed(job);
  ASSERT_EQ(s.strokes.size(), 1U);
  const double rate = s.chosen.operation.flow * 0.6 / (s.strokes[0].speed * 40.0);
  for (const double w : {0.0, 10.0, 20.0, 39.0}) {
    EXPECT_NEAR(filmAt(s, {500.0, 15.0 + w}), rate * Profile::ellipse().density(w / 40.0), 1e-12);
  }
  EXPECT_EQ(filmAt(s, {500.0, 15.0 + 41.0}), 0.0);
  // Half the footprint has passed over the place where the gun is switched on.
  EXPECT_NEAR(filmAt(s, {s.strokes[0].from.x(), 15.0}),
              rate * Profile::ellipse().density(0.0) / 2.0, 1e-12);
}

/// A footprint of 30 m over a plate of 0.3 m: one pass, whose film is that of its middle, 2 q / (pi
/// v b), everywhere.
TEST(FilmMap, OfAFootprintThatIsFarLargerThanTheWork) {
  RegionJob job = square(300.0);
  job.gun.footprint = {30'000.0, 30'000.0};
  job.gun.flow = 0.0;
  job.overlap = 0.0;
  const Sprayed s = sprayed(job);
  ASSERT_EQ(s.strokes.size(), 1U);
  const Map map = mapOf(s, 0.0);
  // The passes would lie 2 b apart, so that q / v = 2 b h.
  const double expected = 4.0 / std::numbers::pi * job.film;
  EXPECT_NEAR(map.statistics.mean, expected, 1e-3 * expected);
  EXPECT_NEAR(map.statistics.smallest, expected, 1e-3 * expected);
  EXPECT_NEAR(map.statistics.area, 300.0 * 300.0, 0.1 * 300.0 * 300.0);
  const double paint = s.chosen.cost.used * job.gun.efficiency;
  EXPECT_NEAR(map.statistics.deposited + map.statistics.outside, paint, 1e-6 * paint);
}

/// Offset corners of a sharp outline are in the picture: the gun is switched there.
TEST(FilmMap, ShowsWhereTheGunIsSwitched) {
  RegionJob job = square(300.0);
  job.region =
      *region::regionOf({{region::Boundary::Role::outline, {{0, 0, 0}, {300, 0, 0}, {0, 300, 0}}}});
  const Sprayed s = sprayed(job);
  const Map map = mapOf(s, 0.0);
  // The mitre at (300, 0): the sides move out by 40 and by hypot(30, 40) / sqrt(2).
  const double corner = 300.0 + 50.0 + 40.0;
  EXPECT_GT(map.low.x() + map.cell * static_cast<double>(map.columns), corner);
}

}  // namespace
}  // namespace arelem::film
