#pragma once
#include <set>

#include "backend/svg/canvas.h"
#include "backend/svg/labels.h"
#include "ir/geometry/entity.h"

namespace arelem::backend::svg {

/// Adds the extent of an entity that has one: points, circles, spheres, patterns.
void addExtent(const Entity& entity, Bounds& bounds);

/// Draws the geometry of the part program in one view: points, lines and planes seen edge on,
/// circles, cylinders, cones, spheres, tori, conics in the XY plane, patterns, and tabulated
/// cylinders along their generatrix.
class GeometryDrawer {
 public:
  GeometryDrawer(Canvas& canvas, const View& view)
      : canvas_(canvas), view_(view), labels_(view.box) {}

  void draw(const Entity& entity);
  void drawNames() { labels_.draw(canvas_); }

 private:
  void point(const Entity& entity);
  void pattern(const Entity& entity);
  void plane(const Entity& entity);
  void sphere(const Entity& entity);
  void cylinder(const Entity& entity);
  void cone(const Entity& entity);
  void torus(const Entity& entity);
  void conic(const Entity& entity);
  void tabulated(const Entity& entity);

  void cross(const Vec3& place);
  void ring(const Vec3& center, double radius, const std::string& name);
  /// The line a * across + b * up = d; false when it does not pass through the view.
  bool edge(double a, double b, double d, const std::string& name);

  Canvas& canvas_;
  const View& view_;
  Labels labels_;
};

/// Kinds of entities that no view shows, for the legend.
[[nodiscard]] bool hasPicture(EntityType type);

}  // namespace arelem::backend::svg
