#include "runtime/certify/pocket_proof.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "ir/diag/verify.h"
#include "ir/space/tolerance.h"
#include "runtime/spline/bezier.h"

namespace arelem::certify {

namespace {
/// Sine of the least angle between tool axis and bottom.
constexpr double leastSine = 0.2;

Failure objection(const char* why) {
  return fail(diag::NotCertified, std::string(why));
}

/// Along the tool axis on the part surface.
Result<std::vector<Vec3>> onPart(std::vector<Vec3> points, const Modal& modal) {
  const Named part = modal.partSurface();
  const auto* plane = std::get_if<surface::Plane>(&part.surface);
  if (plane == nullptr) {
    return objection("its points are projected on a part surface that is no plane");
  }
  const double sine = plane->normal.dot(modal.axis);
  if (std::abs(sine) < leastSine) {
    return objection("the tool axis lies along the part surface");
  }
  for (Vec3& p : points) {
    p += (plane->offset - plane->normal.dot(p)) / sine * modal.axis;
  }
  return points;
}

using Polygon = std::vector<Vec3>;

/// What a convex polygon has where `inward`.x >= `least`.
Polygon cut(const Polygon& polygon, const Vec3& inward, double least) {
  Polygon left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& a = polygon[i];
    const Vec3& b = polygon[(i + 1) % polygon.size()];
    const double da = inward.dot(a) - least;
    const double db = inward.dot(b) - least;
    if (da >= 0.0) {
      left.push_back(a);
    }
    if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) {
      left.emplace_back(a + da / (da - db) * (b - a));
    }
  }
  return left;
}

struct Cell {
  Polygon corners;                ///< convex
  std::vector<std::size_t> near;  ///< cut vectors that may reach it, by their first location
};

Vec3 middleOf(const Polygon& polygon) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : polygon) {
    sum += p;
  }
  return sum / static_cast<double>(polygon.size());
}

/// Looks for a place that no cut vector reaches.
class Search {
 public:
  Search(const PocketTask& task, const Polygon& path, double reach)
      : task_(task), path_(path), reach_(reach) {}

  std::optional<Uncleared> run() {
    std::vector<std::size_t> all(path_.size() - 1);
    std::iota(all.begin(), all.end(), std::size_t{0});
    push(task_.corners, all);
    for (std::uint64_t looked = 0; !open_.empty(); ++looked) {
      Cell cell = std::move(open_.back());
      open_.pop_back();
      const Vec3 middle = middleOf(cell.corners);
      const auto away = [&](std::size_t i) {
        return spline::distanceToSegment(middle, path_[i], path_[i + 1]);
      };
      const auto nearest =
          std::min_element(cell.near.begin(), cell.near.end(),
                           [&](std::size_t a, std::size_t b) { return away(a) < away(b); });
      const bool reached = nearest != cell.near.end() && away(*nearest) <= reach_;
      if (!reached || looked >= mostCells) {
        return Uncleared{middle, nearestOfAll(middle), !reached};
      }
      if (!isReached(cell)) {
        divide(std::move(cell), middle, *nearest);
      }
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] double nearestOfAll(const Vec3& place) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
      least = std::min(least, spline::distanceToSegment(place, path_[i], path_[i + 1]));
    }
    return least;
  }

  [[nodiscard]] bool isReached(const Cell& cell) const {
    return std::any_of(cell.near.begin(), cell.near.end(), [&](std::size_t i) {
      return std::all_of(cell.corners.begin(), cell.corners.end(), [&](const Vec3& p) {
        return spline::distanceToSegment(p, path_[i], path_[i + 1]) <= reach_;
      });
    });
  }

  void push(Polygon corners, const std::vector<std::size_t>& from) {
    if (corners.size() < 3) {
      return;
    }
    const Vec3 middle = middleOf(corners);
    double around = 0.0;
    for (const Vec3& p : corners) {
      around = std::max(around, (p - middle).norm());
    }
    Cell cell{std::move(corners), {}};
    for (const std::size_t i : from) {
      if (spline::distanceToSegment(middle, path_[i], path_[i + 1]) <= reach_ + around) {
        cell.near.push_back(i);
      }
    }
    open_.push_back(std::move(cell));
  }

  /// Beside a cut vector: what its strip leaves, else halves across the cell's greatest length.
  void divide(Cell cell, const Vec3& middle, std::size_t vector) {
    const Vec3& a = path_[vector];
    const Vec3 chord = path_[vector + 1] - a;
    const double length = chord.norm();
    const double at = chord.dot(middle - a);
    if (length > 0.0 && at > 0.0 && at < length * length) {
      const Vec3 along = chord / length;
      const Vec3 aside = task_.normal.cross(along);
      const std::array<std::pair<Vec3, double>, 4> strip = {{{aside, aside.dot(a) - reach_},
                                                             {-aside, -aside.dot(a) - reach_},
                                                             {along, along.dot(a)},
                                                             {-along, -along.dot(a) - length}}};
      for (const auto& [inward, least] : strip) {
        push(cut(cell.corners, -inward, -least), cell.near);
        cell.corners = cut(cell.corners, inward, least);
      }
      return;
    }
    const Vec3* farthest = &cell.corners.front();
    const Vec3* first = farthest;
    for (const Vec3& p : cell.corners) {
      for (const Vec3& q : cell.corners) {
        if ((p - q).squaredNorm() > (*farthest - *first).squaredNorm()) {
          first = &p;
          farthest = &q;
        }
      }
    }
    const Vec3 across = (*farthest - *first).normalized();
    const double half = across.dot(0.5 * (*farthest + *first));
    push(cut(cell.corners, across, half), cell.near);
    push(cut(cell.corners, -across, -half), cell.near);
  }

  const PocketTask& task_;
  const Polygon& path_;
  double reach_;
  std::vector<Cell> open_;
};
}  // namespace

