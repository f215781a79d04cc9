// Sections of a patch: contours of the height over a plane over the parameters, by marching
// squares; each crossing is found on its grid line by bisection, points between crossings square to
// the way from one to the next.
#include <algorithm>
#include <cmath>
#include <map>

#include "runtime/spray/surface/kept.h"
#include "runtime/spray/surface/patch_grid.h"

namespace arelem::spray {

namespace {
constexpr int bisections = 50;
constexpr int deepest = 14;  // halvings between two crossings

/// A grid line between two neighboring nodes: column, row, and whether it runs along u.
using EdgeKey = std::tuple<std::size_t, std::size_t, bool>;

class Contour {
 public:
  Contour(const Patch& patch, const PatchGrid& grid, const CuttingPlane& plane, double chord)
      : patch_(patch), grid_(grid), plane_(plane), chord_(chord) {}

  std::vector<std::vector<Vec2>> run() {
    for (std::size_t i = 0; i < grid_.columns(); ++i) {
      for (std::size_t k = 0; k < grid_.rows(); ++k) {
        cell(i, k);
      }
    }
    std::vector<std::vector<Vec2>> lines;
    // Open lines begin at an end; what is left are closed ones.
    for (const bool openOnly : {true, false}) {
      for (const auto& [key, links] : links_) {
        if (!used_[key] && (!openOnly || links.size() == 1)) {
          lines.push_back(refined(follow(key)));
        }
      }
    }
    return lines;
  }

 private:
  [[nodiscard]] double over(const Vec2& p) const { return height(patch_.at(p.x(), p.y())); }
  [[nodiscard]] double height(const Vec3& place) const {
    return plane_.normal.dot(place) - plane_.level;
  }

  void cell(std::size_t i, std::size_t k) {
    const std::array<double, 4> value = {height(grid_.place(i, k)), height(grid_.place(i + 1, k)),
                                         height(grid_.place(i + 1, k + 1)),
                                         height(grid_.place(i, k + 1))};
    const std::array<EdgeKey, 4> edges = {EdgeKey{i, k, true}, EdgeKey{i + 1, k, false},
                                          EdgeKey{i, k + 1, true}, EdgeKey{i, k, false}};
    std::vector<EdgeKey> cut;
    for (std::size_t e = 0; e < 4; ++e) {
      if ((value[e] < 0.0) != (value[(e + 1) % 4] < 0.0)) {
        cut.push_back(edges[e]);
      }
    }
    if (cut.size() == 4) {
      // A saddle: the height in the middle tells which corners hang together.
      const double middle = over((grid_.node(i, k) + grid_.node(i + 1, k + 1)) / 2.0);
      if ((middle < 0.0) != (value[0] < 0.0)) {
        std::rotate(cut.begin(), cut.begin() + 3, cut.end());
      }
    }
    for (std::size_t e = 0; e + 1 < cut.size(); e += 2) {
      links_[cut[e]].push_back(cut[e + 1]);
      links_[cut[e + 1]].push_back(cut[e]);
    }
  }

  /// The crossing between a place below the plane and one that is not, or the other way round.
  [[nodiscard]] Vec2 between(Vec2 a, Vec2 b) const {
    const bool below = over(a) < 0.0;
    for (int n = 0; n < bisections; ++n) {
      const Vec2 middle = (a + b) / 2.0;
      ((over(middle) < 0.0) == below ? a : b) = middle;
    }
    return a;
  }
  [[nodiscard]] Vec2 crossing(const EdgeKey& key) const {
    const auto [i, k, alongU] = key;
    return between(grid_.node(i, k), alongU ? grid_.node(i + 1, k) : grid_.node(i, k + 1));
  }

  std::vector<Vec2> follow(EdgeKey key) {
    std::vector<Vec2> line;
    const EdgeKey start = key;
    while (!used_[key]) {
      used_[key] = true;
      line.push_back(crossing(key));
      for (const EdgeKey& next : links_[key]) {
        if (!used_[next]) {
          key = next;
          break;
        }
      }
    }
    const auto& back = links_[key];
    if (line.size() > 2 && key != start &&
        std::find(back.begin(), back.end(), start) != back.end()) {
      line.push_back(line.front());
    }
    return line;
  }

  std::vector<Vec2> refined(const std::vector<Vec2>& line) const {
    std::vector<Vec2> result = {line.front()};
    for (std::size_t i = 1; i < line.size(); ++i) {
      divide(line[i - 1], line[i], deepest, result);
    }
    return result;
  }

  /// Appends what lies behind `a` as far as `b`, so finely that chords keep to the section.
  void divide(const Vec2& a, const Vec2& b, int depth, std::vector<Vec2>& into) const {
    const Vec3 from = patch_.at(a.x(), a.y());
    const Vec3 step = patch_.at(b.x(), b.y()) - from;
    double off = 0.0;
    for (const double share : {0.25, 0.5, 0.75}) {
      const Vec2 p = beside(a, b, share);
      const Vec3 arm = patch_.at(p.x(), p.y()) - from;
      const double square = step.squaredNorm();
      const double t = square > 0.0 ? std::clamp(arm.dot(step) / square, 0.0, 1.0) : 0.0;
      off = std::max(off, (arm - t * step).norm());
    }
    if (off > chord_ && depth > 0) {
      const Vec2 middle = beside(a, b, 0.5);
      divide(a, middle, depth - 1, into);
      divide(middle, b, depth - 1, into);
      return;
    }
    into.push_back(b);
  }

  /// The place of the section beside a share of the way from one of its places to the next. The
  /// straight place itself where the section is not near: at a corner of the grid.
  [[nodiscard]] Vec2 beside(const Vec2& a, const Vec2& b, double share) const {
    const Vec2 scale((patch_.u1 - patch_.u0), (patch_.v1 - patch_.v0));
    const Vec2 way = (b - a).cwiseQuotient(scale);
    const Vec2 square = Vec2(-way.y(), way.x()).cwiseProduct(scale);
    const Vec2 straight = a + share * (b - a);
    const bool below = over(straight) < 0.0;
    for (const double reach : {0.0625, 0.25, 1.0}) {
      for (const double side : {reach, -reach}) {
        const Vec2 other(std::clamp(straight.x() + side * square.x(), patch_.u0, patch_.u1),
                         std::clamp(straight.y() + side * square.y(), patch_.v0, patch_.v1));
        if ((over(other) < 0.0) != below) {
          return between(straight, other);
        }
      }
    }
    return straight;
  }

  const Patch& patch_;
  const PatchGrid& grid_;
  const CuttingPlane& plane_;
  double chord_;
  std::map<EdgeKey, std::vector<EdgeKey>> links_;
  std::map<EdgeKey, bool> used_;
};

}  // namespace

std::vector<SurfaceLine> sectionOf(const Patch& patch,
                                   const PatchGrid& grid,
                                   const CuttingPlane& plane,
                                   double chord) {
  // Half of the tolerance for the points of the section, half for those that are left out.
  const double half = chord / 2.0;
  std::vector<SurfaceLine> sections;
  for (const std::vector<Vec2>& places : Contour(patch, grid, plane, half).run()) {
    SurfaceLine line;
    for (const Vec2& p : places) {
      line.push_back({patch.at(p.x(), p.y()), patch.normal(p.x(), p.y()), p});
    }
    if (line.size() < 2) {
      continue;
    }
    for (const SurfaceLine& piece : keptPieces(patch, line)) {
      appendToAndFro(sections, thinned(piece, half));
    }
  }
  return sections;
}

}  // namespace arelem::spray
