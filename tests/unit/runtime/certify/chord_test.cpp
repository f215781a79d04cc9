#include "runtime/certify/chord.h"

#include <cmath>

#include <gtest/gtest.h>

#include "runtime/certify/guide.h"

namespace arelem::certify {
namespace {

TEST(Chord, PoleIsSquareToAxesThatDifferByRoundingAlone) {
  const Vec3 axis = Vec3(-0.07137173206185293, -0.7404250783261569, 0.6683388206951587);
  for (int i = 0; i < 200; ++i) {
    Vec3 other = axis;
    for (int k = 0; k < 3; ++k) {
      for (int n = 0; n < (i * (k + 3)) % 4; ++n) {
        other[k] = std::nextafter(other[k], (i >> k) % 2 == 0 ? 2.0 : -2.0);
      }
    }
    const Chord chord(Vec3::Zero(), Vec3::UnitX(), axis, other);
    EXPECT_NEAR(chord.pole().dot(axis), 0.0, 1e-14) << i;
    EXPECT_NEAR(chord.pole().norm(), 1.0, 1e-14) << i;
  }
}

TEST(Chord, PoleOfATurn) {
  const Chord chord(Vec3::Zero(), Vec3::Zero(), Vec3::UnitZ(),
                    Vec3(std::sin(0.25), 0.0, std::cos(0.25)));
  EXPECT_NEAR((chord.pole() - Vec3::UnitY()).norm(), 0.0, 1e-15);
  EXPECT_NEAR(chord.turn(), 0.25, 1e-15);
}

}  // namespace
}  // namespace arelem::certify
