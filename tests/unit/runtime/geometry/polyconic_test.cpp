#include "runtime/geometry/polyconic.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "runtime/geometry/kinds.h"

// POLCON against the surfaces that some of them are: cylinders, cones, paraboloids.
namespace arelem {
namespace {

class Points {
 public:
  double in(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }

 private:
  std::mt19937_64 engine_{360};
};

constexpr double rootHalf = 0.70710678118654752;

/// A quarter of the unit circle about the x axis, from (rootHalf, rootHalf) to (-rootHalf,
/// rootHalf): its tangents meet at (0, 1/rootHalf), and its shoulder is (0, 1). `at` is the place
/// of the first coefficient in the row of a function.
std::vector<double> quarter(double radius, std::size_t at, double cb, double pb) {
  std::vector<double> canon(79, 0.0);
  canon[0] = 1.0;
  canon[14] = cb;
  canon[15] = pb;
  const double k = radius * rootHalf;
  const std::array<double, 6> rows{-k, k, -k, -k, k, k};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    canon[16 + 8 * i + at] = rows[i];
  }
  canon[16 + 8 * 6] = rootHalf;
  return canon;
}

surface::Polyconic of(const std::vector<double>& canon) {
  return surface::Polyconic(geometry::Polyconic::of(canon));
}

template <class Other>
void expectSame(const surface::Polyconic& s, const Other& other, const Vec3& p) {
  surface::Polyconic::Hint hint;
  typename Other::Hint otherHint{};
  const surface::Foot got = s.foot(p, hint);
  const surface::Foot want = other.foot(p, otherHint);
  // The conics run from +y to -y, so that their direction times that of x is outwards.
  EXPECT_NEAR(got.distance, want.distance, 1e-10) << p.transpose();
  EXPECT_LE((got.normal - want.normal).norm(), 1e-9) << p.transpose();
  const Vec3 t = Vec3(1, 2, -1).normalized();
  EXPECT_NEAR(s.bend(p, got, t, hint), other.bend(p, want, t, otherHint), 1e-7) << p.transpose();
}

TEST(PolyconicSurface, QuarterOfACircleIsACylinder) {
  const surface::Polyconic s = of(quarter(5.0, 0, -10.0, 20.0));
  const surface::Cylinder cylinder{Vec3::Zero(), Vec3::UnitX(), 5.0};
  Points r;
  for (int i = 0; i < 300; ++i) {
    const double angle = r.in(0.79, 2.35);
    const double radius = r.in(2.0, 9.0);
    expectSame(s, cylinder, {r.in(-10, 10), radius * std::cos(angle), radius * std::sin(angle)});
  }
}

// All six functions in proportion to d: a cone with its vertex at d = 0.
TEST(PolyconicSurface, CirclesThatGrowEvenlyAreACone) {
  std::vector<double> canon = quarter(10.0, 1, 0.0, 20.0);
  const surface::Polyconic s = of(canon);
  const double half = std::atan2(10.0, 20.0);
  const surface::Cone cone{Vec3::Zero(), Vec3::UnitX(), std::cos(half), std::sin(half)};
  Points r;
  for (int i = 0; i < 300; ++i) {
    const double angle = r.in(0.79, 2.35);
    const double x = r.in(6.0, 14.0);
    const double radius = 0.5 * x + r.in(-1.0, 1.0);
    expectSame(s, cone, {x, radius * std::cos(angle), radius * std::sin(angle)});
  }
}

// In proportion to the root of d: y y + z z = 4 d = x / 5, a paraboloid, its two opposite quarters.
TEST(PolyconicSurface, RootsMakeTheNoseOfAParaboloid) {
  std::vector<double> canon = quarter(2.0, 0, 0.0, 20.0);
  for (std::size_t i = 0; i < 6; ++i) {
    canon[72 + i] = canon[16 + 8 * i];
    canon[16 + 8 * i] = 0.0;
  }
  canon[0] = 2.0;
  EXPECT_FALSE(geometry::faultOf(geometry::Polyconic::of(canon)));
  const surface::Polyconic s = of(canon);
  Eigen::Matrix3d matrix = Eigen::Vector3d(0, 1, 1).asDiagonal();
  const surface::Quadric paraboloid(matrix, Vec3(-0.1, 0, 0), 0.0);
  Points r;
  for (const double below : {0.0, std::numbers::pi}) {
    for (int i = 0; i < 200; ++i) {
      const double angle = below + r.in(0.8, 2.34);
      const double x = r.in(1.0, 15.0);
      const double radius = std::sqrt(x / 5.0) + r.in(-0.05, 0.5);
      expectSame(s, paraboloid, {x, radius * std::cos(angle), radius * std::sin(angle)});
    }
  }
}

// What motion meets lies at T on the side of the normal, and the matrix says where the part is seen
// from: (x, y, z) of the part is (y, z, x) of the conics, 7 further.
TEST(PolyconicSurface, ThicknessAndMatrix) {
  std::vector<double> canon = quarter(5.0, 0, -10.0, 20.0);
  const std::array<double, 12> matrix{0, 1, 0, 7, 0, 0, 1, 0, 1, 0, 0, 0};
  std::copy(matrix.begin(), matrix.end(), canon.begin() + 1);
  canon[13] = 0.5;
  const surface::Polyconic s = of(canon);
  const surface::Cylinder cylinder{Vec3::Zero(), Vec3::UnitY(), 5.5};
  Points r;
  for (int i = 0; i < 100; ++i) {
    const double angle = r.in(0.79, 2.35);
    const double radius = r.in(3.0, 9.0);
    expectSame(s, cylinder, {radius * std::sin(angle), r.in(-17, 3), radius * std::cos(angle)});
  }
}

// Beyond its ends a conic goes on along its tangents: beside the quarter lie two planes.
TEST(PolyconicSurface, TangentsGoOnBeyondTheEnds) {
  const surface::Polyconic s = of(quarter(5.0, 0, -10.0, 20.0));
  const surface::Plane right{Vec3(0, rootHalf, rootHalf), 5.0};
  const surface::Plane left{Vec3(0, -rootHalf, rootHalf), 5.0};
  expectSame(s, right, {1.0, 8.0, 2.0});
  expectSame(s, left, {-12.0, -8.0, 2.5});
}

// The parabola z = -y y from (2, -4) to (-2, -4): its tangents there meet at (0, 4), and its
// shoulder (0, 0) halves the way from there to the middle of the chord, P = 3/4.
TEST(PolyconicSurface, ShoulderOfAParabola) {
  std::vector<double> canon(79, 0.0);
  canon[0] = 1.0;
  canon[15] = 10.0;
  const std::array<double, 7> rows{-2, 8, -2, -8, 2, -4, 0.75};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    canon[16 + 8 * i] = rows[i];
  }
  const surface::Polyconic s = of(canon);
  for (const double y : {-2.0, -1.5, -0.3, 0.0, 1.0, 2.0}) {
    surface::Polyconic::Hint hint;
    EXPECT_NEAR(s.foot({4.0, y, -y * y}, hint).distance, 0.0, 1e-12) << y;
  }
}

