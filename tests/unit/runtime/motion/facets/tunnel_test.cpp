#include "runtime/motion/facets/tunnel.h"

#include <random>

#include <gtest/gtest.h>

// The farthest place that is seen in a tunnel, against figures by hand and all rays one by one.
namespace arelem::motion {
namespace {

TEST(Tunnel, ARayOverAHillTouchesItAndEndsAtTheTop) {
  // Bottom with its ridge at (2, 1), top one above it: from (0, 0.5) the lowest ray over the ridge
  // rises by 1/4, and meets the top, which falls from (2, 2) by 1/2, where 0.5 + s/4 = 3 - s/2.
  Tunnel tunnel;
  for (const SectionPoint p : {SectionPoint{0, 0}, {2, 1}, {8, -2}}) {
    tunnel.addBottom(p);
    tunnel.addTop({p.s, p.z + 1.0});
  }
  const Tunnel::Reach reach = tunnel.farthest({0, 0.5});
  EXPECT_EQ(reach.edge, 1);
  EXPECT_NEAR(reach.end.s, 10.0 / 3.0, 1e-12);
  EXPECT_NEAR(reach.end.z, 4.0 / 3.0, 1e-12);
  EXPECT_EQ(reach.from, 2.0);
}

TEST(Tunnel, ARayThroughAValleyTouchesTheTopAndEndsAtTheBottom) {
  // Top with its lowest place at (2, 0): the highest ray from (0, 0.5) falls by 1/4 and meets the
  // bottom, which rises from (2, -1) by 1, where 0.5 - s/4 = s - 3.
  Tunnel tunnel;
  for (const SectionPoint p : {SectionPoint{0, 1}, {2, -1}, {8, 5}}) {
    tunnel.addBottom(p);
    tunnel.addTop({p.s, p.z + 1.0});
  }
  const Tunnel::Reach reach = tunnel.farthest({0, 1.5});
  EXPECT_EQ(reach.edge, -1);
  EXPECT_NEAR(reach.end.s, (1.5 + 3.0) / 1.75, 1e-12);
  EXPECT_EQ(reach.from, 2.0);
}

TEST(Tunnel, AStraightTunnelIsSeenToItsEnd) {
  Tunnel tunnel;
  tunnel.addBottom({0, 0});
  tunnel.addBottom({5, 1});
  tunnel.addTop({0, 1});
  tunnel.addTop({5, 2});
  const Tunnel::Reach reach = tunnel.farthest({1, 0.7});
  EXPECT_EQ(reach.edge, 0);
  EXPECT_EQ(reach.end.s, 5.0);
  EXPECT_GE(reach.end.z, 1.0);
  EXPECT_LE(reach.end.z, 2.0);
}

/// How far a ray stays inside, by small steps.
double goneBy(const Tunnel& tunnel, const SectionPoint& eye, double slope) {
  constexpr double step = 1e-3;
  double s = eye.s;
  while (s + step <= tunnel.end()) {
    const double z = eye.z + slope * (s + step - eye.s);
    if (z < tunnel.bottomAt(s + step) - 1e-9 || z > tunnel.topAt(s + step) + 1e-9) {
      break;
    }
    s += step;
  }
  return s;
}

TEST(Tunnel, NoRayGoesFarther) {
  std::mt19937_64 engine(5);
  const auto random = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine);
  };
  for (int i = 0; i < 60; ++i) {
    Tunnel tunnel;
    double z = 0.0;
    for (int k = 0; k <= 12; ++k) {
      z += random(-0.5, 0.5);
      tunnel.addBottom({0.5 * k, z});
      tunnel.addTop({0.5 * k, z + random(0.3, 0.6)});
    }
    const double s = random(0.0, 2.0);
    const SectionPoint eye{s, random(tunnel.bottomAt(s), tunnel.topAt(s))};
    const Tunnel::Reach reach = tunnel.farthest(eye);
    const double slope = (reach.end.z - eye.z) / (reach.end.s - eye.s);
    EXPECT_NEAR(goneBy(tunnel, eye, slope), reach.end.s, 2e-3) << i;
    for (int k = -300; k <= 300; ++k) {
      EXPECT_LE(goneBy(tunnel, eye, 0.01 * k), reach.end.s + 1e-6) << i;
    }
  }
}

}  // namespace
}  // namespace arelem::motion
