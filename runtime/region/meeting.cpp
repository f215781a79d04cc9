// Which edges of a region meet: edges are sorted into the cells of a grid, so that only near ones
// are compared; the comparisons are exact.
#include <algorithm>
#include <cmath>

#include "runtime/geometry/exact.h"
#include "runtime/region/region.h"

namespace arelem::region {

using spray::Loop;
using spray::Outline;
using spray::Vec2;

namespace {
struct Edge {
  Vec2 from, to;
  std::size_t loop = 0, index = 0;
};

int turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return geometry::turn(a.x(), a.y(), b.x(), b.y(), c.x(), c.y());
}

bool between(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 low = a.cwiseMin(b);
  const Vec2 high = a.cwiseMax(b);
  return p.x() >= low.x() && p.x() <= high.x() && p.y() >= low.y() && p.y() <= high.y();
}

/// Where two edges meet, if they do.
std::optional<Vec2> meet(const Edge& e, const Edge& f) {
  const int a = turn(e.from, e.to, f.from);
  const int b = turn(e.from, e.to, f.to);
  const int c = turn(f.from, f.to, e.from);
  const int d = turn(f.from, f.to, e.to);
  if (a * b < 0 && c * d < 0) {
    const Vec2 r = e.to - e.from;
    const Vec2 s = f.to - f.from;
    const double t = ((f.from - e.from).x() * s.y() - (f.from - e.from).y() * s.x()) /
                     (r.x() * s.y() - r.y() * s.x());
    return e.from + t * r;
  }
  if (a == 0 && between(f.from, e.from, e.to)) {
    return f.from;
  }
  if (b == 0 && between(f.to, e.from, e.to)) {
    return f.to;
  }
  if (c == 0 && between(e.from, f.from, f.to)) {
    return e.from;
  }
  if (d == 0 && between(e.to, f.from, f.to)) {
    return e.to;
  }
  return std::nullopt;
}

/// Neighbors share a corner; they meet elsewhere only where one turns back on the other.
std::optional<Vec2> meetNeighbor(const Edge& first, const Edge& second) {
  const bool straight = turn(first.from, first.to, second.to) == 0;
  const bool back = straight && (second.to - second.from).dot(first.to - first.from) < 0.0;
  return back ? std::optional(first.to) : std::nullopt;
}

class EdgeGrid {
 public:
  explicit EdgeGrid(const Outline& outline) {
    for (std::size_t l = 0; l < outline.loops.size(); ++l) {
      const Loop& loop = outline.loops[l];
      sizes_.push_back(loop.size());
      for (std::size_t i = 0; i < loop.size(); ++i) {
        edges_.push_back({loop[i], loop[(i + 1) % loop.size()], l, i});
      }
    }
    const spray::Extent extent = extentOf(outline);
    low_ = extent.low;
    const double side = std::max({(extent.high - extent.low).maxCoeff(), 1e-300});
    count_ = std::clamp<long>(std::lround(std::sqrt(static_cast<double>(edges_.size()))), 1, 2000);
    cell_ = side / static_cast<double>(count_);
    cells_.resize(static_cast<std::size_t>(count_ * count_));
  }

  std::optional<Meeting> first() {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (auto meeting = addAndCompare(i)) {
        return meeting;
      }
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] long index(double offset) const {
    return std::clamp<long>(static_cast<long>(offset / cell_), 0, count_ - 1);
  }

  std::optional<Meeting> addAndCompare(std::size_t i) {
    const Edge& e = edges_[i];
    const Vec2 low = e.from.cwiseMin(e.to) - low_;
    const Vec2 high = e.from.cwiseMax(e.to) - low_;
    for (long row = index(low.y()); row <= index(high.y()); ++row) {
      for (long column = index(low.x()); column <= index(high.x()); ++column) {
        std::vector<std::size_t>& cell = cells_[static_cast<std::size_t>(row * count_ + column)];
        for (const std::size_t k : cell) {
          if (const std::optional<Vec2> place = compare(edges_[k], e)) {
            return Meeting{*place, edges_[k].loop, e.loop, edges_[k].index, e.index};
          }
        }
        cell.push_back(i);
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Vec2> compare(const Edge& e, const Edge& f) const {
    if (e.loop == f.loop) {
      const std::size_t n = sizes_[e.loop];
      if ((e.index + 1) % n == f.index) {
        return meetNeighbor(e, f);
      }
      if ((f.index + 1) % n == e.index) {
        return meetNeighbor(f, e);
      }
    }
    return meet(e, f);
  }

  std::vector<Edge> edges_;
  std::vector<std::size_t> sizes_;
  std::vector<std::vector<std::size_t>> cells_;
  Vec2 low_ = Vec2::Zero();
  double cell_ = 1.0;
  long count_ = 1;
};
}  // namespace

std::optional<Meeting> firstMeeting(const Outline& outline) {
  return EdgeGrid(outline).first();
}

}  // namespace arelem::region
