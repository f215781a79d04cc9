// The film of strokes in space.
#include "runtime/film/bursts.h"

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

}  // namespace
}  // namespace arelem::film
