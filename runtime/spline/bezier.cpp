#include "runtime/spline/bezier.h"

#include <algorithm>
#include <cmath>

namespace arelem::spline {

namespace {
/// Nodes and weights of five-point Gauss quadrature on (0, 1).
struct GaussNode {
  double place;
  double weight;
};
constexpr std::array gauss = {GaussNode{0.04691007703066802, 0.11846344252809454},
                              GaussNode{0.23076534494715845, 0.23931433524968324},
                              GaussNode{0.5, 0.28444444444444444},
                              GaussNode{0.76923465505284155, 0.23931433524968324},
                              GaussNode{0.95308992296933198, 0.11846344252809454}};
}  // namespace

double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double square = along.squaredNorm();
  const double s = square > 0.0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (p - a - s * along).norm();
}

Vec3 Bezier::at(double t) const {
  const double s = (t - begin) / (end - begin);
  const double r = 1.0 - s;
  return r * r * r * control[0] + 3.0 * r * r * s * control[1] + 3.0 * r * s * s * control[2] +
         s * s * s * control[3];
}

double Bezier::curvature(double t) const {
  const double s = (t - begin) / (end - begin);
  const double r = 1.0 - s;
  const Vec3 a = control[1] - control[0];
  const Vec3 b = control[2] - control[1];
  const Vec3 c = control[3] - control[2];
  const Vec3 first = 3.0 * (r * r * a + 2.0 * r * s * b + s * s * c);
  const Vec3 second = 6.0 * (r * (b - a) + s * (c - b));
  const double square = first.squaredNorm();
  return square > 0.0 ? first.cross(second).norm() / (square * std::sqrt(square)) : 0.0;
}

std::pair<Bezier, Bezier> Bezier::halves() const {
  const Vec3 a = 0.5 * (control[0] + control[1]);
  const Vec3 b = 0.5 * (control[1] + control[2]);
  const Vec3 c = 0.5 * (control[2] + control[3]);
  const Vec3 ab = 0.5 * (a + b);
  const Vec3 bc = 0.5 * (b + c);
  const Vec3 middle = 0.5 * (ab + bc);
  const double half = 0.5 * (begin + end);
  return {Bezier{{control[0], a, ab, middle}, begin, half},
          Bezier{{middle, bc, c, control[3]}, half, end}};
}

Bezier Bezier::part(double from, double to) const {
  const double a = (from - begin) / (end - begin);
  const double b = (to - begin) / (end - begin);
  // The polar form of the curve at three parameters.
  const auto polar = [&](double u, double v, double w) {
    const auto mix = [](const Vec3& p, const Vec3& q, double s) {
      return Vec3((1.0 - s) * p + s * q);
    };
    const Vec3 p = mix(control[0], control[1], u);
    const Vec3 q = mix(control[1], control[2], u);
    const Vec3 r = mix(control[2], control[3], u);
    return mix(mix(p, q, v), mix(q, r, v), w);
  };
  return {{polar(a, a, a), polar(a, a, b), polar(a, b, b), polar(b, b, b)}, from, to};
}

double Bezier::chordBound() const {
  return std::max(distanceToSegment(control[1], control[0], control[3]),
                  distanceToSegment(control[2], control[0], control[3]));
}

double Bezier::hullRadius() const {
  double most = 0.0;
  for (const Vec3& p : control) {
    most = std::max(most, p.norm());
  }
  return most;
}

double Bezier::length() const {
  const Vec3 a = control[1] - control[0];
  const Vec3 b = control[2] - control[1];
  const Vec3 c = control[3] - control[2];
  double sum = 0.0;
  for (const GaussNode& node : gauss) {
    const double s = node.place;
    const double r = 1.0 - s;
    sum += node.weight * (r * r * a + 2.0 * r * s * b + s * s * c).norm();
  }
  return 3.0 * sum;
}

double hullOfHalves(const Bezier& piece, int halvings) {
  if (halvings == 0) {
    return piece.hullRadius();
  }
  const auto [left, right] = piece.halves();
  return std::max(hullOfHalves(left, halvings - 1), hullOfHalves(right, halvings - 1));
}

double startCurvatureInPlane(const std::array<Vec3, 4>& control) {
  const Vec3 leg = control[1] - control[0];
  const Vec3 next = control[2] - control[0];
  const double a = leg.norm();
  const double h = (leg.x() * next.y() - leg.y() * next.x()) / a;
  return 2.0 / 3.0 * h / (a * a);
}

}  // namespace arelem::spline
