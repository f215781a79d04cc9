#include "runtime/certify/prove.h"

#include <random>

#include <gtest/gtest.h>

namespace arelem::certify {
namespace {

using tool::Profile;

Profile cutter(std::vector<double> values) {
  return *tool::makeProfile(values);
}

struct Scene {
  surface::AnySurface surface = surface::Plane{};
  Profile cutter;
  double side = 1.0;
  Vec3 axis = Vec3::UnitZ();
  std::optional<Vec3> axisTo = std::nullopt;
  Allowed allowed{0.001, 0.001, 1e-9};

  Verdict prove(const Vec3& from, const Vec3& to, bool on = false) {
    const auto probe = makeProbe(surface, {on ? nullptr : &cutter, side, 0.0});
    probe->take(Chord(from, to, axis, axisTo.value_or(axis)));
    Node first = probe->at(0.0);
    return certify::prove(*probe, allowed, first);
  }
};

using State = Verdict::State;

TEST(Prove, AChordOverASphereDipsByItsSagitta) {
  // Ball of radius 1 over a sphere of radius 9: the center runs on radius 10. A chord between two
  // places of height 10.001 dips to 10.001 cos(half angle).
  Scene scene{surface::Sphere{Vec3::Zero(), 9.0}, cutter({2.0, 1.0})};
  const double half = std::acos((10.0 - 0.0009) / 10.001);
  const auto at = [](double a) {
    return Vec3(10.001 * std::sin(a), 0, 10.001 * std::cos(a) - 1.0);
  };
  Verdict v = scene.prove(at(-half), at(half));
  EXPECT_TRUE(v.good());
  EXPECT_NEAR(v.least.proven, -0.0009, 2e-5);
  EXPECT_LE(v.least.proven, -0.0009 + 1e-12);
  EXPECT_GE(v.greatest.proven, 0.001 - 1e-12);
  EXPECT_NEAR(v.greatest.proven, 0.001, 1e-9);
  // A chord a tenth longer undercuts: its ends are as good as before.
  v = scene.prove(at(-1.1 * half), at(1.1 * half));
  EXPECT_EQ(v.inner, State::refuted);
  EXPECT_EQ(v.outer, State::proven);
  EXPECT_NEAR(v.least.measured, 10.001 * std::cos(1.1 * half) - 10.0, 1e-9);
  EXPECT_NEAR(v.least.at, 0.5, 1e-6);
}

TEST(Prove, TouchingTheLimitIsDecided) {
  Scene scene{surface::Sphere{Vec3::Zero(), 9.0}, cutter({2.0, 1.0})};
  const auto at = [](double a) {
    return Vec3(10.001 * std::sin(a), 0, 10.001 * std::cos(a) - 1.0);
  };
  for (const double beyond : {-1e-8, 1e-7}) {
    const double half = std::acos((10.0 - 0.001 - beyond) / 10.001);
    const Verdict v = scene.prove(at(-half), at(half));
    EXPECT_EQ(v.inner, beyond < 0.0 ? State::proven : State::refuted) << beyond;
  }
}

/// The least and the greatest gap found by brute force over cutter and chord.
struct BruteForce {
  double least = 1e9, greatest = -1e9;
};

BruteForce bruteForce(const Scene& scene, const Vec3& from, const Vec3& to) {
  const Chord chord(from, to, scene.axis, scene.axisTo.value_or(scene.axis));
  std::vector<tool::ProfilePoint> profile;
  const Profile& p = scene.cutter;
  for (int i = 0; i <= 16; ++i) {
    const double u = i / 16.0;
    if (!p.ring) {
      profile.push_back({u * p.bottomEnd.rho, u * p.bottomEnd.z});
      profile.push_back({p.sideStart.rho + u * (p.sideEnd.rho - p.sideStart.rho),
                         p.sideStart.z + u * (p.sideEnd.z - p.sideStart.z)});
    }
    const double a = p.alpha + u * (M_PI / 2 - p.beta - p.alpha);
    profile.push_back({p.e + p.r * std::sin(a), p.f - p.r * std::cos(a)});
  }
  BruteForce result;
  for (int k = 0; k <= 16; ++k) {
    const double s = k / 16.0;
    const Vec3 axis = chord.axis(s);
    const Vec3 e1 = axis.unitOrthogonal();
    const Vec3 e2 = axis.cross(e1);
    double gap = 1e9;
    for (int j = 0; j < 90; ++j) {
      const double t = j * M_PI / 45;
      const Vec3 radial = std::cos(t) * e1 + std::sin(t) * e2;
      for (const tool::ProfilePoint& q : profile) {
        const Vec3 y = chord.toolEnd(s) + q.rho * radial + q.z * axis;
        gap = std::min(gap, scene.side * std::visit(
                                             [&]<class S>(const S& surface) {
                                               typename S::Hint hint{};
                                               return surface.foot(y, hint).distance;
                                             },
                                             scene.surface));
      }
    }
    result.least = std::min(result.least, gap);
    result.greatest = std::max(result.greatest, gap);
  }
  return result;
}

std::vector<Profile> cutters() {
  return {cutter({2.0, 1.0}),
          cutter({2.0}),
          cutter({2.0, 0.4}),
          cutter({2.0, 0.25, 0.7, 0.3, 0.0, 10.0, 3.0}),
          cutter({2.0, 0.2, 0.6, 0.5, 20.0, 0.0, 3.0}),
          tool::makeRing(0.8, 0.5)};
}

std::vector<surface::AnySurface> surfaces() {
  using namespace surface;
  const Vec3 tilted = Vec3(1, 2, 3).normalized();
  Eigen::Matrix3d saddle = Eigen::Matrix3d::Zero();
  saddle.diagonal() = Vec3(0.05, -0.03, 0);
  return {Plane{tilted, 0.0},
          Sphere{{0, 0, -6}, 6.0},
          Cylinder{{0, 0, -5}, Vec3(1, 1, 0.2).normalized(), 5.0},
          Cylinder{{0, 0, 8}, Vec3(1, 0, 0), 8.0},
          Cone{{-12, 0, -3}, Vec3::UnitX(), std::cos(0.3), std::sin(0.3)},
          Torus{{0, 0, -4}, Vec3::UnitZ(), 6.0, 3.0},
          Torus{{0, 0, -2}, Vec3::UnitY(), 9.0, 2.0},
          Quadric(Vec3(0.01, 0.02, 0.04).asDiagonal(), {0, 0, 0.2}, 0.0),
          Quadric(saddle, {0, 0, 0.5}, 0.0)};
}

TEST(Prove, BoundsHoldForEveryCutterAndSurface) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> in(-1.0, 1.0);
  int decided = 0;
  int runs = 0;
  for (const auto& surface : surfaces()) {
    for (const Profile& profile : cutters()) {
      for (int i = 0; i < 4; ++i) {
        Scene scene{surface, profile, in(random) < 0.0 ? -1.0 : 1.0};
        scene.axis = Vec3(0.4 * in(random), 0.4 * in(random), 1).normalized();
        if (i % 2 == 1) {
          scene.axisTo = Vec3(0.4 * in(random), 0.4 * in(random), 1).normalized();
        }
        scene.allowed = {0.05, 0.05, 1e-9};
        const Vec3 from(in(random), in(random), in(random));
        const Vec3 to = from + 0.3 * Vec3(in(random), in(random), in(random));
        const Verdict v = scene.prove(from, to);
        const BruteForce b = bruteForce(scene, from, to);
        const double coarse = 0.03;  // of the brute force
        ++runs;
        EXPECT_GE(b.least, v.least.proven - 1e-9) << surface.index() << ' ' << i;
        EXPECT_LE(v.least.measured, b.least + 1e-3) << surface.index() << ' ' << i;
        EXPECT_LE(b.greatest - coarse, v.greatest.proven) << surface.index() << ' ' << i;
        decided += v.inner != State::undecided && v.outer != State::undecided ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(decided, runs);
}

/// z = x^2/4 - x over x in [0, 4], lowest at x = 2 with -1, with straight ends; along y.
surface::TabulatedCylinder trough() {
  auto curve = std::make_shared<surface::TabulatedCylinder::Curve>();
  curve->u = Vec3::UnitX();
  curve->v = Vec3::UnitZ();
  curve->w = -Vec3::UnitY();
  const double d = std::sqrt(0.5);
  curve->pieces = {{-10 * d, 10 * d, d, -d, 10, 0, 0, 0, true, false, 0, 0},
                   {0, 0, 1, 0, 4, 0, 0.25, -1, false, false, -1, 0},
                   {4, 0, d, d, 10, 0, 0, 0, false, true, 0, 0}};
  return surface::TabulatedCylinder(std::move(curve));
}

TEST(Prove, AFlatCutterInATroughGoesFromRimToRim) {
  // Radius 1, level from x = 1.5 to 2.5: it is nearest at the ends, where a rim is over x = 0.5 and
  // 3.5, at -7/16, of slope 3/4; in the middle the rims are 5/16 higher over the trough.
  Scene scene{trough(), cutter({2.0}), 1.0, Vec3::UnitZ(), std::nullopt, {0.0, 1.0, 1e-9}};
  Verdict v = scene.prove({1.5, 0, -0.4375}, {2.5, 0, -0.4375});
  EXPECT_TRUE(v.good());
  EXPECT_LT(v.nodes, 200);
  EXPECT_LE(std::abs(v.least.measured), 1e-9);
  EXPECT_LE(v.greatest.measured, 0.3125);
  v = scene.prove({1.5, 0, -0.4475}, {2.5, 0, -0.4475});
  EXPECT_EQ(v.inner, State::refuted);
  EXPECT_NEAR(v.least.measured, -0.008, 1e-4);  // 0.01 times the cosine of the slope
}

TEST(Prove, ACutterBelowATabulatedCylinderByWhatIsAllowedIsProven) {
  // A flat cutter of radius 1 cuts 0.05 deep into a crest, z = x - x^2/4, below its top.
  auto curve = std::make_shared<surface::TabulatedCylinder::Curve>(trough().curve());
  curve->v = -Vec3::UnitZ();
  curve->w = Vec3::UnitY();
  Scene scene{surface::TabulatedCylinder(std::move(curve)),
              cutter({2.0}),
              -1.0,
              Vec3::UnitZ(),
              std::nullopt,
              {0.05, 0.05, 1e-9}};
  Verdict v = scene.prove({1.8, 0, 0.95}, {2.2, 0, 0.95});
  EXPECT_TRUE(v.good());
  EXPECT_NEAR(v.least.proven, -0.05, 2e-3);
  scene.allowed.inner = 0.04;
  v = scene.prove({1.8, 0, 0.95}, {2.2, 0, 0.95});
  EXPECT_EQ(v.inner, State::refuted);
}

}  // namespace
}  // namespace arelem::certify
