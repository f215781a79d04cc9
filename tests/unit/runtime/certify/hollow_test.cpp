#include <array>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "runtime/certify/hollow_search.h"
#include "runtime/certify/prove.h"

namespace arelem::certify {
namespace {

using State = Verdict::State;

constexpr int enough = 20000;
constexpr double degree = std::numbers::pi / 180.0;

tool::Profile cutter(std::vector<double> values) {
  return *tool::makeProfile(values);
}

/// Half angle in degrees, the vertex at the origin, open upwards.
surface::Cone cone(double half) {
  return {Vec3::Zero(), Vec3::UnitZ(), std::cos(half * degree), std::sin(half * degree)};
}

Turn turnOf(double radians) {
  return {radians, std::cos(radians), std::sin(radians)};
}

TEST(RimSearch, LeastOfASumOfCosineAndSine) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-2.0, 2.0);
  for (int i = 0; i < 500; ++i) {
    const double a = number(random);
    const double b = number(random);
    const double half = i % 10 == 0 ? std::numbers::pi : std::abs(number(random));
    double sampled = 0.0;
    for (int k = -2000; k <= 2000; ++k) {
      const double x = half * k / 2000.0;
      sampled = std::min(sampled, a * (1.0 - std::cos(x)) + b * std::sin(x));
    }
    const double least = leastOfTurn(a, b, turnOf(half));
    EXPECT_LE(least, sampled + 1e-14) << a << " " << b << " " << half;
    EXPECT_NEAR(least, sampled, 1e-5);
  }
}

TEST(RimSearch, ACircleBesideTheAxisOfAHollowCylinder) {
  // Of a circle of radius 3 whose center is e off the axis the gap is least 7 - 3 - e.
  const surface::Cylinder hollow{Vec3::Zero(), Vec3::UnitZ(), 7.0};
  RimSearch<surface::Cylinder> rims(hollow, {nullptr, -1.0, 0.0});
  for (const double e : {0.0, 1.5, 4.0, 4.5}) {
    const auto run = [&](double aim) {
      return rims.run(Vec3(e, 0, 1), Vec3::UnitZ(), 3.0, 0.0, aim, enough);
    };
    const BodyResult good = run(4.0 - e - 1e-9);
    EXPECT_TRUE(good.proven) << e;
    const BodyResult bad = run(4.0 - e + 1e-9);
    EXPECT_FALSE(bad.proven) << e;
    EXPECT_LE(bad.low, 4.0 - e);
    EXPECT_TRUE(std::isfinite(bad.low));
  }
}

TEST(RimSearch, ACircleThatTouchesAllAround) {
  // A circle in a cone of its own axis is equally near all around.
  const surface::Cone hollow = cone(60.0);
  RimSearch<surface::Cone> rims(hollow, {nullptr, -1.0, 0.0});
  const double height = 5.0 / std::tan(60.0 * degree);
  const BodyResult r = rims.run(Vec3(0, 0, height), Vec3::UnitZ(), 5.0, 0.0, -1e-8, enough);
  EXPECT_TRUE(r.proven);
  EXPECT_LT(r.measured, 5000);
  const BodyResult deeper =
      rims.run(Vec3(0, 0, height - 1e-6), Vec3::UnitZ(), 5.0, 0.0, 0.0, enough);
  EXPECT_FALSE(deeper.proven);
  EXPECT_NEAR(deeper.sample, -1e-6 * std::sin(60.0 * degree), 1e-12);
}

struct Scene {
  surface::AnySurface surface;
  tool::Profile cutter;
  Vec3 axis = Vec3::UnitZ();
  Vec3 axisTo = Vec3::UnitZ();
  Allowed allowed{0.0, 0.001, 1e-6};

  [[nodiscard]] Verdict prove(const Vec3& from, const Vec3& to) const {
    const auto probe = makeProbe(surface, {&cutter, -1.0, 0.0});
    probe->take(Chord(from, to, axis, axisTo));
    Node first = probe->at(0.0);
    return certify::prove(*probe, allowed, first);
  }
};

/// A place on the circle on which a tool touches the cone along a line, `gap` off.
Vec3 inCone(double half, double radius, double height, double gap, double angle) {
  const double off = height * std::tan(half * degree) - radius - gap / std::cos(half * degree);
  return {off * std::cos(angle), off * std::sin(angle), height};
}

