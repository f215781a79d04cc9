#include "runtime/smooth/polygon.h"

#include <algorithm>

#include "ir/space/tolerance.h"

namespace arelem::smooth {

namespace {

/// Weight of the apex in the direction of other smooth points, eq. 3-31.
constexpr double apexWeight = 9.0;

Vec3 unitOrNull(const Vec3& v) {
  const double length = v.norm();
  return length > tolerance::symmetric ? Vec3(v / length) : Vec3::Zero();
}

/// Distance vector of x from the line through p and q.
Vec3 across(const Vec3& p, const Vec3& q, const Vec3& x) {
  const Vec3 along = unitOrNull(q - p);
  const Vec3 to = x - p;
  return to - along.dot(to) * along;
}

class Polygon {
 public:
  Polygon(std::span<const Vec3> points, bool closed) : points_(points), closed_(closed) {}

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] bool closed() const { return closed_; }
  /// The point `step` after i.
  [[nodiscard]] const Vec3& at(std::size_t i, int step = 0) const {
    const auto n = static_cast<std::ptrdiff_t>(points_.size());
    const auto k = (static_cast<std::ptrdiff_t>(i) + step) % n;
    return points_[static_cast<std::size_t>(k < 0 ? k + n : k)];
  }
  /// Whether the neighbors of both legs at i lie on one side of each: a bend, no ripple.
  [[nodiscard]] bool bends(std::size_t i) const {
    const std::size_t n = points_.size();
    if (!closed_ && (n < 5 || i < 2 || i + 2 >= n)) {
      return false;
    }
    return oneSide(at(i, -1), at(i), at(i, -2), at(i, 1)) &&
           oneSide(at(i), at(i, 1), at(i, -1), at(i, 2));
  }
  /// unit(unit(P[i-1] - P[i]) + unit(P[i+1] - P[i])); null where the polygon is straight.
  [[nodiscard]] Vec3 bisector(std::size_t i) const {
    return unitOrNull(unitOrNull(at(i, -1) - at(i)) + unitOrNull(at(i, 1) - at(i)));
  }

 private:
  static bool oneSide(const Vec3& p, const Vec3& q, const Vec3& x, const Vec3& y) {
    const Vec3 a = across(p, q, x);
    const Vec3 b = across(p, q, y);
    return a.norm() > tolerance::symmetric && b.norm() > tolerance::symmetric && a.dot(b) > 0.0;
  }

  std::span<const Vec3> points_;
  bool closed_;
};

/// Scans left to right: a point that is no bend by itself and not the first of the running group
/// closes it (fig. 3-9).
void findGroups(const Polygon& polygon, const std::vector<bool>& bends, Categories& result) {
  const std::size_t n = polygon.size();
  std::size_t start = 0;
  std::size_t count = n;
  if (polygon.closed()) {
    // From a point that is not smooth on, once round; a polygon without one has no groups.
    const auto first = std::find_if(result.of.begin(), result.of.end(),
                                    [](Category c) { return c != Category::smooth; });
    if (first == result.of.end()) {
      return;
    }
    start = static_cast<std::size_t>(first - result.of.begin());
  }
  bool open = false;
  Group running;
  const auto close = [&](std::size_t last) {
    running.last = last;
    if (running.size() >= 3) {
      result.groups.push_back(running);
    } else {
      for (std::size_t i = running.first; i <= last; ++i) {
        result.of[i % n] = Category::ripple;
      }
    }
    open = false;
  };
  for (std::size_t i = start; i < start + count; ++i) {
    if (result.of[i % n] != Category::smooth) {
      if (open) {
        close(i - 1);
      }
      continue;
    }
    if (!open) {
      running.first = i;
      open = true;
    } else if (!bends[i % n]) {
      close(i);
    }
  }
  if (open) {
    close(start + count - 1);
  }
}

/// At the end e with the neighbors n1, n2: across the original leg, towards the line n1 n2.
Vec3 endDirection(const Vec3& e, const Vec3& n1, const Vec3& n2, const Vec3& originalLeg) {
  const Vec3 leg = unitOrNull(n2 - n1);
  const Vec3 side = leg.cross(e - n1);  // its length is the distance of e from the line
  if (side.norm() <= tolerance::symmetric) {
    return Vec3::Zero();
  }
  return unitOrNull(unitOrNull(originalLeg).cross(side));
}

}  // namespace

std::string Categories::letters() const {
  std::string text;
  for (const Category c : of) {
    text += static_cast<char>(c);
  }
  return text;
}

Categories categories(std::span<const Vec3> points, bool closed) {
  const Polygon polygon(points, closed);
  const std::size_t n = points.size();
  std::vector<bool> bends(n);
  Categories result{std::vector<Category>(n, Category::ripple), {}};
  for (std::size_t i = 0; i < n; ++i) {
    bends[i] = polygon.bends(i);
    if (bends[i]) {
      for (const std::size_t k : {i + n - 1, i, i + 1}) {
        result.of[k % n] = Category::smooth;
      }
    }
  }
  if (!closed) {
    result.of.front() = result.of.back() = Category::end;
  }
  findGroups(polygon, bends, result);
  return result;
}

std::vector<Vec3> directions(std::span<const Vec3> points,
                             std::span<const Vec3> original,
                             const Categories& categories,
                             bool closed) {
  const Polygon polygon(points, closed);
  const std::size_t n = points.size();
  std::vector<Vec3> result(n);
  for (std::size_t i = 0; i < n; ++i) {
    result[i] = categories.of[i] == Category::end ? Vec3::Zero() : polygon.bisector(i);
  }
  for (const Group& group : categories.groups) {
    const std::size_t apex = group.first + (group.size() - 1) / 2;
    Vec3 direction = polygon.bisector(apex);
    std::size_t lastApex = apex;
    if (group.size() % 2 == 0) {
      lastApex = apex + 1;
      direction = unitOrNull(across(polygon.at(apex), polygon.at(lastApex), polygon.at(apex, 2)));
    }
    for (std::size_t i = group.first; i <= group.last; ++i) {
      const bool isApex = i == apex || i == lastApex;
      result[i % n] = isApex ? direction : unitOrNull(apexWeight * direction - polygon.bisector(i));
    }
  }
  if (!closed) {
    result.front() = endDirection(points[0], points[1], points[2], Vec3(original[1] - original[0]));
    result.back() = endDirection(points[n - 1], points[n - 2], points[n - 3],
                                 Vec3(original[n - 2] - original[n - 1]));
  }
  return result;
}

std::vector<double> moves(std::span<const double> sensitivity, double distance) {
  std::vector<double> result;
  double most = 0.0;
  for (const double s : sensitivity) {
    result.push_back(s > 0.0 ? 1.0 / s : 1.0);
    most = std::max(most, result.back());
  }
  for (double& move : result) {
    move *= distance / most;
  }
  return result;
}

}  // namespace arelem::smooth
