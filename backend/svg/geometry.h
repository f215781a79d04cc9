#pragma once
#include <set>

#include "backend/backend.h"
#include "backend/svg/canvas.h"
#include "backend/svg/labels.h"
#include "ir/geometry/entity.h"

namespace arelem::backend::svg {

/// Adds the extent of an entity that has one: points, circles, spheres, patterns, curves.
void addExtent(const Entity& entity, const Curves& curves, Bounds& bounds);

/// Draws the geometry of the part program in one view: points, lines and planes seen edge on,
/// circles, the outlines of cylinders, cones, spheres and tori however they lie, conics in the XY
/// plane, patterns, and tabulated cylinders along their generatrix.
class GeometryDrawer {
 public:
  GeometryDrawer(Canvas& canvas, const View& view)
      : canvas_(canvas), view_(view), labels_(view.box) {}

  /// False when this view has no picture of the entity. `curves`: what else is known of its shape.
  bool draw(const Entity& entity, const Curves& curves);
  /// Where the names will stand.
  Labels& labels() { return labels_; }
  std::vector<std::string> drawNames() { return labels_.draw(canvas_); }

 private:
  bool point(const Entity& entity);
  bool pattern(const Entity& entity);
  bool plane(const Entity& entity);
  bool sphere(const Entity& entity);
  bool cylinder(const Entity& entity);
  bool cone(const Entity& entity);
  bool torus(const Entity& entity);
  bool conic(const Entity& entity);
  bool tabulated(const Entity& entity);
  bool drawCurves(const Entity& entity, const Curves& curves);

  /// Lines that names better do not cover.
  void line(const Pixel& from, const Pixel& to);
  void polyline(const std::vector<Pixel>& points);
  void cross(const Vec3& place);
  /// The curve at this distance from a circle seen at an angle: an outline of a torus.
  void besideEllipse(const Vec3& center, const Vec3& axis, double radius, double distance);
  void ring(const Vec3& center, double radius, const std::string& name);
  /// The line a * across + b * up = d, as far as it passes through the view.
  void edge(double a, double b, double d, const std::string& name);

  Canvas& canvas_;
  const View& view_;
  Labels labels_;
};

}  // namespace arelem::backend::svg
