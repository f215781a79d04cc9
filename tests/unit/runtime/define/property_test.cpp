// Laws of definitions over seeded random inputs.
#include <cmath>
#include <random>

#include "runtime/geometry/shapes.h"
#include "tests/unit/runtime/define/forms.h"

namespace arelem::define::test {
namespace {

using geometry::Circle;
using geometry::Line;
using geometry::Vec2;

constexpr int rounds = 400;
constexpr double allowance = 1e-10;  // relative to coordinates of size 10

class Laws : public testing::Test {
 protected:
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec2 place() { return {number(-10, 10), number(-10, 10)}; }
  EntityPtr randomPoint() {
    const Vec2 p = place();
    return point(p.x(), p.y());
  }
  EntityPtr randomLine() { return definedPtr(T::line, {randomPoint(), randomPoint()}); }
  EntityPtr randomCircle() {
    return definedPtr(T::circle, {number(-10, 10), number(-10, 10), number(0.5, 4)});
  }
  Word oneOf(std::initializer_list<Word> words) {
    return *(words.begin() +
             std::uniform_int_distribution<int>(0, static_cast<int>(words.size()) - 1)(random_));
  }
  Word side() { return oneOf({W::XLARGE, W::XSMALL, W::YLARGE, W::YSMALL}); }
  Word hand() { return oneOf({W::LEFT, W::RIGHT}); }

