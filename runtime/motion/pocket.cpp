#include "runtime/motion/pocket.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/motion/convex_inset.h"
#include "runtime/motion/route.h"

namespace arelem::motion {

namespace {
/// Sine of the smallest angle between tool axis and part surface along which points are projected:
/// 12 degrees (3507).
const double leastProjection = std::sin(12.0 * std::numbers::pi / 180.0);
/// Halvings in the search for the longest step that leaves nothing between two passes.
constexpr int halvings = 50;
constexpr int passLimit = 10000;

bool wholeWithin(double value, int most) {
  return value == std::floor(value) && value >= 0.0 && value <= most;
}

Result<PocketOrder> orderOf(const std::array<double, 8>& v) {
  const auto& [reach, general, finish, plunge, cutting, last, o, p] = v;
  if (!(reach > 0.0)) {
    return fail(diag::PocketReach, reach);
  }
  if (!(general > 0.0)) {
    return fail(diag::PocketStep, general);
  }
  if (finish < 0.0) {
    return fail(diag::PocketFinish, finish);
  }
  for (const double feed : {plunge, cutting, last}) {
    if (feed < 0.0) {
      return fail(diag::PocketFeed, feed);
    }
  }
  if (!wholeWithin(o, 1)) {
    return fail(diag::PocketStepRule, o);
  }
  if (!wholeWithin(p, 3)) {
    return fail(diag::PocketPointRule, p);
  }
  return PocketOrder{
      reach, general, finish, plunge, cutting, last, o == 1.0, p == 1.0 || p == 3.0, p >= 2.0};
}

/// The plane of the pocket with its own coordinates.
struct Floor {
  Vec3 origin, e1, e2;
  [[nodiscard]] Vec2 flat(const Vec3& p) const {
    return {(p - origin).dot(e1), (p - origin).dot(e2)};
  }
  [[nodiscard]] Vec3 place(const Vec2& p) const { return origin + p.x() * e1 + p.y() * e2; }
};

/// The points moved along the tool axis onto the part surface.
std::optional<Failure> project(const State& state, std::vector<Vec3>& points) {
  const NamedSurface part = partSurface(state);
  const auto* plane = std::get_if<surface::Plane>(&part.surface);
  if (plane == nullptr) {
    return fail(diag::PocketNotPlane, part.name);
  }
  const double rate = plane->normal.dot(state.axis);
  if (std::abs(rate) < leastProjection) {
    return fail(diag::PocketAxis, std::asin(std::abs(rate)) * 180.0 / std::numbers::pi, part.name);
  }
  for (Vec3& p : points) {
    p += (plane->offset - plane->normal.dot(p)) / rate * state.axis;
  }
  return std::nullopt;
}

/// Finds the plane and checks that the points make a convex polygon in it. The normal is on the
/// side from which they run counterclockwise.
Result<Floor> floorOf(const std::vector<Vec3>& points) {
  const std::size_t count = points.size();
  Vec3 area = Vec3::Zero();
  double size = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& next = points[(i + 1) % count];
    for (std::size_t k = 0; k < i; ++k) {
      if ((points[i] - points[k]).norm() <= tolerance::coincidence) {
        return fail(diag::PocketDuplicate, static_cast<int>(k + 1), static_cast<int>(i + 1));
      }
    }
    area += (points[i] - points[0]).cross(next - points[0]);
    size = std::max(size, (points[i] - points[0]).norm());
  }
  const Vec3 normal = area.norm() > 0.0 ? Vec3(area.normalized()) : Vec3(Vec3::UnitZ());
  const Vec3 e1 = (points[1] - points[0]).normalized();
  for (std::size_t i = 0; i < count; ++i) {
    const double off = normal.dot(points[i] - points[0]);
    if (std::abs(off) > tolerance::coincidence * (1.0 + size)) {
      return fail(diag::PocketNotFlat, static_cast<int>(i + 1), off);
    }
    const Vec3 before = (points[i] - points[(i + count - 1) % count]).normalized();
    const Vec3 after = (points[(i + 1) % count] - points[i]).normalized();
    const double turn = before.cross(after).dot(normal);
    if (std::abs(turn) <= tolerance::perpendicular) {
      return fail(diag::PocketStraight, static_cast<int>(i + 1));
    }
    if (turn < 0.0) {
      return fail(diag::PocketConcave, static_cast<int>(i + 1));
    }
  }
  return Floor{points[0], e1, normal.cross(e1)};
}

/// Lays the passes from the outline inwards.
class Layout {
 public:
  Layout(const PocketOrder& order, double radius, const ConvexInset& outline)
      : order_(order), radius_(radius), outline_(outline) {}

