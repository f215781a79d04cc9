#include "runtime/geometry/kinds/quadric.h"

#include <cmath>
#include <optional>

#include <Eigen/Dense>

#include "ir/space/tolerance.h"

namespace arelem::surface {

namespace {
constexpr int newtonLimit = 40;
constexpr int bisectionLimit = 200;
/// An eigenvalue of at most this share of the largest is rounding.
constexpr double rounding = 1e-14;
/// Slack of the test for the nearest point, which is an equality on the medial axis.
constexpr double medial = 1e-9;
/// This near to the medial axis a place is on it, as a share of its coordinates.
constexpr double amidst = 1e-14;
/// A multiplier that changes by less than this share is found.
constexpr double lastMultiplier = 1e-15;
/// Newton over the multiplier keeps this far from the ends of its interval, as a share of it.
constexpr double nearEnd = 0.05;
/// A foot that moves by this share of its coordinates is found: Newton's next step is the square of
/// that.
constexpr double lastMove = 1e-9;
/// Moves below this that get no smaller are rounding.
constexpr double settled = 1e-13;
/// Share of the gradient by which it may change for the surface to count as a graph.
constexpr double graphShare = 0.5;
}  // namespace

Quadric::Quadric(const Eigen::Matrix3d& matrix, const Vec3& linear, double constant)
    : matrix_(matrix), linear_(linear), constant_(constant) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(matrix_);
  axes_ = eigen.eigenvectors();
  roots_ = eigen.eigenvalues();
  alongAxes_ = axes_.transpose() * linear_;
  flat_ = rounding * roots_.cwiseAbs().maxCoeff();
  for (int i = 0; i < 3; ++i) {
    if (std::abs(roots_[i]) <= flat_ && std::abs(alongAxes_[i]) <= rounding * linear_.norm()) {
      wall_ = axes_.col(i);
      break;
    }
  }
}

/// Newton on q - p + m grad F(q) = 0, F(q) = 0 from a point near the surface.
Quadric::Candidate Quadric::refine(const Vec3& p, const Vec3& start) const {
  Candidate c{false, start, 0.0};
  const Vec3 first = gradient(start);
  double before = tolerance::farAway;
  c.multiplier = first.squaredNorm() > 0.0 ? (p - start).dot(first) / first.squaredNorm() : 0.0;
  for (int i = 0; i < newtonLimit; ++i) {
    const Vec3 slope = gradient(c.point);
    Eigen::Matrix4d jacobian = Eigen::Matrix4d::Zero();
    jacobian.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity() + 2.0 * c.multiplier * matrix_;
    jacobian.topRightCorner<3, 1>() = slope;
    jacobian.bottomLeftCorner<1, 3>() = slope.transpose();
    Eigen::Vector4d residual;
    residual.head<3>() = c.point - p + c.multiplier * slope;
    residual[3] = value(c.point);
    const Eigen::Vector4d step = jacobian.partialPivLu().solve(residual);
    if (!step.allFinite()) {
      return c;
    }
    c.point -= step.head<3>();
    c.multiplier -= step[3];
    const double moved = step.head<3>().norm() / (1.0 + c.point.norm());
    if (moved <= 1e-15 || (moved <= settled && moved >= 0.5 * before)) {
      c.good = isNearest(c.multiplier);
      return c;
    }
    before = moved;
  }
  return c;
}

bool Quadric::isNearest(double multiplier) const {
  return 1.0 + 2.0 * multiplier * roots_[0] >= -medial &&
         1.0 + 2.0 * multiplier * roots_[2] >= -medial;
}

namespace {
/// F along the curve of feet q(m), in the basis of the eigenvectors.
struct FootCurve {
  Vec3 place, roots, linear;
  double constant;