TEST(PolyconicSurface, FaultsAreFound) {
  std::vector<double> canon = quarter(5.0, 0, -10.0, 20.0);
  EXPECT_FALSE(geometry::faultOf(geometry::Polyconic::of(canon)));
  // P = 0.7071 - 0.5 d is 1/2 at d = 0.4142.
  canon[17 + 8 * 6] = -0.5;
  const auto low = geometry::faultOf(geometry::Polyconic::of(canon));
  ASSERT_TRUE(low);
  EXPECT_TRUE(low->shoulder);
  EXPECT_NEAR(low->d, 2.0 * (rootHalf - 0.5), 1e-3);
  // A = -3.53 (1 - 4 d), D as before: A B - C D = 0 at d = 1/2.
  canon = quarter(5.0, 0, -10.0, 20.0);
  canon[17] = 5.0 * rootHalf * 4.0;
  const auto flat = geometry::faultOf(geometry::Polyconic::of(canon));
  ASSERT_TRUE(flat);
  EXPECT_FALSE(flat->shoulder);
  EXPECT_NEAR(flat->d, 0.5, 1e-3);
}

// Half as far on as the first radius is what all radii grow by: the cone has its vertex there.
TEST(PolyconicSurface, ConicsThatShrinkHaveAnEnd) {
  std::vector<double> canon = quarter(5.0, 0, 0.0, 20.0);
  const std::vector<double> growing = quarter(10.0, 1, 0.0, 20.0);
  for (std::size_t i = 17; i < 64; i += 8) {
    canon[i] = growing[i];
  }
  using geometry::Polyconic;
  const Polyconic cone = Polyconic::of(canon);
  EXPECT_NEAR(cone.properEnd(Polyconic::Part::before), -0.5, 1e-7);
  EXPECT_TRUE(std::isinf(cone.properEnd(Polyconic::Part::behind)));
  const Polyconic cylinder = Polyconic::of(quarter(5.0, 0, 0.0, 20.0));
  EXPECT_TRUE(std::isinf(cylinder.properEnd(Polyconic::Part::behind)));
}

