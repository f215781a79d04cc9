#include "runtime/spray/offset_curve.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include "ir/space/tolerance.h"

namespace arelem::spray {

namespace {
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;

/// Counterclockwise; none where the corners span nothing.
template <class Corners>
std::optional<Polygon> polygonOf(const Corners& corners) {
  Polygon polygon;
  for (const Vec2& p : corners) {
    const Kernel::Point_2 corner(p.x(), p.y());
    if (polygon.is_empty() || polygon[polygon.size() - 1] != corner) {
      polygon.push_back(corner);
    }
  }
  while (polygon.size() > 1 && polygon[0] == polygon[polygon.size() - 1]) {
    polygon.erase(polygon.vertices_end() - 1);
  }
  if (polygon.size() < 3 || !polygon.is_simple() || polygon.orientation() == CGAL::COLLINEAR) {
    return std::nullopt;
  }
  if (polygon.is_clockwise_oriented()) {
    polygon.reverse_orientation();
  }
  return polygon;
}

/// Rounded, without corners that rounding has made one.
void append(Outline& outline, const Polygon& polygon) {
  Loop loop;
  for (const Kernel::Point_2& corner : polygon.container()) {
    const Vec2 p(CGAL::to_double(corner.x()), CGAL::to_double(corner.y()));
    if (loop.empty() || (p - loop.back()).norm() > tolerance::passGap) {
      loop.push_back(p);
    }
  }
  while (loop.size() > 1 && (loop.front() - loop.back()).norm() <= tolerance::passGap) {
    loop.pop_back();
  }
  if (loop.size() >= 3) {
    outline.loops.push_back(std::move(loop));
  }
}
}  // namespace

Outline offsetCurve(const Outline& outline, const Footprint& footprint, double sharpest) {
  std::vector<Polygon> loops;
  for (const Loop& loop : outline.loops) {
    if (auto polygon = polygonOf(loop)) {
      loops.push_back(*std::move(polygon));
    }
  }
  std::vector<Polygon> bands;
  const SprayedArea sprayed(outline, footprint, sharpest);
  for (const SprayedArea::Band& band : sprayed.bands()) {
    if (auto polygon = polygonOf(band.corners)) {
      bands.push_back(*std::move(polygon));
    }
  }
  PolygonSet all;
  all.symmetric_difference(loops.begin(), loops.end());  // loops lie in each other: holes, islands
  all.join(bands.begin(), bands.end());
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> parts;
  all.polygons_with_holes(std::back_inserter(parts));
  Outline curve;
  for (const auto& part : parts) {
    append(curve, part.outer_boundary());
    for (const Polygon& hole : part.holes()) {
      append(curve, hole);
    }
  }
  return curve;
}

}  // namespace arelem::spray
