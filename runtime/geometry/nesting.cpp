#include "runtime/geometry/nesting.h"

#include <algorithm>
#include <set>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace arelem::geometry {

namespace {
using Signs = CGAL::Exact_predicates_inexact_constructions_kernel;

bool before(const Vec2& a, const Vec2& b) {
  return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

CGAL::Orientation turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return CGAL::orientation(Signs::Point_2(a.x(), a.y()), Signs::Point_2(b.x(), b.y()),
                           Signs::Point_2(c.x(), c.y()));
}

/// An edge that is not upright; it counts from its left end up to, without, its right end.
struct Edge {
  Vec2 left, right;
  std::size_t polygon = 0;
  bool rightward = true;  ///< it runs from left to right in its polygon
};

/// Whether an edge lies under another: both are over one x at least, and do not cross.
struct Under {
  bool operator()(const Edge* a, const Edge* b) const {
    if (a == b) {
      return false;
    }
    if (a->left.x() <= b->left.x()) {
      const CGAL::Orientation side = turn(a->left, a->right, b->left);
      return side != CGAL::COLLINEAR ? side == CGAL::LEFT_TURN
                                     : turn(a->left, a->right, b->right) == CGAL::LEFT_TURN;
    }
    const CGAL::Orientation side = turn(b->left, b->right, a->left);
    return side != CGAL::COLLINEAR ? side == CGAL::RIGHT_TURN
                                   : turn(b->left, b->right, a->right) == CGAL::RIGHT_TURN;
  }
};

class Sweep {
 public:
  explicit Sweep(std::span<const Polygon> polygons) : depths_(polygons.size(), 0) {
    for (std::size_t p = 0; p < polygons.size(); ++p) {
      add(polygons[p], p);
    }
  }

  std::vector<std::size_t> run() {
    std::vector<const Edge*> begins;
    for (const Edge& edge : edges_) {
      begins.push_back(&edge);
    }
    std::vector<const Edge*> ends = begins;
    std::sort(begins.begin(), begins.end(), [](const Edge* a, const Edge* b) {
      return a->left != b->left ? before(a->left, b->left) : a < b;
    });
    std::sort(ends.begin(), ends.end(), [](const Edge* a, const Edge* b) {
      return a->right.x() != b->right.x() ? a->right.x() < b->right.x() : a < b;
    });
    std::size_t gone = 0;
    for (std::size_t i = 0; i < begins.size();) {
      const double x = begins[i]->left.x();
      for (; gone < ends.size() && ends[gone]->right.x() <= x; ++gone) {
        over_.erase(ends[gone]);
      }
      const std::size_t first = i;
      for (; i < begins.size() && begins[i]->left.x() == x; ++i) {
        over_.insert(begins[i]);
      }
      // What lies below is known first: these begin in the order of their heights.
      for (std::size_t k = first; k < i; ++k) {
        if (!known_[begins[k]->polygon]) {
          place(*begins[k]);
        }
      }
    }
    return std::move(depths_);
  }

 private:
  void add(const Polygon& polygon, std::size_t number) {
    const std::size_t n = polygon.size();
    std::size_t lowest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      lowest = before(polygon[i], polygon[lowest]) ? i : lowest;
      const Vec2& a = polygon[i];
      const Vec2& b = polygon[(i + 1) % n];
      if (a.x() != b.x()) {
        const bool rightward = a.x() < b.x();
        edges_.push_back({rightward ? a : b, rightward ? b : a, number, rightward});
      }
    }
    counterclockwise_.push_back(turn(polygon[(lowest + n - 1) % n], polygon[lowest],
                                     polygon[(lowest + 1) % n]) == CGAL::LEFT_TURN);
    known_.push_back(false);
  }

  /// The depth of a polygon by the edge under its first ones.
  void place(const Edge& edge) {
    known_[edge.polygon] = true;
    auto at = over_.find(&edge);
    while (at != over_.begin()) {
      const Edge& below = **--at;
      if (below.polygon != edge.polygon) {
        const bool inside = below.rightward == counterclockwise_[below.polygon];
        depths_[edge.polygon] = depths_[below.polygon] + (inside ? 1 : 0);
        return;
      }
    }
  }

  std::vector<Edge> edges_;
  std::vector<bool> counterclockwise_;
  std::vector<bool> known_;
  std::vector<std::size_t> depths_;
  std::set<const Edge*, Under> over_;  // the edges over the x of the sweep, from below
};
}  // namespace

std::vector<std::size_t> nestingDepths(std::span<const Polygon> polygons) {
  return Sweep(polygons).run();
}

}  // namespace arelem::geometry
