#include "runtime/geometry/kinds.h"

#include <cmath>

namespace arelem::surface {

namespace {
Vec3 vec(const std::vector<double>& c, std::size_t i) { return {c[i], c[i + 1], c[i + 2]}; }

Quadric quadricOf(const std::vector<double>& c) {
  Quadric q;
  q.matrix << c[0], c[6], c[5], c[6], c[1], c[4], c[5], c[4], c[2];
  q.linear = vec(c, 7);
  q.constant = c[3];
  // Positive outside: turn the sign so that the far side of a closed or curved sheet is positive.
  if (q.matrix.trace() < 0.0) {
    q.matrix = -q.matrix;
    q.linear = -q.linear;
    q.constant = -q.constant;
  }
  q.wall = q.generatrix();
  return q;
}

/// Highest and lowest offset of a piece over its chord.
void setRange(TabulatedCylinder::Piece& p) {
  const auto height = [&](double x) { return ((p.a * x + p.b) * x + p.c) * x; };
  p.lowY = p.highY = 0.0;
  const double disc = 4.0 * p.b * p.b - 12.0 * p.a * p.c;
  if (disc < 0.0) {
    return;
  }
  const double root = std::sqrt(disc);
  const double q = -0.5 * (2.0 * p.b + (p.b < 0.0 ? -root : root));
  for (const double x : {p.a != 0.0 ? q / (3.0 * p.a) : 0.0, q != 0.0 ? p.c / q : 0.0}) {
    if (x > 0.0 && x < p.length) {
      p.lowY = std::min(p.lowY, height(x));
      p.highY = std::max(p.highY, height(x));
    }
  }
}

AnySurface tabulatedOf(const std::vector<double>& c) {
  auto curve = std::make_shared<TabulatedCylinder::Curve>();
  const auto intervals = static_cast<std::size_t>(c[0]) - 1;  // c[0] counts the points, extensions included
  curve->u = vec(c, 2);
  curve->v = vec(c, 5);
  curve->w = vec(c, 8);
  for (std::size_t i = 0; i < intervals; ++i) {
    const double* at = &c[11 + 7 * i];
    const double* next = at + 7;
    TabulatedCylinder::Piece p{};
    p.u = at[0];
    p.v = at[1];
    p.length = std::hypot(next[0] - at[0], next[1] - at[1]);
    p.dirU = (next[0] - at[0]) / p.length;
    p.dirV = (next[1] - at[1]) / p.length;
    p.a = at[2];
    p.b = at[3];
    p.c = -p.length * (p.a * p.length + p.b);
    p.openStart = i == 0;
    p.openEnd = i + 1 == intervals;
    setRange(p);
    curve->pieces.push_back(p);
  }
  return TabulatedCylinder(std::move(curve));
}

struct GeneratrixOf {
  Vec3 operator()(const Cylinder& s) const { return s.axis; }
  Vec3 operator()(const Quadric& s) const { return s.wall; }
  Vec3 operator()(const TabulatedCylinder& s) const { return s.generatrix(); }
  template <class S>
  Vec3 operator()(const S&) const {
    return Vec3::Zero();
  }
};
}  // namespace

Result<AnySurface> surfaceOf(const Entity& entity) {
  const auto& c = entity.canon;
  switch (entity.type) {
    case EntityType::line:
    case EntityType::plane:
      return AnySurface(Plane{vec(c, 0), c[3]});
    case EntityType::circle:
    case EntityType::cylinder:
      return AnySurface(Cylinder{vec(c, 0), vec(c, 3), c[6]});
    case EntityType::sphere:
      return AnySurface(Sphere{vec(c, 0), c[3]});
    case EntityType::cone:
      return AnySurface(Cone{vec(c, 0), vec(c, 3), c[6], std::sqrt(std::max(0.0, 1.0 - c[6] * c[6]))});
    case EntityType::torus:
      return AnySurface(Torus{vec(c, 0), vec(c, 3), c[6], c[7]});
    case EntityType::ellipse:
    case EntityType::hyperbola:
    case EntityType::gconic:
    case EntityType::lconic:
    case EntityType::quadric:
      return AnySurface(quadricOf(c));
    case EntityType::tabulatedCylinder:
      return tabulatedOf(c);
    default:
      return fail(diag::NotASurface, spell(entity.type));
  }
}

Vec3 generatrix(const AnySurface& surface) { return std::visit(GeneratrixOf{}, surface); }

}  // namespace arelem::surface