  std::mt19937_64 random_{20241121};
};

Vec2 at(const Entity& p) {
  return {p.canon[0], p.canon[1]};
}
Line lineOf(const EntityPtr& e) {
  return Line::of(e->canon);
}
Circle circleOf(const EntityPtr& e) {
  return Circle::of(e->canon);
}

double fromCircle(const Vec2& p, const Circle& c) {
  return std::abs((p - c.middle()).norm() - c.radius);
}

TEST_F(Laws, IntersectionsLieOnBothCurves) {
  int met = 0;
  for (int i = 0; i < rounds; ++i) {
    const EntityPtr l = randomLine(), m = randomLine(), c = randomCircle(), d = randomCircle();
    if (const auto p = define(T::point, P{W::INTOF, l, m}, {})) {
      const double size = std::max(10.0, at(*p).norm());
      EXPECT_NEAR(lineOf(l).height(at(*p)), 0.0, allowance * size);
      EXPECT_NEAR(lineOf(m).height(at(*p)), 0.0, allowance * size);
    }
    if (const auto p = define(T::point, P{side(), W::INTOF, l, c}, {})) {
      EXPECT_NEAR(lineOf(l).height(at(*p)), 0.0, 10 * allowance);
      EXPECT_NEAR(fromCircle(at(*p), circleOf(c)), 0.0, 10 * allowance);
      ++met;
    }
    if (const auto p = define(T::point, P{side(), W::INTOF, c, d}, {})) {
      EXPECT_NEAR(fromCircle(at(*p), circleOf(c)), 0.0, 10 * allowance);
      EXPECT_NEAR(fromCircle(at(*p), circleOf(d)), 0.0, 10 * allowance);
      ++met;
    }
  }
  EXPECT_GT(met, rounds / 4);
}

TEST_F(Laws, ModifiersOrderTheCandidates) {
  for (int i = 0; i < rounds; ++i) {
    const EntityPtr l = randomLine(), c = randomCircle();
    const auto of = [&](Word w) { return define(T::point, P{w, W::INTOF, l, c}, {}); };
    if (auto large = of(W::XLARGE)) {
      EXPECT_GE(at(*large).x(), at(*of(W::XSMALL)).x());
      EXPECT_GE(at(*of(W::YLARGE)).y(), at(*of(W::YSMALL)).y());
    }
  }
}

TEST_F(Laws, PointsOfConicsSatisfyTheirEquations) {
  int met = 0;
  for (int i = 0; i < rounds; ++i) {
    const EntityType type = i % 2 == 0 ? T::ellipse : T::hyperbola;
    const EntityPtr conic =
        definedPtr(type, {W::CENTER, randomPoint(), number(1, 5), number(1, 5), number(-180, 180)});
    const EntityPtr l = randomLine();
    if (const auto p = define(T::point, P{side(), W::INTOF, l, conic}, {})) {
      const auto q = geometry::Quadric::of(conic->canon);
      const Vec3 x(at(*p).x(), at(*p).y(), 0.0);
      const double distance = std::abs(q.value(x)) / q.gradient(x).norm();
      EXPECT_NEAR(distance, 0.0, 1e-9 * std::max(10.0, x.norm()));
      EXPECT_NEAR(lineOf(l).height(at(*p)), 0.0, allowance * std::max(10.0, x.norm()));
      ++met;
    }
  }
  EXPECT_GT(met, rounds / 4);
}

TEST_F(Laws, TangentLinesTouchOnTheNamedSide) {
  int touched = 0;
  for (int i = 0; i < rounds; ++i) {
    const EntityPtr p = randomPoint(), c = randomCircle(), d = randomCircle();
    const Word h = hand(), k = hand();
    if (const auto l = define(T::line, P{p, h, W::TANTO, c}, {})) {
      const Line line = Line::of(l->canon);
      EXPECT_NEAR(line.height(at(*p)), 0.0, 10 * allowance);
      EXPECT_NEAR(line.height(circleOf(c).middle()), circleOf(c).radius, 10 * allowance);
      const Vec2 look = circleOf(c).middle() - at(*p);
      const Vec2 touch = -circleOf(c).radius * line.normal;  // from the center
      EXPECT_EQ(look.x() * touch.y() - look.y() * touch.x() > 0.0, h == W::LEFT);
      ++touched;
    }
    if (const auto l = define(T::line, P{h, W::TANTO, c, k, W::TANTO, d}, {})) {
      const Line line = Line::of(l->canon);
      EXPECT_NEAR(std::abs(line.height(circleOf(c).middle())), circleOf(c).radius, 10 * allowance);
      EXPECT_NEAR(line.height(circleOf(d).middle()), circleOf(d).radius, 10 * allowance);
      EXPECT_EQ(line.height(circleOf(c).middle()) > 0.0, h == k);
      ++touched;
    }
  }
  EXPECT_GT(touched, rounds);
}

TEST_F(Laws, TangentCirclesTouch) {
  int touched = 0;
  for (int i = 0; i < rounds; ++i) {
    const EntityPtr l = randomLine(), m = randomLine(), c = randomCircle(), d = randomCircle(),
                    p = randomPoint();
    const double r = number(0.2, 3);
    const auto touchesLine = [&](const Entity& e, const EntityPtr& line) {
      EXPECT_NEAR(std::abs(lineOf(line).height(at(e))), r,
                  allowance * std::max(10.0, at(e).norm()));
      ++touched;
    };
    const auto touchesCircle = [&](const Entity& e, const EntityPtr& circle, bool inside) {
      const double apart = (at(e) - circleOf(circle).middle()).norm();
      EXPECT_NEAR(apart,
                  inside ? std::abs(circleOf(circle).radius - r) : circleOf(circle).radius + r,
                  10 * allowance);
      ++touched;
    };
    if (const auto e = define(T::circle, P{side(), l, side(), m, W::RADIUS, r}, {})) {
      touchesLine(*e, l);
      touchesLine(*e, m);
    }
    if (const auto e = define(T::circle, P{W::TANTO, l, side(), p, W::RADIUS, r}, {})) {
      touchesLine(*e, l);
      EXPECT_NEAR((at(*e) - at(*p)).norm(), r, 10 * allowance);
    }
    const Word how = oneOf({W::IN, W::OUT}), other = oneOf({W::IN, W::OUT});
    if (const auto e = define(T::circle, P{side(), l, side(), how, c, W::RADIUS, r}, {})) {
      touchesLine(*e, l);
      touchesCircle(*e, c, how == W::IN);
    }
    if (const auto e = define(T::circle, P{side(), how, c, other, d, W::RADIUS, r}, {})) {
      touchesCircle(*e, c, how == W::IN);
      touchesCircle(*e, d, other == W::IN);
    }
  }
  EXPECT_GT(touched, rounds);
}

TEST_F(Laws, RimPointsLieOnTheCircle) {
  for (int i = 0; i < rounds; ++i) {
    const EntityPtr p = randomPoint(), q = randomPoint(), r = randomPoint();
    const Entity c = defined(T::circle, {p, q, r});
    for (const EntityPtr& x : {p, q, r}) {
      EXPECT_NEAR(fromCircle(at(*x), Circle::of(c.canon)), 0.0, 1e-9 * std::max(10.0, c.canon[6]));
    }
  }
}

TEST_F(Laws, FivePointConicsTakeTheirPoints) {
  for (int i = 0; i < rounds; ++i) {
    std::vector<EntityPtr> p;
    for (int k = 0; k < 5; ++k) {
      p.push_back(randomPoint());
    }
    const auto conic = define(T::lconic, P{W::W_5PT, p[0], p[1], p[2], p[3], p[4]}, {});
    if (!conic) {
      continue;
    }
    const auto q = geometry::Quadric::of(conic->canon);
    const double size = q.matrix.cwiseAbs().maxCoeff() * 100.0;
    for (const EntityPtr& x : p) {
      EXPECT_NEAR(q.value({at(*x).x(), at(*x).y(), 0.0}) / size, 0.0, 1e-10);
    }
  }
}

/// A definition by two entities, one modifier of each kind, moved by a rotation and shift: the
/// moved inputs give the moved result. LEFT and RIGHT do not refer to axes, so they may stay.
TEST_F(Laws, RigidMotionOfInputsMovesResults) {
  for (int i = 0; i < rounds; ++i) {
    const EntityPtr m = definedPtr(
        T::matrix, {W::XYROT, number(-180, 180), W::TRANSL, number(-9, 9), number(-9, 9)});
    const auto moved = [&](const EntityPtr& e) {
      return std::make_shared<const Entity>(
          *transformed(*e, std::span<const double, 12>(m->canon)));
    };
    const EntityPtr p = randomPoint(), c = randomCircle(), d = randomCircle();
    const Word h = hand(), k = hand();
    const auto before = define(T::line, P{h, W::TANTO, c, k, W::TANTO, d}, {});
    const auto behind = define(T::line, P{h, W::TANTO, moved(c), k, W::TANTO, moved(d)}, {});
    ASSERT_EQ(before.ok(), behind.ok());
    if (before) {
      expectCanon(behind->canon, moved(std::make_shared<const Entity>(*before))->canon, 1e-9);
    }
    const Entity q = defined(T::circle, {W::CENTER, p, W::LARGE, W::TANTO, c});
    const Entity qMoved = defined(T::circle, {W::CENTER, moved(p), W::LARGE, W::TANTO, moved(c)});
    expectCanon(qMoved.canon, moved(std::make_shared<const Entity>(q))->canon, 1e-9);
  }
}

TEST_F(Laws, MirroringExchangesLeftAndRight) {
  for (int i = 0; i < rounds; ++i) {
    const EntityPtr m = definedPtr(T::matrix, {W::MIRROR, randomLine()});
    const auto moved = [&](const EntityPtr& e) {
      return std::make_shared<const Entity>(
          *transformed(*e, std::span<const double, 12>(m->canon)));
    };
    const EntityPtr p = randomPoint(), c = randomCircle();
    const auto left = define(T::line, P{p, W::LEFT, W::TANTO, c}, {});
    const auto right = define(T::line, P{moved(p), W::RIGHT, W::TANTO, moved(c)}, {});
    ASSERT_EQ(left.ok(), right.ok());
    if (left) {
      expectCanon(right->canon, moved(std::make_shared<const Entity>(*left))->canon, 1e-9);
    }
  }
}

TEST_F(Laws, ScalingScalesResults) {
  for (int i = 0; i < rounds; ++i) {
    const double s = number(0.1, 5);
    const EntityPtr m = definedPtr(T::matrix, {W::SCALE, s});
    const auto moved = [&](const EntityPtr& e) {
      return std::make_shared<const Entity>(
          *transformed(*e, std::span<const double, 12>(m->canon)));
    };
    const EntityPtr l = randomLine(), c = randomCircle();
    const double r = number(0.2, 2);
    const Word a = side(), b = side();
    const auto before = define(T::circle, P{a, l, b, W::OUT, c, W::RADIUS, r}, {});
    const auto behind =
        define(T::circle, P{a, moved(l), b, W::OUT, moved(c), W::RADIUS, s * r}, {});
    ASSERT_EQ(before.ok(), behind.ok());
    if (before) {
      expectCanon(behind->canon, moved(std::make_shared<const Entity>(*before))->canon, 1e-9);
    }
  }
}

TEST_F(Laws, InversesUndo) {
  for (int i = 0; i < rounds; ++i) {
    std::vector<double> m;
    for (int k = 0; k < 12; ++k) {
      m.push_back(number(-3, 3));
    }
    const EntityPtr matrix = make(T::matrix, m);
    const auto inverse = define(T::matrix, P{W::INVERS, matrix}, {});
    if (!inverse || std::abs(Eigen::Matrix3d(geometry::Matrix::of(m).linear).determinant()) < 0.1) {
      continue;
    }
    const Entity one = defined(T::matrix, {matrix, std::make_shared<const Entity>(*inverse)});
    expectCanon(one.canon, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, 1e-10);
  }
}

TEST_F(Laws, MovedSurfacesKeepMovedPoints) {
  for (int i = 0; i < rounds; ++i) {
    const EntityPtr axis = make(T::vector, {number(-1, 1), number(-1, 1), number(-1, 1)});
    const EntityPtr other = make(T::vector, {number(-1, 1), number(-1, 1), number(-1, 1)});
    const auto m =
        define(T::matrix, P{point(number(-5, 5), number(-5, 5), number(-5, 5)), axis, other}, {});
    ASSERT_TRUE(m.ok());
    const auto matrix = std::span<const double, 12>(m->canon);
    const Vec3 p(number(-5, 5), number(-5, 5), number(-5, 5));
    const Vec3 q = geometry::Matrix::of(m->canon).apply(p);
    const EntityPtr plane = definedPtr(T::plane, {point(p.x(), p.y(), p.z()), W::PERPTO, axis});
    EXPECT_NEAR(geometry::Plane::of(transformed(*plane, matrix)->canon).height(q), 0.0, 1e-9);
    const EntityPtr quadric =
        definedPtr(T::quadric, {1.0, 2.0, 3.0, 0.1, 0.2, 0.3, 1.0, 2.0, 3.0, number(-9, 0)});
    EXPECT_NEAR(geometry::Quadric::of(transformed(*quadric, matrix)->canon).value(q),
                geometry::Quadric::of(quadric->canon).value(p), 1e-8);
  }
}

}  // namespace
}  // namespace arelem::define::test