  [[nodiscard]] Vec3 at(double m) const {
    return (place - 2.0 * m * linear).cwiseQuotient(Vec3::Ones() + 2.0 * m * roots);
  }
  [[nodiscard]] double value(double m) const {
    const Vec3 q = at(m);
    return q.dot(roots.cwiseProduct(q)) + 2.0 * linear.dot(q) + constant;
  }
  /// The step of Newton on F there; not finite where F is level.
  [[nodiscard]] double newton(double m, double there) const {
    const Vec3 half = roots.cwiseProduct(at(m)) + linear;
    return there / (4.0 * half.dot(half.cwiseQuotient(Vec3::Ones() + 2.0 * m * roots)));
  }
  /// The zero of F between two multipliers, at the first of which it has the sign of `rising`: by
  /// Newton, and by halves where that leads out.
  [[nodiscard]] double zeroBetween(double inner, double outer, bool rising) const {
    double m = 0.5 * (inner + outer);
    for (int k = 0; k < bisectionLimit; ++k) {
      const double there = value(m);
      ((there > 0.0) == rising ? inner : outer) = m;
      const double next = m + newton(m, there);
      const bool inside = next > std::min(inner, outer) && next < std::max(inner, outer);
      const double last = m;
      m = inside ? next : 0.5 * (inner + outer);
      if (std::abs(m - last) <= lastMultiplier * std::abs(m) || m == inner || m == outer) {
        break;
      }
    }
    return m;
  }
  /// Newton on F from a multiplier. Gives up near the ends of the interval in which the foot is the
  /// nearest.
  [[nodiscard]] std::optional<Vec3> follow(double m) const {
    for (int i = 0; i < newtonLimit; ++i) {
      const Vec3 scale = Vec3::Ones() + 2.0 * m * roots;
      if (!(scale.minCoeff() > nearEnd)) {
        return std::nullopt;
      }
      const Vec3 share = scale.cwiseInverse();
      const Vec3 foot = (place - 2.0 * m * linear).cwiseProduct(share);
      const Vec3 half = roots.cwiseProduct(foot) + linear;
      const Vec3 moving = half.cwiseProduct(share);
      const double fall = 4.0 * half.dot(moving);
      if (!(fall > 0.0)) {
        return std::nullopt;
      }
      const double step = (foot.dot(half + linear) + constant) / fall;
      m += step;
      if (2.0 * std::abs(step) * moving.norm() <= lastMove * (1.0 + foot.norm())) {
        return foot - 2.0 * step * moving;
      }
    }
    return std::nullopt;
  }
  /// Where the interval of multipliers ends without a zero, p lies on the medial axis: the foot
  /// leaves along eigenvector i, whose 1 + 2 m root is 0.
  [[nodiscard]] std::optional<Vec3> onMedialAxis(int i, double m) const {
    Vec3 q = at(m);
    double rest = constant;
    for (int j = 0; j < 3; ++j) {
      if (j != i) {
        q[j] = std::isfinite(q[j]) ? q[j] : -linear[j] / roots[j];
        rest += (roots[j] * q[j] + 2.0 * linear[j]) * q[j];
      }
    }
    const double disc = linear[i] * linear[i] - roots[i] * rest;
    if (disc < 0.0) {
      return std::nullopt;
    }
    q[i] = (-linear[i] + std::sqrt(disc)) / roots[i];
    return q;
  }
};
}  // namespace

/// The nearest point by the zero of F over the multiplier.
Vec3 Quadric::search(const Vec3& p) const {
  const FootCurve curve{axes_.transpose() * p, roots_, alongAxes_, constant_};
  const bool rising = curve.value(0.0) > 0.0;  // then m > 0
  const int i = rising ? 0 : 2;
  const bool ends = rising ? roots_[0] < -flat_ : roots_[2] > flat_;
  const double end = ends ? -0.5 / roots_[i] : 0.0;
  const bool isAmidst = ends && std::abs(curve.place[i] - 2.0 * end * curve.linear[i]) <=
                                    amidst * (1.0 + curve.place.norm());
  if (const auto q = isAmidst ? curve.onMedialAxis(i, end) : std::nullopt) {
    return axes_ * *q;
  }
  // From 0 towards the end until the sign changes.
  const double first = std::abs(curve.newton(0.0, curve.value(0.0)));
  const double least = std::isfinite(first) && first > 0.0 ? first : std::ldexp(1.0, -60);
  double inner = 0.0;
  double outer = 0.0;
  for (int k = 0; k < bisectionLimit; ++k) {
    inner = outer;
    outer = ends ? end * (1.0 - std::ldexp(1.0, -1 - k)) : std::ldexp(rising ? least : -least, k);
    if ((ends && outer == end) || (curve.value(outer) > 0.0) != rising) {
      break;
    }
  }
  if ((ends && outer == end) || (curve.value(outer) > 0.0) == rising) {
    const auto q = ends ? curve.onMedialAxis(i, end) : std::nullopt;
    // No real point: a quadric without a surface is met nowhere.
    return q ? Vec3(axes_ * *q) : Vec3(p + tolerance::farAway * Vec3::UnitZ());
  }
  return axes_ * curve.at(curve.zeroBetween(inner, outer, rising));
}

