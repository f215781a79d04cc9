// Curves of a drawing to closed loops, by their ends.
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "ir/diag/spray.h"
#include "runtime/region/drawing.h"

namespace arelem::region {

namespace {
struct End {
  std::size_t curve = 0;
  bool last = false;
};

/// Finds ends near a place: cells of the size of the joint.
class EndTable {
 public:
  EndTable(const std::vector<Curve>& curves, double joint) : curves_(curves), joint_(joint) {
    for (std::size_t i = 0; i < curves.size(); ++i) {
      if (!curves[i].closed) {
        cells_[key(cell(place({i, false}).x()), cell(place({i, false}).y()))].push_back({i, false});
        cells_[key(cell(place({i, true}).x()), cell(place({i, true}).y()))].push_back({i, true});
      }
    }
  }
  [[nodiscard]] const Vec2& place(const End& end) const {
    const std::vector<Vec2>& points = curves_[end.curve].points;
    return end.last ? points.back() : points.front();
  }
  /// Other ends within the joint.
  [[nodiscard]] std::vector<End> near(const End& end) const {
    std::vector<End> found;
    const Vec2& at = place(end);
    for (long dx = -1; dx <= 1; ++dx) {
      for (long dy = -1; dy <= 1; ++dy) {
        const auto one = cells_.find(key(cell(at.x()) + dx, cell(at.y()) + dy));
        if (one == cells_.end()) {
          continue;
        }
        for (const End& other : one->second) {
          const bool same = other.curve == end.curve && other.last == end.last;
          if (!same && (place(other) - at).norm() <= joint_) {
            found.push_back(other);
          }
        }
      }
    }
    return found;
  }
  /// The nearest other end of all, for messages.
  [[nodiscard]] Vec2 nearest(const End& end) const {
    Vec2 best = place({end.curve, !end.last});
    for (const auto& [_, ends] : cells_) {
      for (const End& other : ends) {
        const bool same = other.curve == end.curve && other.last == end.last;
        if (!same && (place(other) - place(end)).norm() < (best - place(end)).norm()) {
          best = place(other);
        }
      }
    }
    return best;
  }

 private:
  /// Places that are too far off for a cell of their own share one.
  [[nodiscard]] long cell(double x) const {
    constexpr double farthest = 1e15;
    return static_cast<long>(std::floor(std::clamp(x / joint_, -farthest, farthest)));
  }
  static std::uint64_t key(long x, long y) {
    return static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15ULL ^ static_cast<std::uint64_t>(y);
  }

  const std::vector<Curve>& curves_;
  double joint_;
  std::unordered_map<std::uint64_t, std::vector<End>> cells_;
};

void append(spray::Loop& loop, const Curve& curve, bool backwards) {
  std::vector<Vec2> points = curve.points;
  if (backwards) {
    std::reverse(points.begin(), points.end());
  }
  loop.insert(loop.end(), points.begin() + (loop.empty() ? 0 : 1), points.end());
}
}  // namespace

Result<std::vector<spray::Loop>> chained(std::vector<Curve> curves,
                                         std::string_view name,
                                         double joint) {
  std::vector<spray::Loop> loops;
  // Curves without length bound nothing and would only confuse the ends.
  std::erase_if(curves, [joint](const Curve& c) {
    return !c.closed && c.points.size() == 2 && (c.points[0] - c.points[1]).norm() <= joint;
  });
  const EndTable table(curves, joint);
  std::vector<bool> used(curves.size(), false);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (used[i]) {
      continue;
    }
    used[i] = true;
    spray::Loop& loop = loops.emplace_back();
    append(loop, curves[i], false);
    End end{i, true};
    while (!curves[i].closed) {
      const std::vector<End> next = table.near(end);
      const Vec2& at = table.place(end);
      if (next.empty()) {
        const Vec2 other = table.nearest(end);
        return fail(diag::DrawingOpen, name, at.x(), at.y(), other.x(), other.y(),
                    (other - at).norm(), joint);
      }
      // Nearness is not transitive: an end may lead back into a curve that is in the loop.
      const bool again = used[next[0].curve] && (next[0].curve != i || next[0].last);
      if (next.size() > 1 || again) {
        return fail(diag::DrawingBranches, name, at.x(), at.y(), next.size() + 1);
      }
      if (next[0].curve == i && !next[0].last) {
        loop.pop_back();
        break;
      }
      used[next[0].curve] = true;
      append(loop, curves[next[0].curve], next[0].last);
      end = {next[0].curve, !next[0].last};
    }
  }
  return loops;
}

}  // namespace arelem::region
