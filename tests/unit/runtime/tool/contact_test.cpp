#include "runtime/tool/contact.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

// The contact against brute force: many points of the cutter, the least signed distance among them.
namespace arelem::tool {
namespace {

std::vector<Vec3> pointsOf(
    const Profile& p, const Vec3& te, const Vec3& axis, int around, int along) {
  std::vector<ProfilePoint> profile;
  const auto line = [&](ProfilePoint a, ProfilePoint b) {
    for (int i = 0; i <= along; ++i) {
      const double s = static_cast<double>(i) / along;
      profile.push_back({a.rho + s * (b.rho - a.rho), a.z + s * (b.z - a.z)});
    }
  };
  line({0, 0}, p.bottomEnd);
  line(p.sideStart, p.sideEnd);
  const double from = -M_PI / 2 + p.alpha;
  const double to = -p.beta;
  for (int i = 0; i <= along; ++i) {
    const double angle = from + (to - from) * i / along;
    profile.push_back({p.e + p.r * std::cos(angle), p.f + p.r * std::sin(angle)});
  }
  const Vec3 e1 = axis.unitOrthogonal();
  const Vec3 e2 = axis.cross(e1);
  std::vector<Vec3> points;
  for (const ProfilePoint& q : profile) {
    for (int k = 0; k < around; ++k) {
      const double a = 2 * M_PI * k / around;
      points.push_back(te + q.rho * (std::cos(a) * e1 + std::sin(a) * e2) + q.z * axis);
    }
  }
  return points;
}

const std::vector<std::vector<double>> cutters = {{0.75},
                                                  {0.75, 0.375},
                                                  {1.0, 0.1875},
                                                  {0.75, 0.125, 0.266342, 0.125, 0, 8, 3},
                                                  {1.0, 0, 0.5, 0, 0, 0, 2}};

template <class S, class Make>
void compare(Make make, double side, int count) {
  std::mt19937_64 engine(7);
  const auto in = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine);
  };
  for (int i = 0; i < count; ++i) {
    const S s = make(in);
    for (const auto& values : cutters) {
      const Profile cutter = *makeProfile(values);
      const Vec3 axis = Vec3(in(-0.3, 0.3), in(-0.3, 0.3), 1).normalized();
      const Vec3 te(in(-3, 3), in(-3, 3), in(-1, 4));
      Search<S> search;
      const Contact c = contact(s, side, cutter, te, axis, search);
      typename S::Hint hint{};
      double least = 1e9;
      for (const Vec3& p : pointsOf(cutter, te, axis, 256, 64)) {
        least = std::min(least, side * s.foot(p, hint).distance);
      }
      if (c.gap < -0.05) {
        continue;  // deep gouges have no single contact
      }
      EXPECT_NEAR(c.gap, least, 2e-3) << i << " cutter " << values.size() << " d " << values[0];
      EXPECT_NEAR(side * s.foot(c.point, hint).distance, c.gap, 1e-9);
    }
  }
}

TEST(Contact, PlaneAgainstBruteForce) {
  compare<surface::Plane>(
      [](auto in) {
        return surface::Plane{Vec3(in(-0.5, 0.5), in(-0.5, 0.5), 1).normalized(), -1.0};
      },
      1.0, 20);
}
TEST(Contact, SphereOutsideAgainstBruteForce) {
  compare<surface::Sphere>(
      [](auto in) {
        return surface::Sphere{{in(-1, 1), in(-1, 1), -6}, 5.0};
      },
      1.0, 20);
}
TEST(Contact, SphereInsideAgainstBruteForce) {
  compare<surface::Sphere>(
      [](auto in) {
        return surface::Sphere{{in(-1, 1), in(-1, 1), 8}, 12.0};
      },
      -1.0, 20);
}
TEST(Contact, CylinderAgainstBruteForce) {
  compare<surface::Cylinder>(
      [](auto in) {
        return surface::Cylinder{
            {0, 0, -6}, Vec3(1, in(-0.5, 0.5), in(-0.3, 0.3)).normalized(), 4.5};
      },
      1.0, 20);
}
TEST(Contact, CylinderAcrossTheAxisByPencil) {
  const Profile flat = *makeProfile(std::vector<double>{2.0, 0.0});
  const auto touch = [&](double radius, double side, const Vec3& te) {
    const surface::Cylinder s{{0, 0, 0}, Vec3::UnitY(), radius};
    Search<surface::Cylinder> search;
    return contact(s, side, flat, te, Vec3::UnitZ(), search);
  };
  const Contact rim = touch(5.0, 1.0, {4, 7, 4});
  EXPECT_NEAR(rim.gap, 0.0, 1e-14);
  EXPECT_LT((rim.normal - Vec3(0.6, 0.0, 0.8)).norm(), 1e-14);
  EXPECT_LT((rim.point - Vec3(3, 7, 4)).norm(), 1e-14);
  const Contact crest = touch(5.0, 1.0, {0.5, 0, 5.25});
  EXPECT_NEAR(crest.gap, 0.25, 1e-14);
  EXPECT_LT((crest.normal - Vec3::UnitZ()).norm(), 1e-14);
  EXPECT_LT((crest.point - Vec3(0, 0, 5.25)).norm(), 1e-14);
  const Contact hollow = touch(13.0, -1.0, {4, 0, -12});
  EXPECT_NEAR(hollow.gap, 0.0, 1e-14);
  EXPECT_LT((hollow.normal - Vec3(-5, 0, 12) / 13).norm(), 1e-14);
  EXPECT_LT((hollow.point - Vec3(5, 0, -12)).norm(), 1e-14);
}