TEST(Hollow, ATaperedToolInAConeOfItsTaper) {
  // Tool end of radius 3, sides of 10 degrees; the tool end runs on a circle of radius
  // 200 tan 10 - 3 at most. A chord of it bows inwards by its sagitta, times cos 10.
  Scene scene{cone(10.0), cutter({6, 0, 0, 0, 0, 10, 20})};
  const double run = 200.0 * std::tan(10.0 * degree) - 3.0;
  const double half = std::acos(1.0 - 0.00099 / std::cos(10.0 * degree) / run);
  const auto at = [&](double gap, double a) { return inCone(10.0, 3.0, 200.0, gap, a); };
  const Verdict good = scene.prove(at(0.0, -half), at(0.0, half));
  EXPECT_TRUE(good.good());
  EXPECT_NEAR(good.least.proven, 0.0, 1e-6);
  EXPECT_NEAR(good.greatest.proven, 0.00099, 1e-5);
  EXPECT_LT(good.nodes, 200U);
  const Verdict bad = scene.prove(at(-2e-6, -half), at(0.0, half));
  EXPECT_EQ(bad.inner, State::refuted);
  EXPECT_NEAR(bad.least.measured, -2e-6, 1e-9);
  EXPECT_TRUE(std::isfinite(bad.least.proven));
  const Verdict far = scene.prove(at(0.0, -1.1 * half), at(0.0, 1.1 * half));
  EXPECT_EQ(far.outer, State::refuted);
}

TEST(Hollow, ADrillInACountersinkOfItsAngle) {
  Scene scene{cone(60.0), cutter({10, 0, 0, 0, 30, 0, 20})};
  // Seated it touches all around; raised its gap is the height times sin 60.
  EXPECT_TRUE(scene.prove(Vec3(0, 0, 0), Vec3(0, 0, 0.0011)).good());
  EXPECT_EQ(scene.prove(Vec3(0, 0, -4e-6), Vec3(0, 0, 0.0011)).inner, State::refuted);
  EXPECT_EQ(scene.prove(Vec3(0, 0, 0), Vec3(0, 0, 0.0013)).outer, State::refuted);
  // Along a line of the cone.
  const double rise = 1.0 / std::tan(60.0 * degree);
  EXPECT_TRUE(scene.prove(Vec3(0, 0, 0), Vec3(9, 0, 9 * rise)).good());
  EXPECT_TRUE(scene.prove(Vec3(3, 0, 3 * rise), Vec3(9, 0, 9 * rise)).good());
  EXPECT_EQ(scene.prove(Vec3(3, 0, 3 * rise), Vec3(9, 0, 9 * rise - 6e-6)).inner, State::refuted);
}

TEST(Hollow, AnAxisAlongTheLinesOfACone) {
  // The tool stands parallel to the line of the cone that it touches, and turns with it.
  const double a = 20.0 * degree;
  Scene scene{cone(20.0), cutter({6, 0, 0, 0, 0, 0, 20})};
  const auto axis = [&](double angle) {
    return Vec3(std::sin(a) * std::cos(angle), std::sin(a) * std::sin(angle), std::cos(a));
  };
  const auto toolEnd = [&](double angle, double gap) {
    const Vec3 inwards(-std::cos(a) * std::cos(angle), -std::cos(a) * std::sin(angle), std::sin(a));
    return Vec3(60.0 * axis(angle) + (3.0 + gap) * inwards);
  };
  const double half = 0.4 * degree;
  scene.axis = axis(-half);
  scene.axisTo = axis(half);
  const Verdict good = scene.prove(toolEnd(-half, 0.0), toolEnd(half, 0.0));
  EXPECT_TRUE(good.good()) << good.least.proven << " " << good.greatest.proven;
  const Verdict bad = scene.prove(toolEnd(-half, -3e-6), toolEnd(half, 0.0));
  EXPECT_EQ(bad.inner, State::refuted);
}

TEST(Hollow, CylindersAndQuadrics) {
  // A flat end of radius 3 stands on two places of its rim, 4 below the axis of a hollow of 5.
  const surface::AnySurface cylinder = surface::Cylinder{Vec3::Zero(), Vec3::UnitX(), 5.0};
  const surface::AnySurface quadric =
      surface::Quadric(Vec3(0, 1, 1).asDiagonal().toDenseMatrix(), Vec3::Zero(), -25.0);
  for (const auto& hollow : {cylinder, quadric}) {
    const Scene scene{hollow, cutter({6, 0})};
    const Verdict good = scene.prove(Vec3(0, 0, -4), Vec3(5, 0, -4 + 0.001));
    EXPECT_TRUE(good.good());
    EXPECT_NEAR(good.greatest.proven, 0.0008, 1e-6);
    const Verdict bad = scene.prove(Vec3(0, 0, -4), Vec3(5, 0, -4 - 2.6e-6));
    EXPECT_EQ(bad.inner, State::refuted);
    EXPECT_NEAR(bad.least.measured, -0.8 * 2.6e-6, 1e-9);
  }
}

