#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "runtime/geometry/kinds.h"
#include "runtime/geometry/polyconic.h"

// The laws of runtime/geometry/surface.h, for every kind, on random surfaces and points (fixed
// seed).
namespace arelem::surface {
namespace {

class Random {
 public:
  double in(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vec3 point(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = point(1.0);
      if (v.norm() > 0.1 && v.norm() < 1.0) {
        return v.normalized();
      }
    }
  }

 private:
  std::mt19937_64 engine_{20261121};
};

template <class S>
S arbitrary(Random& r);
template <>
Plane arbitrary(Random& r) {
  return {r.direction(), r.in(-5, 5)};
}
template <>
Sphere arbitrary(Random& r) {
  return {r.point(3), r.in(0.5, 5)};
}
template <>
Cylinder arbitrary(Random& r) {
  return {r.point(3), r.direction(), r.in(0.5, 5)};
}
template <>
Cone arbitrary(Random& r) {
  const double half = r.in(0.2, 1.2);
  return {r.point(3), r.direction(), std::cos(half), std::sin(half)};
}
template <>
Torus arbitrary(Random& r) {
  // Sometimes a tube that runs into itself about the axis.
  return r.in(0, 3) < 1.0 ? Torus{r.point(2), r.direction(), r.in(0.3, 2.5), r.in(2.5, 5)}
                          : Torus{r.point(3), r.direction(), r.in(2, 5), r.in(0.3, 1.5)};
}
template <>
Quadric arbitrary(Random& r) {
  // An ellipsoid in general position.
  const Eigen::Matrix3d m = Eigen::AngleAxisd(r.in(0, 3), r.direction()).toRotationMatrix();
  const Vec3 roots(r.in(0.05, 0.3), r.in(0.05, 0.3), r.in(0.05, 0.3));
  return {m * roots.asDiagonal() * m.transpose(), r.point(0.1), -1.0};
}
template <>
TabulatedCylinder arbitrary(Random& r) {
  auto curve = std::make_shared<TabulatedCylinder::Curve>();
  const Eigen::Matrix3d m = Eigen::AngleAxisd(r.in(0, 3), r.direction()).toRotationMatrix();
  curve->u = m.col(0);
  curve->v = m.col(1);
  curve->w = m.col(2);
  // One gentle cubic arch between two straight extensions that continue its end slopes.
  TabulatedCylinder::Piece arch{};
  arch.dirU = 1.0;
  arch.length = 4.0;
  arch.b = -r.in(0.01, 0.15);
  arch.c = -arch.b * arch.length;
  arch.highY = arch.c * arch.length;
  const double slope = arch.c;
  const double norm = std::hypot(1.0, slope);
  TabulatedCylinder::Piece before{};
  before.dirU = 1.0 / norm;
  before.dirV = slope / norm;
  before.length = 1.0;
  before.u = -before.dirU;
  before.v = -before.dirV;
  before.openStart = true;
  // Sometimes with a corner, to either side.
  const double corner = r.in(0, 3) < 1.0 ? r.in(-0.8, 0.8) : 0.0;
  TabulatedCylinder::Piece after{};
  after.u = 4.0;
  after.dirU = std::cos(corner) / norm + std::sin(corner) * slope / norm;
  after.dirV = std::sin(corner) / norm - std::cos(corner) * slope / norm;
  after.length = 1.0;
  after.openEnd = true;
  curve->pieces = {before, arch, after};
  return TabulatedCylinder(curve);
}

/// A section by the plane of `from`, `to` and z.
geometry::SectionCurve section(EntityType type,
                               std::vector<double> canon,
                               const Vec3& from,
                               const Vec3& to) {
  geometry::SectionCurve curve;
  curve.surface.type = type;
  curve.surface.canon = std::move(canon);
  curve.start = from;
  curve.finish = to;
  return curve;
}

template <>
Ruled arbitrary(Random& r) {
  // From a curve of a tilted plane to one of a wide cylinder along y.
  const double tilt = r.in(-0.2, 0.2);
  const double radius = r.in(30, 60);
  const double norm = std::hypot(1.0, tilt);
  return Ruled({section(EntityType::plane, {-tilt / norm, 0, 1 / norm, r.in(-0.5, 0.5)},
                        {-8, -5, r.in(-1, 0)}, {8, -5, r.in(-1, 0)}),
                section(EntityType::cylinder, {r.in(-1, 1), 0, -radius, 0, 1, 0, radius},
                        {-8, 5, -2}, {8, 5, -2})});
}

/// Canonical numbers of an arc of `half` degrees to both sides of the top of the circle of radius r
/// about the x axis, in planes x = cb + pb d, from +y to -y. The control point of its tangents is
/// r / cos(half) high, and the arc's weight there cos(half).
std::vector<double> arch(double r, double half, double cb, double pb, double growth = 0.0) {
  const double sine = std::sin(half);
  const double cosine = std::cos(half);
  std::vector<double> canon(79, 0.0);
  canon[0] = 1.0;
  canon[14] = cb;
  canon[15] = pb;
  const double fall = r * sine * sine / cosine;
  const double share = cosine / (1.0 + cosine);
  const std::array<double, 7> at0{-r * sine, fall,       -r * sine,          -fall,
                                  r * sine,  r * cosine, 0.5 * (1.0 + share)};
  for (std::size_t i = 0; i < at0.size(); ++i) {
    canon[16 + 8 * i] = at0[i];
    canon[17 + 8 * i] = i < 6 ? growth * at0[i] : 0.0;
  }
  return canon;
}

template <>
Polyconic arbitrary(Random& r) {
  // A long arch that bends along x too, its top near z = 0.
  const double radius = r.in(20, 40);
  std::vector<double> canon = arch(radius, r.in(0.5, 0.8), -15, 30, r.in(-0.1, 0.1));
  canon[13] = r.in(-0.5, 0.5);
  canon[16 + 8 * 5] -= radius;
  canon[18 + 8 * 5] += r.in(-3, 3);
  canon[17 + 8 * 4] += r.in(-2, 2);
  canon[17 + 8 * 6] += r.in(-0.05, 0.05);
  return Polyconic(geometry::Polyconic::of(canon));
}

template <class S>
class SurfaceLaws : public ::testing::Test {};
using Kinds = ::testing::
    Types<Plane, Sphere, Cylinder, Cone, Torus, Quadric, TabulatedCylinder, Ruled, Polyconic>;
TYPED_TEST_SUITE(SurfaceLaws, Kinds);

TYPED_TEST(SurfaceLaws, FootLiesOnTheSurfaceAndNormalIsTheGradient) {
  Random r;
  for (int i = 0; i < 500; ++i) {
    const TypeParam s = arbitrary<TypeParam>(r);
    const Vec3 p = r.point(6);
    typename TypeParam::Hint hint{};
    const Foot foot = s.foot(p, hint);
    ASSERT_NEAR(foot.normal.norm(), 1.0, 1e-12);
    typename TypeParam::Hint again{};
    EXPECT_NEAR(s.foot(p - foot.distance * foot.normal, again).distance, 0.0, 1e-9) << i;
    const double h = 1e-6;
    const Vec3 d = r.direction();
    typename TypeParam::Hint h1{}, h2{};
    const double slope =
        (s.foot(p + h * d, h1).distance - s.foot(p - h * d, h2).distance) / (2 * h);
    // Skip the few samples at a medial axis, where the gradient jumps.
    if (std::abs(slope) <= 1.0 + 1e-6 && std::abs(slope - foot.normal.dot(d)) > 1e-4) {
      const double nearby =
          (s.foot(p + 1e-3 * d, h1).normal - s.foot(p - 1e-3 * d, h2).normal).norm();
      EXPECT_GT(nearby, 0.1) << i;
    }
  }
}

/// A surface, a place and a direction, with the feet there and at distance h before and behind.
template <class S>
struct Differences {
  S s;
  Vec3 p, t;
  typename S::Hint a{}, b{}, c{};
  Foot foot, ahead, behind;

