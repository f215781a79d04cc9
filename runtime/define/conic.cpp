// ELLIPS, HYPERB, GCONIC and QADRIC definitions.
#include <cmath>

#include <Eigen/Eigenvalues>

#include "ir/diag/geometry.h"
#include "runtime/define/planar.h"
#include "runtime/define/resolve.h"
#include "runtime/geometry/angle.h"

namespace arelem::define {

namespace {
/// a x^2 + b y^2 + d + 2h xy + 2p x + 2q y = 0 in the canonical order.
struct PlaneConic {
  double a = 0.0, b = 0.0, d = 0.0, h = 0.0, p = 0.0, q = 0.0;
  [[nodiscard]] geometry::Canon canon() const { return {a, b, 0.0, d, 0.0, 0.0, h, p, q, 0.0}; }
};

/// Eigenvalues at most this share of the largest one are 0, and the last component of a unit vector
/// at most the other: a direction, and no place. Dimensionless.
constexpr double nullShare = 1e-13;
constexpr double atInfinity = 1e-14;

/// True where no place satisfies the equation of a quadric: its form in (x, y, z, 1) has one sign,
/// and is 0 for directions only.
bool isEmpty(const geometry::Canon& k) {
  Eigen::Matrix4d form;
  form << k[0], k[6], k[5], k[7],  //
      k[6], k[1], k[4], k[8],      //
      k[5], k[4], k[2], k[9],      //
      k[7], k[8], k[9], k[3];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(form);
  const Eigen::Vector4d values = solver.eigenvalues();
  const double null = nullShare * values.cwiseAbs().maxCoeff();
  if ((values.array() > null).any() && (values.array() < -null).any()) {
    return false;
  }
  for (int i = 0; i < values.size(); ++i) {
    if (std::abs(values[i]) <= null && std::abs(solver.eigenvectors()(3, i)) > atInfinity) {
      return false;
    }
  }
  return true;
}

/// The quadric itself, if it has places at all.
Result<Resolved> withPlaces(geometry::Canon canon) {
  if (isEmpty(canon)) {
    return fail(diag::BadConic, "these coefficients", "no place satisfies the equation");
  }
  return Resolved(std::move(canon));
}

/// With U = (x-x0) c + (y-y0) s and V = (y-y0) c - (x-x0) s: b^2 U^2 + a^2 V^2 - a^2 b^2 = 0 is the
/// ellipse; the hyperbola has -a^2 V^2 in place of +a^2 V^2. `signedA2` is a^2 or -a^2.
Result<Resolved> centered(const Arguments& given, double sign) {
  const double halfA = given.scalar(2);
  const double halfB = given.scalar(3);
  for (const double half : {halfA, halfB}) {
    if (!(half > 0.0)) {
      return fail(diag::BadRange, "a half axis", half, "greater than 0");
    }
  }
  const auto [s, c] = geometry::sinCosDegrees(given.scalar(4));
  const geometry::Vec2 center = given.pointInXy(1);
  const double a2 = halfA * halfA;
  const double b2 = halfB * halfB;
  const double v2 = sign * a2;
  const double u0 = center.x() * c + center.y() * s;
  const double v0 = center.y() * c - center.x() * s;
  return Resolved(PlaneConic{b2 * c * c + v2 * s * s, b2 * s * s + v2 * c * c,
                             b2 * u0 * u0 + v2 * v0 * v0 - a2 * b2, s * c * (b2 - v2),
                             v2 * s * v0 - b2 * c * u0, -(b2 * s * u0) - v2 * c * v0});
}

/// y = P x + Q +- sqrt(R x^2 + S x + T).
PlaneConic functionOfX(const Arguments& given) {
  const double p = given.scalar(0), q = given.scalar(1), r = given.scalar(2);
  const double s = given.scalar(3), t = given.scalar(4);
  return {p * p - r, 1.0, q * q - t, -p, (2.0 * p * q - s) / 2.0, -q};
}
}  // namespace

Result<Resolved> ellipse(const Arguments& given) {
  return centered(given, 1.0);
}

Result<Resolved> hyperbola(const Arguments& given) {
  return centered(given, -1.0);
}

Result<Resolved> conicOfSixCoefficients(const Arguments& given) {
  const double a = given.scalar(0), b = given.scalar(1), c = given.scalar(2);
  const double d = given.scalar(3), e = given.scalar(4), f = given.scalar(5);
  if (a == 0.0 && b == 0.0 && c == 0.0 && d == 0.0 && e == 0.0) {
    return fail(diag::BadConic, "these coefficients", "no power of x or y is left");
  }
  return withPlaces(PlaneConic{a, c, f, b / 2.0, d / 2.0, e / 2.0}.canon());
}

Result<Resolved> conicAsFunctionOfX(const Arguments& given) {
  return Resolved(functionOfX(given));
}

Result<Resolved> conicAsFunctionOfY(const Arguments& given) {
  PlaneConic conic = functionOfX(given);
  std::swap(conic.a, conic.b);
  std::swap(conic.p, conic.q);
  return Resolved(conic);
}

Result<Resolved> quadricOfCoefficients(const Arguments& given) {
  const Vec3 squares = given.triple(0);
  const Vec3 products = given.triple(3) / 2.0;
  const Vec3 linear = given.triple(6) / 2.0;
  if (squares.isZero(0.0) && products.isZero(0.0) && linear.isZero(0.0)) {
    return fail(diag::BadConic, "these coefficients", "no power of x, y or z is left");
  }
  return withPlaces({squares.x(), squares.y(), squares.z(), given.scalar(9), products.x(),
                     products.y(), products.z(), linear.x(), linear.y(), linear.z()});
}

}  // namespace arelem::define