/// No place of a surface, at many s and t, is nearer than this. All are nearly this near.
double leastFrom(const geometry::Polyconic& form, const Vec3& p) {
  constexpr int across = 75;
  constexpr int along = 600;
  double least = 1e300;
  for (int i = 0; i <= across; ++i) {
    for (int k = 0; k <= along; ++k) {
      const double s = 0.3 + 0.5 * i / across;
      const double t = -2.0 + 5.0 * k / along;
      const auto at = form.at<double>(s, t, form.partOf(s), geometry::Polyconic::along(t));
      least = std::min(least, (Vec3(at[0].value, at[1].value, at[2].value) - p).norm());
    }
  }
  return least;
}

// A tall arch: from one leg to the other the foot of a point inside changes over.
TEST(PolyconicSurface, FootIsTheNearestOfAll) {
  std::vector<double> canon = quarter(5.0, 0, -10.0, 20.0);
  for (const std::size_t across : {0U, 2U, 4U}) {
    canon[16 + 8 * across] *= 0.3;
    canon[17 + 8 * across] = 0.02 * canon[16 + 8 * across];
  }
  const geometry::Polyconic form = geometry::Polyconic::of(canon);
  const surface::Polyconic s(form);
  for (const double z : {0.0, 2.0, 3.0}) {
    surface::Polyconic::Hint hint;
    for (double y = 1.5; y >= -1.5; y -= 0.125) {
      const Vec3 p(1.0, y, z);
      const double away = std::abs(s.foot(p, hint).distance);
      const double least = leastFrom(form, p);
      EXPECT_LE(away, least + 1e-9) << y << " " << z;
      EXPECT_GE(away, least - 0.1) << y << " " << z;
    }
  }
}

// The bend of a cylinder of radius 5 at 5.5 from its axis is 0 to 1/5.5.
TEST(PolyconicSurface, BendsAreNarrow) {
  const surface::Polyconic s = of(quarter(5.0, 0, -10.0, 20.0));
  const Vec3 p(1.0, 0.0, 5.5);
  surface::Polyconic::Hint hint;
  const surface::Bends b = s.bends(p, s.foot(p, hint), 0.01);
  EXPECT_LE(b.low, 0.0);
  EXPECT_GE(b.low, -0.3);
  EXPECT_GE(b.high, 1.0 / 5.5);
  EXPECT_LE(b.high, 0.6);
}

// A cutter's reach above a gentle arch that grows: bounds from its patches hold all bends, and are
// not much wider than these.
TEST(PolyconicSurface, BendsHoldOverAWideReach) {
  std::vector<double> canon = quarter(100.0, 0, -45.0, 90.0);
  for (std::size_t i = 0; i < 6; ++i) {
    canon[17 + 8 * i] = -0.1 * canon[16 + 8 * i];
  }
  const surface::Polyconic s = of(canon);
  Points r;
  for (int i = 0; i < 20; ++i) {
    const double angle = r.in(1.2, 1.9);
    const double outwards = i % 2 == 0 ? r.in(1.0, 6.0) : r.in(-6.0, -1.0);
    const Vec3 p(r.in(-20, 20), (95 + outwards) * std::cos(angle),
                 (95 + outwards) * std::sin(angle));
    constexpr double radius = 6.0;
    surface::Polyconic::Hint hint;
    const surface::Foot foot = s.foot(p, hint);
    const surface::Bends b = s.bends(p, foot, radius);
    EXPECT_GE(b.low, -0.02) << p.transpose();
    EXPECT_LE(b.high, 0.05) << p.transpose();
    for (int k = 0; k < 50; ++k) {
      const Vec3 way(r.in(-1, 1), r.in(-1, 1), r.in(-1, 1));
      const Vec3 q = p + radius * r.in(0, 1) * way.normalized();
      const Vec3 t = Vec3(r.in(-1, 1), r.in(-1, 1), r.in(-1, 1)).normalized();
      surface::Polyconic::Hint there;
      const surface::Foot of = s.foot(q, there);
      const double bend = s.bend(q, of, t, there);
      EXPECT_GE(bend, b.low - 1e-9) << q.transpose();
      EXPECT_LE(bend, b.high + 1e-9) << q.transpose();
    }
  }
}

}  // namespace
}  // namespace arelem