/// The closed form and the search, for which the axis leans by next to nothing.
TEST(Contact, CylinderAcrossTheAxisIsTheLimitOfOneThatLeans) {
  std::mt19937_64 engine(11);
  const auto in = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine);
  };
  for (int i = 0; i < 200; ++i) {
    const double angle = in(0, 3);
    const Vec3 along(std::cos(angle), std::sin(angle), 0);
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    const surface::Cylinder square{{0, 0, side > 0 ? -6.0 : 6.0}, along, 7.0};
    surface::Cylinder leaning = square;
    leaning.axis = (along + 1e-10 * Vec3::UnitZ()).normalized();
    for (const auto& values : cutters) {
      const Profile cutter = *makeProfile(values);
      const Vec3 te(in(-3, 3), in(-3, 3), side > 0 ? in(0.5, 3) : in(0.5, 1.5));
      Search<surface::Cylinder> first, second;
      const Contact a = contact(square, side, cutter, te, Vec3::UnitZ(), first);
      const Contact b = contact(leaning, side, cutter, te, Vec3::UnitZ(), second);
      EXPECT_NEAR(a.gap, b.gap, 1e-8) << i << " cutter " << values.size() << " side " << side;
      EXPECT_NEAR(a.normal.norm(), 1.0, 1e-13);
    }
  }
}
TEST(Contact, ConeAgainstBruteForce) {
  compare<surface::Cone>(
      [](auto in) {
        return surface::Cone{{-20, in(-1, 1), -6}, Vec3::UnitX(), std::cos(0.25), std::sin(0.25)};
      },
      1.0, 20);
}
TEST(Contact, TorusAgainstBruteForce) {
  compare<surface::Torus>(
      [](auto in) {
        return surface::Torus{{in(-1, 1), 0, -5}, Vec3::UnitY(), 3.0, 1.5};
      },
      1.0, 20);
}
TEST(Contact, EllipsoidAgainstBruteForce) {
  compare<surface::Quadric>(
      [](auto in) {
        const double z = 0.1 * in(5, 6);
        return surface::Quadric(Vec3(0.04, 0.06, 0.1).asDiagonal(), {0, 0, z}, z * z / 0.1 - 1.0);
      },
      1.0, 5);
}

// Inside hollow surfaces a cutter may touch in several places. The search is carried along a path,
// as motion does, so that the contact has to jump from one place to another.
template <class S, class Make>
void followPath(Make make, double side, bool hollow = true) {
  std::mt19937_64 engine(11);
  const auto in = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine);
  };
  int jumps = 0;
  for (int i = 0; i < 12; ++i) {
    const S s = make(in);
    const Vec3 from(in(-2, 2), in(-2, 2), in(-1, 2)), to(in(-2, 2), in(-2, 2), in(-1, 2));
    for (const auto& values : cutters) {
      const Profile cutter = *makeProfile(values);
      Search<S> search;
      Vec3 last = Vec3::Zero();
      for (int k = 0; k <= 20; ++k) {
        const Vec3 te = from + k / 20.0 * (to - from);
        const Contact c = contact(s, side, cutter, te, Vec3::UnitZ(), search);
        jumps += k > 0 && (c.point - last).norm() > 0.5 ? 1 : 0;
        last = c.point - (to - from) / 20.0;
        if (k % 5 != 0 || c.gap < -0.05) {
          continue;
        }
        typename S::Hint hint{};
        double least = 1e9;
        for (const Vec3& p : pointsOf(cutter, te, Vec3::UnitZ(), 128, 32)) {
          least = std::min(least, side * s.foot(p, hint).distance);
        }
        EXPECT_LE(c.gap, least + 1e-9) << i << " place " << k << " d " << values[0];
        EXPECT_NEAR(side * s.foot(c.point, hint).distance, c.gap, 1e-9);
      }
    }
  }
  EXPECT_EQ(jumps > 0, hollow);
}

