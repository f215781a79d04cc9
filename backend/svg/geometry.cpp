#include "backend/svg/geometry.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

#include "backend/svg/conic.h"
#include "backend/text/clean.h"
#include "ir/space/picture_tolerance.h"

namespace arelem::backend::svg {

namespace {
constexpr std::string_view geometryClass = "class=\"geometry\"";
constexpr double crossArm = 3.5;  // pixels

Vec3 vectorAt(const std::vector<double>& canon, std::size_t i) {
  return {canon[i], canon[i + 1], canon[i + 2]};
}

std::string nameOf(const Entity& entity) {
  const std::string name = printableAscii(entity.name);
  return entity.subscript == 0 || name.empty() ? name
                                               : fmt::format("{}({})", name, entity.subscript);
}

bool isComplete(const Entity& entity) {
  const auto count = static_cast<std::size_t>(canonicalCount(entity.type));
  return entity.canon.size() >= count && std::all_of(entity.canon.begin(), entity.canon.end(),
                                                     [](double v) { return std::isfinite(v); });
}
}  // namespace

void addExtent(const Entity& entity, const Curves& curves, Bounds& bounds) {
  for (const auto& curve : curves) {
    for (const Vec3& p : curve) {
      bounds.add(p);
    }
  }
  if (!isComplete(entity)) {
    return;
  }
  const std::vector<double>& c = entity.canon;
  switch (entity.type) {
    case EntityType::point:
      bounds.add(vectorAt(c, 0));
      break;
    case EntityType::circle:
      bounds.add(vectorAt(c, 0) + Vec3(c[6], c[6], 0.0));
      bounds.add(vectorAt(c, 0) - Vec3(c[6], c[6], 0.0));
      break;
    case EntityType::sphere:
      bounds.add(vectorAt(c, 0) + Vec3::Constant(c[3]));
      bounds.add(vectorAt(c, 0) - Vec3::Constant(c[3]));
      break;
    case EntityType::pattern:
      for (std::size_t i = 0; i + 3 <= c.size(); i += 3) {
        bounds.add(vectorAt(c, i));
      }
      break;
    default:
      break;
  }
}

bool GeometryDrawer::draw(const Entity& entity, const Curves& curves) {
  if (!isComplete(entity)) {
    return false;
  }
  if (!curves.empty()) {
    return drawCurves(entity, curves);
  }
  switch (entity.type) {
    case EntityType::point:
      return point(entity);
    case EntityType::line:
    case EntityType::plane:
      return plane(entity);
    case EntityType::circle:
    case EntityType::cylinder:
      return cylinder(entity);
    case EntityType::ellipse:
    case EntityType::hyperbola:
    case EntityType::gconic:
    case EntityType::lconic:
      return conic(entity);
    case EntityType::cone:
      return cone(entity);
    case EntityType::sphere:
      return sphere(entity);
    case EntityType::torus:
      return torus(entity);
    case EntityType::pattern:
      return pattern(entity);
    case EntityType::tabulatedCylinder:
      return tabulated(entity);
    case EntityType::vector:
    case EntityType::matrix:
    case EntityType::gun:
      return true;  // there is nothing to see
    default:
      return false;
  }
}

void GeometryDrawer::line(const Pixel& from, const Pixel& to) {
  canvas_.line(from, to, geometryClass);
  labels_.avoid(from, to, Labels::Line::geometry);
}

void GeometryDrawer::polyline(const std::vector<Pixel>& points) {
  canvas_.polyline(points, geometryClass);
  for (std::size_t i = 1; i < points.size(); ++i) {
    labels_.avoid(points[i - 1], points[i], Labels::Line::geometry);
  }
}

void GeometryDrawer::cross(const Vec3& place) {
  const Pixel p = view_(place);
  canvas_.line({p.x - crossArm, p.y}, {p.x + crossArm, p.y}, geometryClass);
  canvas_.line({p.x, p.y - crossArm}, {p.x, p.y + crossArm}, geometryClass);
}

bool GeometryDrawer::point(const Entity& entity) {
  const Vec3 place = vectorAt(entity.canon, 0);
  cross(place);
  if (entity.subscript == 0) {
    labels_.add(nameOf(entity), {view_(place)});
  } else {
    labels_.addElement(entity.name, nameOf(entity), view_(place));
  }
  return true;
}

bool GeometryDrawer::pattern(const Entity& entity) {
  for (std::size_t i = 0; i + 3 <= entity.canon.size(); i += 3) {
    cross(vectorAt(entity.canon, i));
  }
  std::vector<Pixel> places;
  for (std::size_t i = 0; i + 3 <= entity.canon.size(); i += 3) {
    places.push_back(view_(vectorAt(entity.canon, i)));
  }
  labels_.addAlong(nameOf(entity), places);
  return true;
}

void GeometryDrawer::edge(double a, double b, double d, const std::string& name) {
  const auto ends = view_.clip(a, b, d);
  if (!ends) {
    return;
  }
  const Pixel from = view_.place((*ends)[0].x(), (*ends)[0].y());
  const Pixel to = view_.place((*ends)[1].x(), (*ends)[1].y());
  line(from, to);
  std::vector<Pixel> anchors;
  for (const double t : {0.93, 0.07, 0.85, 0.15, 0.75, 0.25, 0.6, 0.4, 0.5}) {
    anchors.push_back({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
  }
  labels_.add(name, std::move(anchors));
}

bool GeometryDrawer::plane(const Entity& entity) {
  const std::vector<double>& c = entity.canon;
  const Vec3 normal = vectorAt(c, 0);
  if (std::abs(normal[view_.depth]) > tolerance::edgeOn * normal.norm()) {
    return false;  // it fills this view
  }
  edge(normal[view_.across], normal[view_.up], c[3], nameOf(entity));
  return true;
}

void GeometryDrawer::ring(const Vec3& center, double radius, const std::string& name) {
  const Pixel p = view_(center);
  const double r = std::abs(radius) * view_.scale;
  canvas_.circle(p, r, geometryClass);
  std::vector<Pixel> anchors;
  constexpr int around = 12;  // from the upper right on
  for (int k = 0; k < around; ++k) {
    const double turn = 2.0 * std::numbers::pi * (k + 1.5) / around;
    anchors.push_back({p.x + r * std::cos(turn), p.y - r * std::sin(turn)});
    if (k > 0) {
      labels_.avoid(anchors[anchors.size() - 2], anchors.back(), Labels::Line::geometry);
    }
  }
  labels_.avoid(anchors.back(), anchors.front(), Labels::Line::geometry);
  labels_.add(name, std::move(anchors));
}

bool GeometryDrawer::sphere(const Entity& entity) {
  ring(vectorAt(entity.canon, 0), entity.canon[3], nameOf(entity));
  return true;
}

bool GeometryDrawer::cylinder(const Entity& entity) {
  const Vec3 center = vectorAt(entity.canon, 0);
  const Vec3 axis = vectorAt(entity.canon, 3);
  const double radius = entity.canon[6];
  const Eigen::Vector2d seen(axis[view_.across], axis[view_.up]);
  if (seen.norm() <= tolerance::edgeOn) {
    ring(center, radius, nameOf(entity));
    return true;
  }
  if (entity.type == EntityType::circle && axis.cwiseAbs().maxCoeff() > 1.0 - tolerance::edgeOn) {
    return false;  // a circle is seen along its axis, in another view
  }
  // However it is tilted, the outline lies a radius beside the axis.
  const Eigen::Vector2d normal = Eigen::Vector2d(-seen.y(), seen.x()).normalized();
  const double middle = normal.dot(Eigen::Vector2d(center[view_.across], center[view_.up]));
  edge(normal.x(), normal.y(), middle + radius, nameOf(entity));
  edge(normal.x(), normal.y(), middle - radius, "");
  return true;
}

bool GeometryDrawer::cone(const Entity& entity) {
  const Vec3 vertex = vectorAt(entity.canon, 0);
  const Vec3 axis = vectorAt(entity.canon, 3);
  const Eigen::Vector2d seen(axis[view_.across], axis[view_.up]);
  const double cosine = std::clamp(entity.canon[6], -1.0, 1.0);
  const double depth = axis[view_.depth];
  cross(vertex);
  const Pixel tip = view_(vertex);
  labels_.add(nameOf(entity), {tip});
  // The generators whose normal lies in the view: cos(angle to the seen axis) =
  // sqrt(cos(half angle)^2 - depth^2) / |seen|. Seen from within the cone there is none.
  const double square = cosine * cosine - depth * depth;
  if (square <= 0.0 || seen.norm() <= tolerance::edgeOn) {
    return true;
  }
  const double angle = std::acos(std::clamp(std::sqrt(square) / seen.norm(), -1.0, 1.0));
  const double reach = (view_.box.width + view_.box.height) / view_.scale;
  for (const double side : {1.0, -1.0}) {
    const Eigen::Vector2d along = Eigen::Rotation2Dd(side * angle) * seen.normalized();
    const Eigen::Vector2d end =
        Eigen::Vector2d(vertex[view_.across], vertex[view_.up]) + reach * along;
    line(tip, view_.place(end.x(), end.y()));
  }
  return true;
}

void GeometryDrawer::besideEllipse(const Vec3& center,
                                   const Vec3& axis,
                                   double radius,
                                   double distance) {
  constexpr int pieces = 96;
  const Vec3 first = axis.unitOrthogonal();
  const Vec3 second = axis.cross(first).normalized();
  const auto flat = [this](const Vec3& v) { return Eigen::Vector2d(v[view_.across], v[view_.up]); };
  std::vector<Pixel> curve;
  for (int i = 0; i <= pieces; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / pieces;
    const Vec3 out = std::cos(turn) * first + std::sin(turn) * second;
    const Eigen::Vector2d along = flat(std::cos(turn) * second - std::sin(turn) * first);
    Eigen::Vector2d beside(along.y(), -along.x());
    beside *= along.norm() > tolerance::edgeOn ? distance / along.norm() : 0.0;
    const Eigen::Vector2d place = flat(center + radius * out) + beside;
    curve.push_back(view_.place(place.x(), place.y()));
  }
  polyline(curve);
}

bool GeometryDrawer::torus(const Entity& entity) {
  const Vec3 center = vectorAt(entity.canon, 0);
  const Vec3 axis = vectorAt(entity.canon, 3);
  if (Eigen::Vector2d(axis[view_.across], axis[view_.up]).norm() <= tolerance::edgeOn) {
    ring(center, entity.canon[6] + entity.canon[7], nameOf(entity));
    ring(center, entity.canon[6] - entity.canon[7], "");
    return true;
  }
  besideEllipse(center, axis, entity.canon[6], entity.canon[7]);
  besideEllipse(center, axis, entity.canon[6], -entity.canon[7]);
  labels_.add(nameOf(entity), {view_(center)});
  return true;
}

bool GeometryDrawer::conic(const Entity& entity) {
  if (view_.depth != 2) {
    return false;  // conics are cylinders along z
  }
  const std::vector<Segment> segments = conicInView(entity.canon, view_);
  for (const Segment& s : segments) {
    line(s.from, s.to);
  }
  if (!segments.empty()) {
    std::vector<Pixel> places;
    for (const Segment& s : segments) {
      places.push_back(s.from);
    }
    labels_.addAlong(nameOf(entity), places);
  }
  return true;
}

bool GeometryDrawer::drawCurves(const Entity& entity, const Curves& curves) {
  for (const auto& curve : curves) {
    std::vector<Pixel> points;
    std::transform(curve.begin(), curve.end(), std::back_inserter(points),
                   [this](const Vec3& p) { return view_(p); });
    polyline(points);
  }
  std::vector<Pixel> places;
  for (const Vec3& p : curves.front()) {
    places.push_back(view_(p));
  }
  labels_.addAlong(nameOf(entity), places);
  return true;
}

bool GeometryDrawer::tabulated(const Entity& entity) {
  const std::vector<Vec3> curve = tabulatedCurve(entity.canon, view_.depth);
  if (curve.empty()) {
    return false;
  }
  std::vector<Pixel> points;
  points.reserve(curve.size());
  for (const Vec3& p : curve) {
    points.push_back(view_(p));
  }
  polyline(points);
  labels_.addAlong(nameOf(entity), points);
  return true;
}

}  // namespace arelem::backend::svg
