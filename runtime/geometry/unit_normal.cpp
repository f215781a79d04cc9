#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/geometry/directed_distance.h"

namespace arelem::geometry {

namespace {
std::optional<Vec3> normalized(const Vec3& v) {
  const double length = v.norm();
  return length > 0.0 ? std::optional<Vec3>(v / length) : std::nullopt;
}
}  // namespace

Vec3 unitNormal(const Plane& plane, const Vec3&) {
  return plane.normal.normalized();
}

std::optional<Vec3> unitNormal(const Sphere& sphere, const Vec3& place) {
  return normalized(place - sphere.center);
}

std::optional<Vec3> unitNormal(const Cylinder& cylinder, const Vec3& place) {
  const Vec3 w = place - cylinder.point;
  return normalized(w - w.dot(cylinder.axis) * cylinder.axis);
}

std::optional<Vec3> unitNormal(const Cone& cone, const Vec3& place) {
  // The unit vector across the axis in the plane of axis and place, turned back by the half angle
  // a: n = cos a e - sin a T, which is UNCON's (cos a U - cos(th - a) T)/sin th written without the
  // division. Where the place is behind the vertex (th - a beyond 90 degrees) there is no normal.
  const Vec3 w = place - cone.vertex;
  const std::optional<Vec3> across = normalized(w - w.dot(cone.axis) * cone.axis);
  const double sine = std::sqrt((1.0 - cone.cosine) * (1.0 + cone.cosine));
  if (!across || w.dot(cone.cosine * cone.axis + sine * *across) < 0.0) {
    return std::nullopt;
  }
  return cone.cosine * *across - sine * cone.axis;
}

std::optional<Vec3> unitNormal(const Quadric& quadric, const Vec3& place) {
  return normalized(quadric.gradient(place));
}

std::optional<Vec3> unitNormal(const TabulatedCylinder& surface, const Vec3& place) {
  const Nearest nearest = nearestOn(surface, surface.projected(place));
  const Vec2 tangent = surface.intervals[nearest.interval].at(nearest.t).tangent;
  return normalized(surface.inSpace({-tangent.y(), tangent.x()}));
}

std::optional<Vec3> unitNormal(const Torus& torus, const Vec3& place) {
  const Vec3 w = place - torus.center;
  const std::optional<Vec3> across = normalized(w - w.dot(torus.axis) * torus.axis);
  return across ? normalized(w - torus.major * *across) : std::nullopt;
}

namespace {
/// Calls `use` with the typed view of a surface; returns `otherwise` for types without one.
template <class Use, class Other>
auto visitSurface(const Entity& entity, Use use, Other otherwise) {
  const std::span<const double> canon = entity.canon;
  switch (entity.type) {
    case EntityType::line:
    case EntityType::plane:
      return use(Plane::of(canon));
    case EntityType::circle:
    case EntityType::cylinder:
      return use(Cylinder::of(canon));
    case EntityType::cone:
      return use(Cone::of(canon));
    case EntityType::sphere:
      return use(Sphere::of(canon));
    case EntityType::torus:
      return use(Torus::of(canon));
    case EntityType::ellipse:
    case EntityType::hyperbola:
    case EntityType::gconic:
    case EntityType::lconic:
    case EntityType::quadric:
      return use(Quadric::of(canon));
    case EntityType::tabulatedCylinder:
      return use(TabulatedCylinder::of(canon));
    case EntityType::point:
    case EntityType::vector:
    case EntityType::matrix:
    case EntityType::polyconic:
    case EntityType::pattern:
    case EntityType::mesh:
    case EntityType::gun:
    case EntityType::region:
    case EntityType::revolved:
    case EntityType::ruledSurface:
    case EntityType::pathSpline:
      break;
  }
  return otherwise();
}
}  // namespace

std::optional<double> directedDistance(const Entity& surface,
                                       const Vec3& from,
                                       const Vec3& direction,
                                       Crossing which) {
  return visitSurface(
      surface, [&](const auto& shape) { return directedDistance(shape, from, direction, which); },
      [] { return std::optional<double>{}; });
}

std::optional<Vec3> unitNormal(const Entity& surface, const Vec3& place) {
  return visitSurface(
      surface, [&](const auto& shape) { return std::optional<Vec3>(unitNormal(shape, place)); },
      [] { return std::optional<Vec3>{}; });
}

}  // namespace arelem::geometry