TEST(Contact, InsideCylindersContactsJump) {
  followPath<surface::Cylinder>(
      [](auto in) {
        return surface::Cylinder{
            {0, 0, in(2, 4)}, Vec3(1, in(-0.5, 0.5), in(-0.3, 0.3)).normalized(), in(4, 6)};
      },
      -1.0);
}
TEST(Contact, InsideConesContactsJump) {
  followPath<surface::Cone>(
      [](auto in) {
        const double half = in(0.5, 1.2);
        return surface::Cone{{in(-1, 1), in(-1, 1), in(-4, -2)},
                             Vec3(in(-0.3, 0.3), in(-0.3, 0.3), 1).normalized(),
                             std::cos(half),
                             std::sin(half)};
      },
      -1.0);
}
TEST(Contact, AroundConesWithTheirVertexBelow) {
  followPath<surface::Cone>(
      [](auto in) {
        const double half = in(0.5, 1.4);
        return surface::Cone{{in(-1, 1), in(-1, 1), in(-2, 0)},
                             Vec3(in(-0.3, 0.3), in(-0.3, 0.3), -1).normalized(),
                             std::cos(half),
                             std::sin(half)};
      },
      1.0, false);
}
TEST(Contact, AroundToriContactsJump) {
  followPath<surface::Torus>(
      [](auto in) {
        return surface::Torus{{in(-1, 1), in(-1, 1), in(-2, 0)},
                              Vec3(in(-1, 1), in(-1, 1), in(-1, 1)).normalized(),
                              in(2, 4),
                              in(0.3, 1.5)};
      },
      1.0);
}

TEST(Contact, ThroughAHollowTheContactGoesFromBackToFront) {
  // A flat bottom along a hyperboloid's waist: it touches behind on the way down, before on the way
  // up, and nowhere does the gap change faster than the tool moves over a slope of 0.02.
  const surface::Quadric waist(Vec3(-0.008, 0.035, 0.25).asDiagonal(), Vec3::Zero(), -1.0);
  const Profile cutter = *makeProfile(std::vector<double>{0.75, 0.125, 0.266342, 0.125, 0, 8, 3});
  Search<surface::Quadric> search;
  const Vec3 step(0.01, 0, 0);
  Vec3 te(-1, 0, 2);
  double last = contact(waist, 1.0, cutter, te, Vec3::UnitZ(), search).gap;
  for (int k = 1; k <= 200; ++k) {
    te += step;
    const Contact c = contact(waist, 1.0, cutter, te, Vec3::UnitZ(), search);
    EXPECT_LE(std::abs(c.gap - last), step.norm()) << te.x();
    EXPECT_LE(std::abs(c.gap - last), 3e-4) << te.x();
    EXPECT_GT((c.point.x() - te.x()) * te.x(), -1e-9) << te.x();
    last = c.gap;
  }
}