  Differences(Random& r, double h) : s(arbitrary<S>(r)), p(r.point(6)), t(r.direction()) {
    foot = s.foot(p, a);
    ahead = s.foot(p + h * t, b);
    behind = s.foot(p - h * t, c);
  }
};

TYPED_TEST(SurfaceLaws, BendIsTheSecondDerivativeOfTheDistance) {
  Random r;
  int tested = 0;
  const double h = 1e-3;
  for (int i = 0; i < 500; ++i) {
    auto [s, p, t, a, b, c, foot, ahead, behind] = Differences<TypeParam>(r, h);
    if ((ahead.normal - behind.normal).norm() > 0.02 ||
        std::abs(s.bend(p + h * t, ahead, t, b) - s.bend(p - h * t, behind, t, c)) > 1e-3) {
      continue;  // near a center of curvature or across a joint of two pieces
    }
    const double second = (ahead.normal - behind.normal).dot(t) / (2 * h);
    EXPECT_NEAR(s.bend(p, foot, t, a), second, 1e-3 * (1.0 + std::abs(second))) << i;
    ++tested;
  }
  EXPECT_GT(tested, 300);
}

TYPED_TEST(SurfaceLaws, TurnIsTheChangeOfTheNormal) {
  if constexpr (Turning<TypeParam>) {
    Random r;
    int tested = 0;
    const double h = 1e-4;
    for (int i = 0; i < 500; ++i) {
      auto [s, p, t, a, b, c, foot, ahead, behind] = Differences<TypeParam>(r, h);
      const Vec3 turn = s.turn(p, foot, t, a);
      if ((ahead.normal - foot.normal).norm() > 0.01 ||
          (foot.normal - behind.normal).norm() > 0.01) {
        continue;  // near a center of curvature
      }
      EXPECT_LE((turn - (ahead.normal - behind.normal) / (2 * h)).norm(),
                1e-3 * (1.0 + turn.norm()))
          << i;
      EXPECT_NEAR(s.bend(p, foot, t, a), t.dot(turn), 1e-12 * (1.0 + turn.norm())) << i;
      ++tested;
    }
    EXPECT_GT(tested, 300);
  }
}

TYPED_TEST(SurfaceLaws, BendsBoundEveryBendAround) {
  Random r;
  int bounded = 0;
  for (int i = 0; i < 2000; ++i) {
    const TypeParam s = arbitrary<TypeParam>(r);
    const Vec3 p = r.point(6);
    const double radius = r.in(0.01, 0.8);
    typename TypeParam::Hint a{};
    const Foot foot = s.foot(p, a);
    const Bends bounds = s.bends(p, foot, radius);
    bounded += std::isfinite(bounds.low) || std::isfinite(bounds.high) ? 1 : 0;
    for (int k = 0; k < 20; ++k) {
      // Not the second derivative at a place but over a span, so that kinks are seen too.
      const Vec3 u = p + r.in(0, radius) * r.direction();
      const Vec3 v = p + r.in(0, radius) * r.direction();
      typename TypeParam::Hint h1{}, h2{}, h3{};
      const double squared = (v - u).squaredNorm();
      const double dip = 0.5 * (s.foot(u, h1).distance + s.foot(v, h2).distance) -
                         s.foot(0.5 * (u + v), h3).distance;
      // A function whose second derivative lies in [low, high] dips by that much of |v - u|^2 / 8.
      ASSERT_LE(dip, bounds.high * squared / 8 + 1e-9) << i;
      ASSERT_GE(dip, bounds.low * squared / 8 - 1e-9) << i;
    }
  }
  EXPECT_GT(bounded, 500);
}

TYPED_TEST(SurfaceLaws, DistanceIsLipschitz) {
  Random r;
  for (int i = 0; i < 500; ++i) {
    const TypeParam s = arbitrary<TypeParam>(r);
    const Vec3 p = r.point(6);
    const Vec3 q = p + r.in(0, 1) * r.direction();
    typename TypeParam::Hint a{}, b{};
    EXPECT_LE(std::abs(s.foot(p, a).distance - s.foot(q, b).distance),
              (p - q).norm() * (1 + 1e-9) + 1e-9)
        << i;
  }
}

/// A tube that runs into itself about the axis bounds what it is wound round too. Against the
/// nearest of many places of the arc that is seen from outside.
TEST(TorusFoot, IsTheNearestOfWhatIsSeenWhereTheTubeRunsIntoItself) {
  Random r;
  for (int i = 0; i < 200; ++i) {
    Torus s{Vec3::Zero(), Vec3::UnitZ(), r.in(0.2, 3), 3.0};
    const double half = std::acos(-s.major / s.minor);  // of the arc, from outwards to a tip
    const Vec3 p = r.point(5);
    const double rho = p.head<2>().norm();
    double nearest = 1e9;
    constexpr int steps = 20000;
    for (int k = 0; k <= steps; ++k) {
      const double angle = half * (2.0 * k / steps - 1.0);
      nearest = std::min(nearest, std::hypot(rho - s.major - s.minor * std::cos(angle),
                                             p.z() - s.minor * std::sin(angle)));
    }
    const bool inside = std::hypot(rho - s.major, p.z()) < s.minor;
    Torus::Hint hint{};
    EXPECT_NEAR(s.foot(p, hint).distance, inside ? -nearest : nearest, 1e-5) << i;
  }
}

TabulatedCylinder cylinderOf(std::vector<TabulatedCylinder::Piece> pieces) {
  auto curve = std::make_shared<TabulatedCylinder::Curve>();
  curve->u = Vec3::UnitX();
  curve->v = Vec3::UnitY();
  curve->w = Vec3::UnitZ();
  curve->pieces = std::move(pieces);
  return TabulatedCylinder(std::move(curve));
}

/// Under a roof of two planes at 45 degrees: the ridge is out of reach, yet a place has a foot on
/// each side, and the distance dips by 0.04 sin 45 in the middle of a way of 0.08.
TEST(TabulatedCylinderBends, KnowOfCornersOutOfReach) {
  const double slant = std::sqrt(0.5);
  TabulatedCylinder::Piece up{}, down{};
  up.u = up.v = -10.0 * slant;
  up.dirU = up.dirV = slant;
  up.length = down.length = 10.0;
  up.openStart = down.openEnd = true;
  down.dirU = slant;
  down.dirV = -slant;
  const TabulatedCylinder roof = cylinderOf({up, down});
  const Vec3 p(0.0, -1.0, 0.0);
  TabulatedCylinder::Hint hint{};
  const Foot foot = roof.foot(p, hint);
  EXPECT_NEAR(foot.distance, -slant, 1e-12);
  EXPECT_GE(roof.bends(p, foot, 0.05).high, 0.04 * slant * 8.0 / (0.08 * 0.08));
}

/// Next to a center of curvature, where the squared distance is hardly convex. The nearest place is
/// a root of the cubic (x - qx) + (h - qy) h'.
TEST(TabulatedCylinderFoot, IsExactNextToACenterOfCurvature) {
  TabulatedCylinder::Piece arch{};
  arch.dirU = 1.0;
  arch.length = 4.0;
  arch.b = -0.0583965;
  arch.c = 0.233586;
  arch.highY = arch.c * arch.length;
  TabulatedCylinder::Hint hint{};
  const Foot foot = cylinderOf({arch}).foot({2.033935122, -7.696062904, 0.0}, hint);
  EXPECT_NEAR(foot.distance, -7.9287477372366, 1e-9);
}

/// A sharp S over one chord: wherever the last foot was, the foot is the nearest of many places of
/// the curve, to their distance of 0.001.
TEST(TabulatedCylinderFoot, IsTheNearestWhateverTheHint) {
  TabulatedCylinder::Piece wave{};
  wave.dirU = 1.0;
  wave.length = 3.625;
  wave.a = -0.285336;
  wave.b = 1.34036;
  wave.c = -wave.length * (wave.a * wave.length + wave.b);
  wave.lowY = -0.2554;
  wave.highY = 1.1631;
  const TabulatedCylinder s = cylinderOf({wave});
  Random r;
  TabulatedCylinder::Hint hint{};
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p(r.in(-1, 5), r.in(-3, 4), 0.0);
    double least = 1e300;
    for (double x = 0.0; x <= wave.length; x += 0.001) {
      const double y = ((wave.a * x + wave.b) * x + wave.c) * x;
      least = std::min(least, std::hypot(x - p.x(), y - p.y()));
    }
    EXPECT_NEAR(std::abs(s.foot(p, hint).distance), least, 0.002) << i;
  }
}

}  // namespace
}  // namespace arelem::surface