Foot Quadric::foot(const Vec3& p, Hint& hint) const {
  const FootCurve curve{axes_.transpose() * p, roots_, alongAxes_, constant_};
  double multiplier = 0.0;
  if (hint.valid && hint.half > 0.0) {
    // The surface falls away from the tangent plane by t.Q t / |grad F|.
    const Vec3 way = curve.place - hint.foot;
    const double up = way.dot(hint.normal);
    const Vec3 t = way - up * hint.normal;
    const double fallen = 0.5 * t.dot(roots_.cwiseProduct(t)) / hint.half;
    multiplier = 0.5 * (up + fallen) / hint.half;
  }
  const auto found = curve.follow(multiplier);
  if (found) {
    hint.foot = *found;
  } else {
    const Vec3 near = search(p);
    const Candidate refined = refine(p, near);
    hint.foot = axes_.transpose() * (refined.good ? refined.point : near);
  }
  hint.valid = true;
  const Vec3 half = roots_.cwiseProduct(hint.foot) + alongAxes_;
  hint.half = half.norm();
  hint.normal = hint.half > 0.0 ? Vec3(half / hint.half) : Vec3(Vec3::Zero());
  return {(curve.place - hint.foot).dot(hint.normal), axes_ * hint.normal};
}

namespace {
/// The form 2 Q restricted to the plane square to the normal: its values over |grad F| are the
/// normal curvatures.
Eigen::Matrix2d acrossNormal(const Eigen::Matrix3d& matrix, const Vec3& e1, const Vec3& e2) {
  Eigen::Matrix2d form;
  form << e1.dot(matrix * e1), e1.dot(matrix * e2), e1.dot(matrix * e2), e2.dot(matrix * e2);
  return 2.0 * form;
}
}  // namespace

/// The foot moves with the place by (I + 2 m Q)^-1 (t - a grad F), with the a that keeps it on the
/// surface; the normal turns by Q times that.
Vec3 Quadric::turn(const Vec3&, const Foot& foot, const Vec3& t, Hint& hint) const {
  const double length = hint.half;
  if (!hint.valid || length <= 0.0) {
    return Vec3::Zero();
  }
  // The place is 2 m |half| from its foot. Amidst two feet the normal turns without end.
  const Vec3 closing = Vec3::Ones() + foot.distance / length * roots_;
  const Vec3 share =
      closing.unaryExpr([](double c) { return 1.0 / (std::abs(c) > rounding ? c : rounding); });
  const Vec3& normal = hint.normal;
  const Vec3 along = axes_.transpose() * t;
  const Vec3 across = along - normal.dot(along) * normal;
  const Vec3 moving = normal.cwiseProduct(share);
  const Vec3 direct = across.cwiseProduct(share);
  const Vec3 moved = direct - normal.dot(direct) / normal.dot(moving) * moving;
  const Vec3 turned = roots_.cwiseProduct(moved);
  return axes_ * (turned - normal.dot(turned) * normal) / length;
}

/// Normal curvatures of the surface within `reach` of one of its points; none where the gradient
/// turns too much there for the surface to be a graph over its tangent plane.
std::optional<Bends> Quadric::curvatures(const Vec3& at, double reach) const {
  const Vec3 slope = gradient(at);
  const double length = slope.norm();
  const double most = 2.0 * roots_.cwiseAbs().maxCoeff();
  const double change = most * reach;
  if (!(change < graphShare * length)) {
    return std::nullopt;
  }
  const Vec3 normal = slope / length;
  const Vec3 e1 = normal.unitOrthogonal();
  const Eigen::Matrix2d form = acrossNormal(matrix_, e1, normal.cross(e1));
  const double middle = 0.5 * form.trace();
  const double half = std::hypot(0.5 * (form(0, 0) - form(1, 1)), form(0, 1));
  // A tangent plane turned by an angle a changes a value of the form by at most 2 a |2Q|.
  const double turned = 2.0 * most * change / (length - change);
  const double low = middle - half - turned;
  const double high = middle + half + turned;
  return Bends{low / (length + (low < 0.0 ? -change : change)),
               high / (length + (high > 0.0 ? -change : change))};
}

Bends Quadric::bends(const Vec3& p, const Foot& foot, double radius) const {
  Bends b = bendsOfAnySet(foot.distance, radius);
  const double away = std::abs(foot.distance);
  // Feet of all places within the radius lie within 2 (away + radius) of the foot.
  if (const auto range = curvatures(p - foot.distance * foot.normal, 2.0 * (away + radius))) {
    // Two feet of one place would have a place between them where the curvature reaches 1 over the
    // distance.
    const double sharpest = std::max(std::abs(range->low), std::abs(range->high));
    b = both(
        b, bendsOfCurvature(*range, foot.distance, radius, sharpest * (away + 3.0 * radius) < 1.0));
  }
  if (isConvex()) {
    b.low = std::max(b.low, 0.0);
  }
  return b;
}

}  // namespace arelem::surface
