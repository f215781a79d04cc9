// The only file that includes CGAL's tree of boxes.
#include "runtime/geometry/triangle_tree.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

namespace arelem::geometry {

OnTriangle nearestOn(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double d1 = ab.dot(p - a);
  const double d2 = ac.dot(p - a);
  if (d1 <= 0.0 && d2 <= 0.0) {
    return {a, Feature::vertex0};
  }
  const double d3 = ab.dot(p - b);
  const double d4 = ac.dot(p - b);
  if (d3 >= 0.0 && d4 <= d3) {
    return {b, Feature::vertex1};
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    return {a + d1 / (d1 - d3) * ab, Feature::edge0};
  }
  const double d5 = ab.dot(p - c);
  const double d6 = ac.dot(p - c);
  if (d6 >= 0.0 && d5 <= d6) {
    return {c, Feature::vertex2};
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    return {a + d2 / (d2 - d6) * ac, Feature::edge2};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), Feature::edge1};
  }
  const double sum = va + vb + vc;
  return {a + vb / sum * ab + vc / sum * ac, Feature::face};
}

namespace {
using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Traits = CGAL::AABB_traits<Kernel, Primitive>;
using Tree = CGAL::AABB_tree<Traits>;

Kernel::Point_3 point(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

/// What CGAL's traversal asks; the query is in the search itself.
struct Traversal {
  TriangleSearch& search;
  Triangles::const_iterator begin;

  static bool go_further() { return true; }  // NOLINT(readability-identifier-naming): CGAL's names
  void intersection(int, const Primitive& primitive) const {
    search.visit(static_cast<std::size_t>(primitive.id() - begin));
  }
  // NOLINTNEXTLINE(readability-identifier-naming)
  [[nodiscard]] bool do_intersect(int, const CGAL::AABB_node<Traits>& node) const {
    const CGAL::Bbox_3& box = node.bbox();
    const Vec3 low(box.xmin(), box.ymin(), box.zmin());
    const Vec3 high(box.xmax(), box.ymax(), box.zmax());
    return search.enters(0.5 * (low + high), 0.5 * (high - low));
  }
};

class CgalTree final : public TriangleTree {
 public:
  explicit CgalTree(const TriangleMesh& mesh) : mesh_(mesh) {
    triangles_.reserve(mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      triangles_.emplace_back(point(mesh.corner(i, 0)), point(mesh.corner(i, 1)),
                              point(mesh.corner(i, 2)));
    }
    tree_.insert(triangles_.cbegin(), triangles_.cend());
    tree_.build();
  }

  [[nodiscard]] std::size_t nearest(const Vec3& p, int guess) const override {
    const auto start = static_cast<std::size_t>(std::max(guess, 0));
    const Vec3 on =
        nearestOn(mesh_.corner(start, 0), mesh_.corner(start, 1), mesh_.corner(start, 2), p).point;
    const auto hint = triangles_.cbegin() + static_cast<std::ptrdiff_t>(start);
    const auto found = tree_.closest_point_and_primitive(point(p), {point(on), hint});
    return static_cast<std::size_t>(found.second - triangles_.cbegin());
  }

  void search(TriangleSearch& search) const override {
    Traversal traversal{search, triangles_.cbegin()};
    tree_.traversal(0, traversal);
  }

 private:
  TriangleMesh mesh_;
  Triangles triangles_;
  Tree tree_;
};
}  // namespace

std::unique_ptr<TriangleTree> makeTree(const TriangleMesh& mesh) {
  return std::make_unique<CgalTree>(mesh);
}

}  // namespace arelem::geometry