TEST(Contact, SharpCornerOfTheLongForm) {
  // CUTTER/2,0,0,0,0,0,3 is a flat end mill, CUTTER/2,0,0,0,45,0,3 a pointed one.
  const Profile flat = *makeProfile(std::vector<double>{2, 0, 0, 0, 0, 0, 3});
  EXPECT_DOUBLE_EQ(reach(flat, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(flat.bottomEnd.rho, 1.0);
  EXPECT_DOUBLE_EQ(flat.bottomEnd.z, 0.0);
  const Profile pointed = *makeProfile(std::vector<double>{2, 0, 0, 0, 45, 0, 3});
  EXPECT_DOUBLE_EQ(pointed.bottomEnd.rho, 1.0);
  EXPECT_DOUBLE_EQ(pointed.bottomEnd.z, 1.0);
  EXPECT_DOUBLE_EQ(pointed.sideEnd.rho, 1.0);
}

TEST(Contact, FlatBottomTouchesInside) {
  // A flat cutter square on top of a cylinder touches along the generatrix under its axis.
  const Profile flat = *makeProfile(std::vector<double>{0.062, 0.0, 0.031, 0.0, 0.0, 0.0, 0.5});
  const surface::Cylinder c{{0, 0, 0}, Vec3::UnitX(), 0.556};
  Search<surface::Cylinder> search;
  EXPECT_NEAR(contact(c, 1.0, flat, Vec3(-1.19, 0, 0.55645), Vec3::UnitZ(), search).gap, 0.00045,
              1e-12);
}

TEST(Contact, BallOnSphereIsClosedForm) {
  const Profile ball = *makeProfile(std::vector<double>{2.0, 1.0});
  const surface::Sphere s{{0, 0, 0}, 5.0};
  Search<surface::Sphere> search;
  const Contact c = contact(s, 1.0, ball, Vec3(3, 0, 5), Vec3::UnitZ(), search);
  EXPECT_NEAR(c.gap, std::hypot(3.0, 6.0) - 6.0, 1e-14);
}

TEST(Contact, WithinTheCutterNothingIsDeeperThanBelowItsTop) {
  // A ball of radius 2 in the cutter of radius 3 and height 10: its center is 1 below the top, 3
  // from the side. Steps to where it comes out go by the gap.
  const Profile cutter = *makeProfile(std::vector<double>{6.0, 0.0, 3.0, 0.0, 0.0, 0.0, 10.0});
  const auto gap = [&](double z) {
    Search<surface::Sphere> search;
    const surface::Sphere ball{Vec3(0.0, 0.0, z), 2.0};
    return contact(ball, 1.0, cutter, Vec3::Zero(), Vec3::UnitZ(), search);
  };
  EXPECT_NEAR(gap(9.0).gap, -1.0 - 2.0, 1e-12);
  EXPECT_TRUE(gap(9.0).normal.isApprox(-Vec3::UnitZ()));
  EXPECT_NEAR(gap(6.0).gap, -3.0 - 2.0, 1e-12);
  for (double z = 0.5; z < 10.0; z += 0.25) {
    EXPECT_LE(std::abs(gap(z).gap - gap(z - 0.25).gap), 0.25 + 1e-12) << z;
  }
  const auto across = [&](double z) {
    Search<surface::Cylinder> search;
    const surface::Cylinder rod{Vec3(0.0, 0.0, z), Vec3::UnitX(), 2.0};
    return contact(rod, 1.0, cutter, Vec3::Zero(), Vec3::UnitZ(), search).gap;
  };
  EXPECT_NEAR(across(9.0), -1.0 - 2.0, 1e-12);
  for (double z = 0.5; z < 14.0; z += 0.25) {
    EXPECT_LE(std::abs(across(z) - across(z - 0.25)), 0.25 + 1e-12) << z;
  }
}

TEST(Contact, WallUsesTheLargestRadius) {
  const Profile flat = *makeProfile(std::vector<double>{0.5});
  const surface::Cylinder c{{0, 0, 0}, Vec3::UnitZ(), 2.0};
  Search<surface::Cylinder> search;
  EXPECT_NEAR(contact(c, 1.0, flat, Vec3(3, 0, 0), Vec3::UnitZ(), search).gap, 0.75, 1e-15);
  EXPECT_NEAR(contact(c, -1.0, flat, Vec3(1, 0, 0), Vec3::UnitZ(), search).gap, 0.75, 1e-15);
}

// A drill in a hollow that is about as steep as its point: the point is as near as the rim.
TEST(Contact, PointOfADrillInAHollow) {
  const Profile drill = *makeProfile(std::vector<double>{1, 0, 0, 0, 30, 0, 4});
  const surface::Cylinder hollow{Vec3(0, 0, 9), Vec3::UnitY(), 9.0};
  const double rise = 0.5 * std::tan(std::numbers::pi / 6);
  for (double z = 0.8; z < 1.2; z += 0.02) {
    Search<surface::Cylinder> search;
    const Contact c = contact(hollow, -1.0, drill, Vec3(-4, 0.3, z), Vec3::UnitZ(), search);
    const double point = 9.0 - std::hypot(4.0, 9.0 - z);
    const double rim = 9.0 - std::hypot(4.5, 9.0 - z - rise);
    EXPECT_NEAR(c.gap, std::min(point, rim), 1e-12) << z;
  }
}

// The flat end over the tip of a cone: level where it covers the tip, and steep as the cone inside.
TEST(Contact, CornerOverTheTipOfACone) {
  const Profile bullNose = *makeProfile(std::vector<double>{3.0, 0.5});
  const surface::Cone cone{Vec3::Zero(), -Vec3::UnitZ(), 0.96, 0.28};
  Search<surface::Cone> search;
  const Contact c = contact(cone, 1.0, bullNose, {-1.3, 0, -0.2}, Vec3::UnitZ(), search);
  EXPECT_NEAR(c.gap, -0.028, 1e-14);
  EXPECT_LT((c.point - Vec3(0, 0, -0.1)).norm(), 1e-14);
  EXPECT_LT((c.normal - 0.35 * Vec3(-0.6, 0, 0.8)).norm(), 1e-13);
}
TEST(Contact, FlatEndOverTheTipOfACone) {
  const Profile flat = *makeProfile(std::vector<double>{1});
  const surface::Cone cone{Vec3::Zero(), -Vec3::UnitZ(), 0.5, std::sqrt(0.75)};
  for (double x = -0.39; x < 0.4; x += 0.03) {
    Search<surface::Cone> search;
    for (const double z : {0.01, -0.01}) {
      const Contact c = contact(cone, 1.0, flat, Vec3(x, 0.3, z), Vec3::UnitZ(), search);
      EXPECT_NEAR(c.gap, z > 0.0 ? z : z * cone.sinHalf, 1e-12) << x << " " << z;
    }
  }
}

}  // namespace
}  // namespace arelem::tool