  /// Distances of the passes from the points, from the outer one inwards.
  std::vector<double> run() {
    std::vector<double> at{order_.wall ? radius_ : 0.0};
    const double most = slack();
    double wanted = order_.finish * radius_;
    while (outline_.depth() - at.back() > order_.reach + most || wanted == 0.0) {
      double step = order_.fixedSteps ? wanted : covering(at.back(), wanted);
      const double room = outline_.depth() - at.back();
      if (at.size() > 1 && room - 0.5 * step <= order_.reach + most) {
        step *= 0.5;
      }
      if (step >= room) {
        step = std::max(room - order_.reach, 0.5 * room);
      }
      const double missed = missedBetween(at.back(), step);
      missed_ = missed > 2.0 * most ? std::max(missed_, missed) : missed_;
      at.push_back(at.back() + step);
      wanted = order_.general * radius_;
    }
    return at;
  }
  [[nodiscard]] double missed() const { return missed_; }

 private:
  [[nodiscard]] double slack() const { return tolerance::coincidence * order_.reach; }

  /// What the cutter clears neither on the pass at `from` nor on the next one: the points at Re
  /// from the one, of which a corner is the farthest from the other.
  [[nodiscard]] double missedBetween(double from, double step) const {
    const auto between = outline_.at(from + order_.reach);
    const auto next = outline_.at(from + step);
    double most = 0.0;
    if (step > order_.reach && between && next) {
      for (const Vec2& corner : *between) {
        most = std::max(most, distanceTo(*next, corner) - order_.reach);
      }
    }
    return most;
  }

  /// The wanted step, or the longest that leaves nothing between the passes.
  [[nodiscard]] double covering(double from, double wanted) const {
    const auto covers = [&](double step) {
      return from + step < outline_.depth() && missedBetween(from, step) <= slack();
    };
    if (wanted <= order_.reach || covers(wanted)) {
      return wanted;
    }
    double low = order_.reach;
    double high = wanted;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (low + high);
      (covers(middle) ? low : high) = middle;
    }
    return low;
  }

  const PocketOrder& order_;
  double radius_;
  const ConvexInset& outline_;
  double missed_ = 0.0;
};
}  // namespace

Result<PocketPlan> planPocket(const State& state, const runtime::Pocket& pocket) {
  if (!state.cutter) {
    return fail(diag::CutterUndefined);
  }
  const double radius = 0.5 * state.cutter->d;
  if (!(radius > 0.0)) {
    return fail(diag::PocketCutter, state.cutter->d);
  }
  auto order = orderOf(pocket.parameters);
  if (!order) {
    return order.takeFailure();
  }
  std::vector<Vec3> points = pocket.points;
  if (order->projected) {
    if (auto bad = project(state, points)) {
      return *std::move(bad);
    }
  }
  auto floor = floorOf(points);
  if (!floor) {
    return floor.takeFailure();
  }
  std::vector<Vec2> outline;
  for (const Vec3& p : points) {
    outline.push_back(floor->flat(p));
  }
  const ConvexInset inset(outline);
  if (order->wall && inset.depth() <= radius) {
    return fail(diag::PocketTooSmall, radius, inset.depth());
  }
  const double step = order->general * radius;
  if (inset.depth() > passLimit * std::min(step, order->reach)) {
    return fail(diag::PocketPasses, std::min(step, order->reach), passLimit, inset.depth());
  }
  PocketPlan plan{*order, {}, 0.0};
  Layout layout(plan.order, radius, inset);
  const std::vector<double> distances = layout.run();
  plan.missed = layout.missed();
  for (auto d = distances.rbegin(); d != distances.rend(); ++d) {
    std::vector<Vec3>& pass = plan.passes.emplace_back();
    const auto polygon = inset.at(*d);
    for (const Vec2& p : polygon ? *polygon : std::vector<Vec2>{}) {
      pass.push_back(floor->place(p));
    }
  }
  return plan;
}

}  // namespace arelem::motion