/// The least gap of a moving cutter, by a search of its places that knows no bounds.
class Sampled {
 public:
  Sampled(const surface::AnySurface& surface, const tool::Profile& cutter, const Chord& chord)
      : surface_(surface), chord_(chord), pieces_(piecesOf(cutter)) {}

  double least() {
    double best = unbounded;
    for (const Piece& piece : pieces_) {
      std::array<double, 3> from{};
      double low = unbounded;
      for (int i = 0; i < 4000; ++i) {
        const std::array<double, 3> at{i % 10 / 9.0, i / 10 % 40 / 40.0, i / 400 / 9.0};
        const double gap = this->gap(piece, at);
        if (gap < low) {
          low = gap;
          from = at;
        }
      }
      for (double step = 0.05; step > 1e-10;) {
        bool better = false;
        for (std::size_t k = 0; k < 6; ++k) {
          auto at = from;
          at.at(k / 2) += k % 2 == 0 ? step : -step;
          at[0] = std::clamp(at[0], 0.0, 1.0);
          at[2] = std::clamp(at[2], 0.0, 1.0);
          const double gap = this->gap(piece, at);
          if (gap < low) {
            low = gap;
            from = at;
            better = true;
          }
        }
        step *= better ? 1.5 : 0.5;
      }
      best = std::min(best, low);
    }
    return best;
  }

 private:
  double gap(const Piece& piece, const std::array<double, 3>& at) const {
    const Vec3 axis = chord_.axis(at[0]);
    const Vec3 e2 = chord_.turn() > 0.0 ? chord_.pole() : Vec3(axis.unitOrthogonal());
    const double angle = 2.0 * std::numbers::pi * at[1];
    const tool::ProfilePoint p = piece.at(at[2]);
    const Vec3 place = chord_.toolEnd(at[0]) + p.z * axis +
                       p.rho * (std::cos(angle) * e2.cross(axis) + std::sin(angle) * e2);
    return std::visit(
        [&]<class S>(const S& s) {
          typename S::Hint hint{};
          return -s.foot(place, hint).distance - piece.ball;
        },
        surface_);
  }
  const surface::AnySurface& surface_;
  Chord chord_;
  std::vector<Piece> pieces_;
};

TEST(Hollow, RandomCuttersAreProvenUpToTheirLeastGap) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const std::array<surface::AnySurface, 4> hollows{
      surface::Cylinder{Vec3(0, 0, -1), Vec3(1, 0.3, 0.2).normalized(), 9.0}, cone(35.0),
      surface::Quadric(Vec3(0.01, 0.02, 0.03).asDiagonal().toDenseMatrix(), Vec3::Zero(), -1.0),
      surface::Torus{Vec3::Zero(), Vec3::UnitZ(), 12.0, 8.0}};
  const std::array cutters{cutter({4, 0}), cutter({4, 1}), cutter({5, 0.5, 1, 1.2, 20, 8, 5}),
                           cutter({4, 0, 0, 0, 30, 0, 4}), cutter({3, 1.5})};
  for (int i = 0; i < 80; ++i) {
    const std::size_t kind = static_cast<std::size_t>(i) % hollows.size();
    Scene scene{hollows.at(kind), cutters.at(static_cast<std::size_t>(i / 4) % cutters.size())};
    const Vec3 middle = kind == 1 ? Vec3(0, 0, 12) : kind == 3 ? Vec3(12, 0, 0) : Vec3(0, 0, 0);
    const auto near = [&] { return Vec3(unit(random), unit(random), unit(random)); };
    const Vec3 from = middle + near();
    const Vec3 to = from + near();
    scene.axis = (Vec3::UnitZ() + 0.4 * near()).normalized();
    scene.axisTo = i % 3 == 0 ? scene.axis : Vec3((scene.axis + 0.1 * near()).normalized());
    const double least =
        Sampled(scene.surface, scene.cutter, Chord(from, to, scene.axis, scene.axisTo)).least();
    const auto within = [&](double floor) {
      scene.allowed = {-floor, 100.0, 0.0};
      scene.allowed.figures = false;
      return scene.prove(from, to);
    };
    const Verdict good = within(least - 1e-5);
    EXPECT_EQ(good.inner, State::proven) << i << " " << least << " " << good.least.proven;
    const Verdict bad = within(least + 1e-6);
    EXPECT_EQ(bad.inner, State::refuted) << i << " " << least << " " << bad.least.measured;
  }
}

}  // namespace
}  // namespace arelem::certify
