#include "runtime/geometry/kinds/quadric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Dense>

#include "ir/space/tolerance.h"

namespace arelem::surface {

namespace {
constexpr int newtonLimit = 40;
constexpr int searchLimit = 200;
/// An eigenvalue of at most this share of the largest is rounding.
constexpr double rounding = 1e-14;
/// This near to the medial axis a place is on it, as a share of its coordinates.
constexpr double amidst = 1e-14;
/// A share of what is solved for that changes by this much is found, like a foot below.
constexpr double lastShare = 1e-8;
/// Newton over the multiplier keeps this far from the ends of its interval, as a share of it.
constexpr double nearEnd = 0.05;
/// A foot that moves by this share of its coordinates is found: Newton's next step is the square of
/// that.
constexpr double lastMove = 1e-9;
/// Limit of 1 / d^2, and how fast it is looked for where its interval is open.
constexpr double mostPole = 1e60, farther = 16.0;
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

namespace {
/// F along the curve of feet q(m), in the basis of the eigenvectors.
struct FootCurve {
  Vec3 place, roots, linear;
  double constant;

  [[nodiscard]] double value(const Vec3& p) const {
    return p.dot(roots.cwiseProduct(p) + 2.0 * linear) + constant;
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
  /// The nearest foot by the 1 + 2 m root of eigenvector i, towards the end of the interval of
  /// multipliers in which it is the nearest. With d for that, F is level + pole / d^2 near the end,
  /// and as smooth in y = 1 / d^2 elsewhere: Newton on y, and by halves where that leads out. None
  /// where F keeps its sign.
  [[nodiscard]] std::optional<Vec3> towardsEnd(int i, bool ends, double m) const {
    const Vec3 ratio = roots / roots[i];
    const Vec3 fixed = (roots[i] * Vec3::Ones() - roots) / roots[i];
    const Vec3 slope = roots.cwiseProduct(place) + linear;
    const bool rising = place.dot(slope + linear) + constant > 0.0;
    double inner = 1.0;
    double outer = ends ? std::numeric_limits<double>::infinity() : 0.0;
    const auto isInside = [&](double y) {
      return ends ? y > inner && y < outer : y < inner && y > outer;
    };
    const double guess = 1.0 + 2.0 * m * roots[i];
    double y = 1.0 / (guess * guess);
    y = guess > 0.0 && isInside(y) ? y : 1.0;
    bool isFound = false;
    for (int k = 0; k < searchLimit; ++k) {
      const double d = 1.0 / std::sqrt(y);
      const Vec3 share = (fixed + d * ratio).cwiseInverse();
      const Vec3 half = slope.cwiseProduct(share);
      const Vec3 foot = place - (d - 1.0) / roots[i] * half;
      const double there = foot.dot(half + linear) + constant;
      const double squared = half.squaredNorm();
      if (isFound || !(squared > 0.0)) {
        return squared > 0.0 ? Vec3(foot - 0.5 * there / squared * half) : foot;
      }
      ((there > 0.0) == rising ? inner : outer) = y;
      const double next = y - there * roots[i] / (d * d * d * half.dot(half.cwiseProduct(share)));
      const double last = y;
      y = isInside(next) || next == y ? next : between(inner, outer);
      isFound = std::abs(y - last) <= lastShare * y || !isInside(y);
      if (!(y < mostPole && y > 1.0 / mostPole)) {
        break;
      }
    }
    return std::nullopt;
  }
  /// Where the interval of multipliers ends without a zero, p lies on the medial axis: the foot
  /// leaves along eigenvector i, whose 1 + 2 m root is 0.
  [[nodiscard]] std::optional<Vec3> onMedialAxis(int i) const {
    const Vec3 scale = (roots[i] * Vec3::Ones() - roots) / roots[i];
    Vec3 q = Vec3::Zero();
    double rest = constant;
    for (int j = 0; j < 3; ++j) {
      if (j != i) {
        const double along = roots[j] * place[j] + linear[j];
        // p is not amidst of what is as round about eigenvectors i and j.
        if (std::abs(scale[j]) <= rounding && !isAmidst(j)) {
          return std::nullopt;
        }
        q[j] = std::abs(scale[j]) <= rounding ? -linear[j] / roots[j]
                                              : place[j] + along / (scale[j] * roots[i]);
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
  /// True where p is as near to both sides of the plane square to eigenvector i.
  [[nodiscard]] bool isAmidst(int i) const {
    return std::abs(place[i] + linear[i] / roots[i]) <= amidst * (1.0 + place.norm());
  }

 private:
  /// By halves, of numbers or of their size.
  static double between(double a, double b) {
    const double low = std::min(a, b);
    const double high = std::max(a, b);
    if (!(high < mostPole)) {
      return farther * low;
    }
    return low > 0.0 ? std::sqrt(low * high) : high / farther;
  }
};

/// The nearest point, from a multiplier.
Vec3 nearest(const FootCurve& curve, double flat, double multiplier) {
  const bool rising = curve.value(curve.place) > 0.0;  // then m > 0
  const int i = rising ? 0 : 2;
  const bool ends = rising ? curve.roots[0] < -flat : curve.roots[2] > flat;
  if (const auto q = ends && curve.isAmidst(i) ? curve.onMedialAxis(i) : std::nullopt) {
    return *q;
  }
  const int by = ends ? i : 2 - i;
  auto q = std::abs(curve.roots[by]) > flat ? curve.towardsEnd(by, ends, multiplier) : std::nullopt;
  if (!q && ends) {
    q = curve.onMedialAxis(i);
  }
  // No real point: a quadric without a surface is met nowhere.
  return q ? *q : Vec3(curve.place + tolerance::farAway * Vec3::UnitZ());
}
}  // namespace

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
  hint.foot = found ? *found : nearest(curve, flat_, multiplier);
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
