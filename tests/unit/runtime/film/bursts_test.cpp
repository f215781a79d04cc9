// The film of strokes in space.
#include "runtime/film/bursts.h"

#include <cmath>

#include <gtest/gtest.h>

namespace arelem::film {
namespace {

using namespace spray;

/// A pass to the right and one back, 40 apart, by a gun that leaves all its paint to one hand.
Sprayed thereAndBack() {
  Sprayed s;
  s.planar = false;
  s.gun.kind = Gun::Kind::table;
  s.gun.table = {{-1.0, 0.0}, {0.0, 0.0}, {0.5, 2.0}, {1.0, 0.0}};
  s.gun.footprint = {10.0, 10.0};
  s.gun.standOff = 100.0;
  s.chosen.operation.flow = 1000.0;
  for (const bool back : {false, true}) {
    Stroke& stroke = s.strokes.emplace_back();
    stroke.from = {back ? 100.0 : 0.0, back ? 40.0 : 0.0, 0.0};
    stroke.to = {back ? 0.0 : 100.0, back ? 40.0 : 0.0, 0.0};
    stroke.speed = 50.0;
    stroke.newPass = true;
  }
  return s;
}

TEST(Bursts, TheGunIsNotTurnedOverFromPassToPass) {
  const Sprayed s = thereAndBack();
  const Bursts spray(s);
  const auto film = [&spray](double y) { return spray.filmAt({50.0, y, 0.0}, Vec3::UnitZ()); };
  EXPECT_GT(film(5.0), 0.0);
  EXPECT_EQ(film(-5.0), 0.0);
  EXPECT_NEAR(film(45.0), film(5.0), 1e-12 * film(5.0));
  EXPECT_EQ(film(35.0), 0.0);
}

/// Twelve straight passes about a ball of 60, whose cones lean against each other.
Sprayed aboutABall() {
  Sprayed s = thereAndBack();
  s.strokes.clear();
  s.gun.kind = Gun::Kind::cone;
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.5 * i;
    Stroke& stroke = s.strokes.emplace_back();
    stroke.normalFrom = Vec3(std::cos(angle), std::sin(angle), 0.1 * i).normalized();
    stroke.normalTo = Vec3(std::cos(angle), std::sin(angle), 0.1 * i + 1.0).normalized();
    stroke.from = 60.0 * stroke.normalFrom;
    stroke.to = 60.0 * stroke.normalTo;
    stroke.speed = 50.0;
    stroke.newPass = true;
  }
  return s;
}

TEST(Bursts, WhatIsFarDoesNotCountAndWhatIsNearDoes) {
  // All passes together leave what each leaves alone, whatever is left out as too far.
  const Sprayed all = aboutABall();
  std::vector<Bursts::Place> places;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 out = Vec3(std::cos(0.7 * i), std::sin(0.7 * i), -1.0 + 0.001 * i).normalized();
    places.push_back({(50.0 + 0.01 * i) * out, out});
  }
  std::vector<double> sums(places.size(), 0.0);
  for (const Stroke& stroke : all.strokes) {
    Sprayed one = all;
    one.strokes = {stroke};
    const Bursts spray(one);
    for (std::size_t i = 0; i < places.size(); ++i) {
      sums[i] += spray.filmAt(places[i].at, places[i].normal);
    }
  }
  const Bursts spray(all);
  const std::vector<double> films = spray.filmsAt(places);
  std::size_t painted = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(films[i], spray.filmAt(places[i].at, places[i].normal));
    EXPECT_NEAR(films[i], sums[i], 1e-12 + 1e-9 * sums[i]);
    painted += films[i] > 0.0 ? 1 : 0;
  }
  EXPECT_GT(painted, 200U);
  EXPECT_LT(painted, places.size());
}

}  // namespace
}  // namespace arelem::film
