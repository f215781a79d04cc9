#include "runtime/geometry/exact_polygon.h"

#include <algorithm>
#include <tuple>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

namespace arelem::geometry {

namespace {
using Rational = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Signs = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corner = Signs::Point_2;
using Segment = Signs::Segment_2;

Corner pointOf(const Vec2& p) {
  return {p.x(), p.y()};
}

struct Edge {
  Segment segment;
  std::size_t polygon = 0, index = 0, count = 0;  ///< count: of the polygon's edges
};
using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const Edge*>;

std::vector<Edge> edgesOf(std::span<const Polygon> polygons) {
  std::vector<Edge> edges;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    const Polygon& polygon = polygons[p];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      edges.push_back({Segment(pointOf(polygon[i]), pointOf(polygon[(i + 1) % polygon.size()])), p,
                       i, polygon.size()});
    }
  }
  return edges;
}

/// Neighbors share a corner; they meet elsewhere only where one turns back on the other.
bool turnsBack(const Segment& first, const Segment& second) {
  return CGAL::collinear(first.source(), first.target(), second.target()) &&
         CGAL::angle(first.source(), first.target(), second.target()) == CGAL::ACUTE;
}

/// The corner of one edge that lies within `near` of the other.
std::optional<Corner> touching(const Segment& first, const Segment& second, double near) {
  for (const auto& [edge, other] : {std::pair(&first, &second), std::pair(&second, &first)}) {
    for (const Corner& corner : {edge->source(), edge->target()}) {
      if (CGAL::squared_distance(corner, *other) <= near * near) {
        return corner;
      }
    }
  }
  return std::nullopt;
}

/// Where two edges meet that must not.
std::optional<Corner> meetingOf(const Edge& e, const Edge& f, double near) {
  if (e.polygon == f.polygon && e.count > 2) {
    if ((e.index + 1) % e.count == f.index) {
      return turnsBack(e.segment, f.segment) ? std::optional(e.segment.target()) : std::nullopt;
    }
    if ((f.index + 1) % e.count == e.index) {
      return turnsBack(f.segment, e.segment) ? std::optional(f.segment.target()) : std::nullopt;
    }
  }
  if (!CGAL::do_intersect(e.segment, f.segment)) {
    return near > 0.0 && e.polygon != f.polygon ? touching(e.segment, f.segment, near)
                                                : std::nullopt;
  }
  const auto common = CGAL::intersection(e.segment, f.segment);
  if (!common) {
    return e.segment.source();  // the place is rounded, that they meet is not
  }
  if (const Corner* point = boost::get<Corner>(&*common)) {
    return *point;
  }
  return boost::get<Segment>(*common).source();
}
}  // namespace

double signedArea(std::span<const Polygon> polygons) {
  CGAL::Gmpq sum = 0;
  for (const Polygon& polygon : polygons) {
    std::vector<Rational::Point_2> corners;
    for (const Vec2& p : polygon) {
      corners.emplace_back(p.x(), p.y());
    }
    if (corners.size() > 2) {
      sum += CGAL::polygon_area_2(corners.begin(), corners.end(), Rational());
    }
  }
  return CGAL::to_double(sum);
}

std::optional<Meeting> firstMeeting(std::span<const Polygon> polygons, double near) {
  const std::vector<Edge> edges = edgesOf(polygons);
  std::vector<Box> boxes;
  for (const Edge& edge : edges) {
    const CGAL::Bbox_2 box = edge.segment.bbox();
    boxes.emplace_back(
        CGAL::Bbox_2(box.xmin() - near, box.ymin() - near, box.xmax() + near, box.ymax() + near),
        &edge);
  }
  using Pair = std::pair<const Edge*, const Edge*>;
  std::optional<Pair> first;
  std::optional<Corner> place;
  // Edges lie in one array: their addresses are in the order of the corners.
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const Pair pair = std::minmax(a.handle(), b.handle());
    if (first && *first <= pair) {
      return;
    }
    if (const std::optional<Corner> found = meetingOf(*pair.first, *pair.second, near)) {
      first = pair;
      place = found;
    }
  });
  if (!first) {
    return std::nullopt;
  }
  const auto& [e, f] = *first;
  return Meeting{{place->x(), place->y()}, e->polygon, f->polygon, e->index, f->index};
}

}  // namespace arelem::geometry
