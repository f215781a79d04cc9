#include "runtime/spray/surface/clear_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "ir/space/spray_tolerance.h"
#include "ir/space/tolerance.h"

namespace arelem::spray {

namespace {
constexpr int mostLifts = 8;        // doubled each time
constexpr double boxMargin = 1.25;  // of the clearance, about the work
constexpr double belowCosts = 3.0;  // ways below the work are as much longer
constexpr double stopCosts = 0.1;   // of the clearance: fewer places on the way are better

/// A way that is tried: from a node that has been reached to one that has not.
struct Attempt {
  double length = 0.0;  ///< at least, from begin to end
  double way = 0.0;     ///< as far as `to`
  std::size_t from = 0, to = 0;
  [[nodiscard]] bool operator>(const Attempt& other) const {
    return std::tie(length, from, to) > std::tie(other.length, other.from, other.to);
  }
};
}  // namespace

ClearWays::ClearWays(const Walls& walls, double clearance, bool strict, const Vec3& upper)
    : walls_(walls), clearance_(clearance), strict_(strict), upper_(upper) {
  low_ = high_ = walls.mesh().vertices.front();
  for (const Vec3& corner : walls.mesh().vertices) {
    low_ = low_.cwiseMin(corner);
    high_ = high_.cwiseMax(corner);
  }
  const Vec3 margin = Vec3::Constant(boxMargin * clearance + walls.blur());
  low_ -= margin;
  high_ += margin;
}

bool ClearWays::isFree(const Vec3& place, double keep) const {
  return walls_.from(place) - walls_.blur() >= keep * (1.0 + tolerance::wayStep);
}

/// The clearance of a way between two ends.
double ClearWays::keptOff(const Vec3& from, const Vec3& to) const {
  if (strict_) {
    return clearance_;
  }
  constexpr double least = 0.1;
  const double nearer = std::min(walls_.from(from), walls_.from(to)) - walls_.blur();
  const double spare = 1.0 + 2.0 * tolerance::wayStep;
  return std::clamp(nearer / spare, least * clearance_, clearance_);
}

bool ClearWays::isClear(const Vec3& from, const Vec3& to, double keep) const {
  if (walls_.between(from, to)) {
    return false;
  }
  const double length = (to - from).norm();
  for (double way = 0.0; way < length;) {
    const Vec3 place = from + way / length * (to - from);
    const double spare = walls_.from(place) - walls_.blur() - keep;
    if (spare < tolerance::wayStep * keep) {
      return false;
    }
    way += spare;
  }
  return isFree(to, keep);
}

double ClearWays::nearestOn(const Vec3& from, const Vec3& to) const {
  if (walls_.between(from, to)) {
    return 0.0;
  }
  const double length = (to - from).norm();
  double least = HUGE_VAL;
  for (double way = 0.0; way < length; way += tolerance::wayStep * clearance_) {
    least = std::min(least, walls_.from(from + way / length * (to - from)));
  }
  return std::min(least, walls_.from(to));
}

GunPose ClearWays::facing(const Vec3& place) const {
  return {place, (place - walls_.nearest(place)).normalized()};
}

/// The end itself, places along its axis as far as no wall stands there, and where these lie
/// straight before the sides of the box.
void ClearWays::addOver(const GunPose& end,
                        int number,
                        double keep,
                        std::vector<Node>& nodes) const {
  nodes.push_back({end, number, 0.0});
  const double farthest = (high_ - low_).norm() + 2.0 * (end.place - (low_ + high_) / 2.0).norm();
  const double lift = std::min(walls_.blur() + tolerance::wallTouch, clearance_);
  const auto wall = walls_.between(end.place + lift * end.axis, end.place + farthest * end.axis);
  std::vector<double> lifts = {0.0};
  if (wall) {
    lifts.push_back((lift + *wall) / 2.0);
  }
  double height = clearance_;
  for (int i = 0; i < mostLifts && height < wall.value_or(farthest); ++i, height *= 2.0) {
    lifts.push_back(height);
  }
  for (const double up : lifts) {
    const Vec3 over = end.place + up * end.axis;
    if (!isFree(over, keep)) {
      continue;
    }
    if (up > 0.0) {
      nodes.push_back({{over, end.axis}, number, up});
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      for (const double side : {low_[axis], high_[axis]}) {
        Vec3 before = over;
        before[axis] = side;
        nodes.push_back({facing(before), 0, 0.0});
      }
    }
  }
}

/// Corners of the box about the work, the middles of its edges and of its sides.
void ClearWays::addAround(std::vector<Node>& nodes) const {
  const Vec3 middle = (low_ + high_) / 2.0;
  const std::array<Vec3, 3> steps = {low_, middle, high_};
  for (std::size_t i = 0; i < 27; ++i) {
    const Vec3 place(steps[i / 9].x(), steps[i / 3 % 3].y(), steps[i % 3].z());
    if (place != middle) {
      nodes.push_back({facing(place), 0, 0.0});
    }
  }
}

/// Along the axis of an end the work is as near as on its line; elsewhere it must be far enough.
bool ClearWays::mayGo(const Node& from, const Node& to, double keep) const {
  if (from.end != 0 && from.end == to.end && (from.lift == 0.0 || to.lift == 0.0)) {
    return true;  // up to a wall nothing stands there
  }
  return isClear(from.pose.place, to.pose.place, keep);
}

std::optional<std::vector<GunPose>> ClearWays::between(const GunPose& from,
                                                       const GunPose& to) const {
  const double keep = keptOff(from.place, to.place);
  if (isClear(from.place, to.place, keep)) {
    return std::vector<GunPose>();
  }
  std::vector<Node> nodes;
  addOver(to, 2, keep, nodes);
  const std::size_t first = nodes.size();
  addOver(from, 1, keep, nodes);
  addAround(nodes);
  constexpr std::size_t goal = 0;
  constexpr std::size_t none = SIZE_MAX;
  const auto distance = [&nodes](std::size_t a, std::size_t b) {
    return (nodes[a].pose.place - nodes[b].pose.place).norm();
  };
  std::vector<std::size_t> before(nodes.size(), none);
  std::vector<bool> reached(nodes.size(), false);
  std::priority_queue<Attempt, std::vector<Attempt>, std::greater<>> attempts;
  const double lowest = std::min(upper_.dot(from.place), upper_.dot(to.place));
  const auto reach = [&](std::size_t node, double way) {
    reached[node] = true;
    for (std::size_t next = 0; next < nodes.size(); ++next) {
      if (!reached[next]) {
        const double below = std::max(0.0, lowest - upper_.dot(nodes[next].pose.place));
        const double length =
            way + distance(node, next) + stopCosts * clearance_ + belowCosts * below;
        attempts.push({length + distance(next, goal), length, node, next});
      }
    }
  };
  reach(first, 0.0);
  while (!attempts.empty() && !reached[goal]) {
    const Attempt attempt = attempts.top();
    attempts.pop();
    if (!reached[attempt.to] && mayGo(nodes[attempt.from], nodes[attempt.to], keep)) {
      before[attempt.to] = attempt.from;
      reach(attempt.to, attempt.way);
    }
  }
  if (!reached[goal]) {
    return std::nullopt;
  }
  std::vector<GunPose> poses;
  for (std::size_t node = before[goal]; node != first; node = before[node]) {
    poses.push_back(nodes[node].pose);
  }
  std::reverse(poses.begin(), poses.end());
  return poses;
}

}  // namespace arelem::spray
