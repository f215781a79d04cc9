#include "runtime/geometry/apart.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/kinds.h"
#include "runtime/geometry/shapes.h"
#include "runtime/spline/cubic.h"

namespace arelem::geometry {

namespace {
/// What distances have closed forms for: a sphere of radius 0 is a point.
struct Ball {
  Vec3 center;
  double radius;
};
using Shape = std::variant<Ball, Plane, Cylinder>;

std::optional<Shape> shapeOf(const Entity& entity) {
  switch (entity.type) {
    case EntityType::point:
      return Ball{Point::of(entity.canon).at, 0.0};
    case EntityType::sphere: {
      const Sphere sphere = Sphere::of(entity.canon);
      return Ball{sphere.center, sphere.radius};
    }
    case EntityType::line:
    case EntityType::plane:
      return Plane::of(entity.canon);
    case EntityType::circle:
    case EntityType::cylinder:
      return Cylinder::of(entity.canon);
    default:
      return std::nullopt;
  }
}

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

Apart between(const Vec3& from, const Vec3& to) {
  return {(to - from).norm(), true, from, to, ""};
}

Apart crossing(double sine) {
  Apart result;
  result.remark =
      fmt::format("they cross at {:.6g} degrees", degrees(std::asin(std::min(1.0, sine))));
  return result;
}

/// From a place to the surface `distance` away along `-normal`; the ball round the place reaches
/// `radius` far.
Apart toSurface(const Ball& ball, double distance, const Vec3& normal) {
  const Vec3 foot = ball.center - distance * normal;
  if (ball.radius <= 0.0) {
    Apart result = between(ball.center, foot);
    result.remark = distance < 0.0 ? "on the negative side" : "";
    return result;
  }
  if (std::abs(distance) <= ball.radius) {
    Apart result;
    const double overlap = ball.radius - std::abs(distance);
    result.remark = overlap <= tolerance::coincidence
                        ? "they touch"
                        : fmt::format("they overlap by {:.9g}", overlap);
    return result;
  }
  return between(ball.center - std::copysign(ball.radius, distance) * normal, foot);
}

Apart of(const Ball& a, const Ball& b) {
  const Vec3 way = b.center - a.center;
  const double length = way.norm();
  const double gap = length - a.radius - b.radius;
  if (gap > 0.0) {
    const Vec3 unit = way / length;
    return between(a.center + a.radius * unit, b.center - b.radius * unit);
  }
  Apart result;
  const double within = std::abs(a.radius - b.radius) - length;
  result.distance = std::max(0.0, within);
  result.remark = a.radius == 0.0 && b.radius == 0.0 ? ""
                  : within > 0.0                     ? "one lies inside the other"
                                                     : "they cut each other";
  return result;
}

Apart of(const Ball& ball, const Plane& plane) {
  return toSurface(ball, plane.height(ball.center), plane.normal);
}

Apart of(const Ball& ball, const Cylinder& cylinder) {
  const Vec3 along = cylinder.axis.dot(ball.center - cylinder.point) * cylinder.axis;
  const Vec3 out = ball.center - cylinder.point - along;
  const double length = out.norm();
  const Vec3 normal =
      length > tolerance::nullDirection ? Vec3(out / length) : cylinder.axis.unitOrthogonal();
  Apart result = toSurface(ball, length - cylinder.radius, normal);
  if (result.remark == "on the negative side") {
    result.remark = "inside";
  }
  return result;
}

Apart of(const Plane& a, const Plane& b) {
  const double sine = a.normal.cross(b.normal).norm();
  if (sine > tolerance::coincidence) {
    return crossing(sine);
  }
  const Vec3 from = a.distance * a.normal;
  return between(from, from - b.height(from) * b.normal);
}

Apart of(const Plane& plane, const Cylinder& cylinder) {
  const double sine = std::abs(plane.normal.dot(cylinder.axis));
  if (sine > tolerance::coincidence) {
    return crossing(sine);
  }
  return of(Ball{cylinder.point, cylinder.radius}, plane);
}

Apart of(const Cylinder& a, const Cylinder& b) {
  const Vec3 cross = a.axis.cross(b.axis);
  const double sine = cross.norm();
  const Vec3 way = b.point - a.point;
  const bool parallel = sine <= tolerance::coincidence;
  const double axes =
      parallel ? (way - way.dot(a.axis) * a.axis).norm() : std::abs(way.dot(cross)) / sine;
  Apart result;
  const double gap = axes - a.radius - b.radius;
  const double within = std::abs(a.radius - b.radius) - axes;
  if (gap > 0.0) {
    result.distance = gap;
  } else if (parallel && within > 0.0) {
    result.distance = within;
    result.remark = "one lies inside the other";
  } else {
    result.remark = "they cut each other";
  }
  return result;
}

/// The general surface below a point or a sphere.
std::optional<Apart> toAny(const Ball& ball, const Entity& entity) {
  const Result<surface::AnySurface> surface = surface::surfaceOf(entity);
  if (!surface) {
    return std::nullopt;
  }
  const surface::Foot foot = std::visit(
      [&](const auto& s) {
        typename std::decay_t<decltype(s)>::Hint hint;
        return s.foot(ball.center, hint);
      },
      *surface);
  return toSurface(ball, foot.distance, foot.normal);
}

/// From a point to the place of a path spline next to it.
std::optional<Apart> toCurve(const Ball& ball, const Entity& entity) {
  if (entity.type != EntityType::pathSpline || ball.radius > 0.0) {
    return std::nullopt;
  }
  const Result<spline::CubicSpline> curve = spline::CubicSpline::of(entity.canon);
  return curve ? std::optional(between(ball.center, curve->nearest(ball.center).point))
               : std::nullopt;
}

/// The general surface, or the curve, below a point or a sphere.
std::optional<Apart> toOther(const Ball& ball, const Entity& entity) {
  const std::optional<Apart> curve = toCurve(ball, entity);
  return curve ? curve : toAny(ball, entity);
}

template <class A, class B>
Apart inOrder(const A& a, const B& b) {
  if constexpr (requires { of(a, b); }) {
    return of(a, b);
  } else {
    Apart result = of(b, a);
    std::swap(result.from, result.to);
    return result;
  }
}
}  // namespace

Result<Apart> apart(const Entity& first, const Entity& second) {
  const std::optional<Shape> a = shapeOf(first);
  const std::optional<Shape> b = shapeOf(second);
  if (a && b) {
    return std::visit([](const auto& x, const auto& y) { return inOrder(x, y); }, *a, *b);
  }
  if (a && std::holds_alternative<Ball>(*a)) {
    if (const auto result = toOther(std::get<Ball>(*a), second)) {
      return *result;
    }
  } else if (b && std::holds_alternative<Ball>(*b)) {
    if (auto result = toOther(std::get<Ball>(*b), first)) {
      std::swap(result->from, result->to);
      return *result;
    }
  }
  return fail(diag::NoDistance, spell(first.type), spell(second.type));
}

}  // namespace arelem::geometry