Result<PocketTask> pocketTask(const runtime::Pocket& pocket, const Modal& modal) {
  const auto& [re, general, finish, f1, f2, f3, adapts, kind] = pocket.parameters;
  if (!modal.cutter || !(modal.cutter->d > 0.0)) {
    return objection("no cutter with a radius is in force");
  }
  const double radius = modal.cutter->d / 2.0;
  std::vector<Vec3> points = pocket.points;
  if (kind >= 2.0) {
    auto on = onPart(std::move(points), modal);
    if (!on) {
      return on.takeFailure();
    }
    points = *std::move(on);
  }
  const std::size_t n = points.size();
  PocketTask task;
  task.normal = (points[1] - points[0]).cross(points[2] - points[1]).normalized();
  task.offset = task.normal.dot(points[0]);
  if (std::abs(task.normal.dot(modal.axis)) <= leastSine) {
    return objection("the tool axis lies along its bottom");
  }
  const bool walls = kind == 1.0 || kind == 3.0;
  const Vec3 up = task.normal.dot(modal.axis) < 0.0 ? Vec3(-modal.axis) : modal.axis;
  task.corners = points;
  for (std::size_t i = 0; i < n; ++i) {
    task.warp = std::max(task.warp, std::abs(task.normal.dot(points[i]) - task.offset));
    // A wall stands along the tool's axis; without walls the sides bound the tool end.
    const Vec3 along = points[(i + 1) % n] - points[i];
    const Vec3 next = points[(i + 2) % n] - points[(i + 1) % n];
    if (!(along.cross(next).dot(task.normal) > 0.0)) {
      return objection("its points bound nothing convex");
    }
    const Vec3 inward = (walls ? up : task.normal).cross(along).normalized();
    const PocketTask::Wall wall{inward, inward.dot(points[i]) + (walls ? radius : 0.0), i};
    task.walls.push_back(wall);
    if (walls) {
      task.corners = cut(task.corners, wall.inward, wall.least);
    }
  }
  if (task.corners.size() < 3) {
    return objection("its walls leave no place to the cutter");
  }
  if (adapts == 0.0) {
    constexpr double half = 0.5;
    task.reach = re > 0.0 ? re : half * general * radius;
  }
  return task;
}

bool endsWithOutline(const PocketTask& task, const std::vector<Vec3>& path, double slack) {
  std::vector<Vec3> outline;
  for (const Vec3& p : task.corners) {
    if (outline.empty() ||
        ((p - outline.back()).norm() > 2.0 * slack && (p - outline.front()).norm() > 2.0 * slack)) {
      outline.push_back(p);
    }
  }
  const std::size_t n = outline.size();
  if (path.size() <= n) {
    return false;
  }
  const auto isAt = [&](const Vec3& corner, const Vec3& p) { return (corner - p).norm() <= slack; };
  const auto last = path.end() - static_cast<std::ptrdiff_t>(n + 1);
  return isAt(*last, path.back()) &&
         std::all_of(outline.begin(), outline.end(), [&](const Vec3& c) {
           return std::any_of(last, path.end(), [&](const Vec3& p) { return isAt(c, p); });
         });
}

PocketStray offBottom(const PocketTask& task, const std::vector<Vec3>& path) {
  PocketStray found;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double away = std::abs(task.normal.dot(path[i]) - task.offset) - task.warp;
    if (away > found.away) {
      found = {i, away};
    }
  }
  return found;
}

WallStray beyondWalls(const PocketTask& task, const std::vector<Vec3>& path) {
  WallStray found;
  for (std::size_t i = 0; i < path.size(); ++i) {
    for (const PocketTask::Wall& wall : task.walls) {
      const double away = wall.least - wall.inward.dot(path[i]);
      if (away > found.away) {
        found = {{i, away}, wall.point};
      }
    }
  }
  return found;
}

std::optional<Uncleared> uncleared(const PocketTask& task,
                                   const std::vector<Vec3>& path,
                                   double slack) {
  return Search(task, path, *task.reach + slack).run();
}

}  // namespace arelem::certify
