#include "runtime/motion/startup_sense.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/certify/motion_check.h"
#include "runtime/motion/pierce.h"
#include "runtime/motion/route.h"
#include "runtime/motion/tilt.h"
#include "runtime/motion/told.h"

namespace arelem::motion {

namespace {
/// Share of the way to the first surface that a directed startup goes before it iterates.
constexpr double approachShare = 0.75;
}  // namespace

bool allPlanes(std::span<const StartupGoal> goals) {
  return std::all_of(goals.begin(), goals.end(),
                     [](const StartupGoal& goal) { return goal.surface.isPlane(); });
}

Led leadOf(const State& state, std::span<const StartupGoal> goals) {
  Led led{state.toolEnd, {}};
  double farthest = 0.0;
  for (const StartupGoal& goal : goals) {
    farthest = std::max(farthest, std::abs(footOn(goal.surface.surface, led.toolEnd).distance));
  }
  Vec3 beyond = Vec3::Zero();
  for (std::size_t i = 0; i < goals.size(); ++i) {
    if (!state.direction[i]) {
      continue;
    }
    const Vec3 v = state.direction[i]->normalized();
    const auto hitFrom = [&](const Vec3& place) {
      return pierce(goals[i].surface.surface, sidePoint(state, place, state.axis), v);
    };
    const auto hit = hitFrom(led.toolEnd);
    if (hit) {
      const double radius = goals[i].condition == ir::Condition::on ? 0.0 : state.cutter->d / 2;
      const double way = *hit - radius - state.band(goals[i].role);
      led.toolEnd += (allPlanes(goals) ? approachShare : 1.0) * std::max(way, 0.0) * v;
    } else if (!hitFrom(state.toolEnd)) {
      beyond += farthest * v;
    }
  }
  if (!beyond.isZero(0.0)) {
    led.beyond = led.toolEnd + beyond;
  }
  return led;
}

Vec3 pathOf(std::span<const StartupGoal> goals, const Vec3& near, const Vec3& axis) {
  if (goals.size() < 2) {
    return Vec3::Zero();
  }
  const Vec3 way =
      goals[0].field->at(near, axis).normal.cross(goals[1].field->at(near, axis).normal);
  return way.norm() > tolerance::nullDirection ? Vec3(way.normalized()) : Vec3(Vec3::Zero());
}

std::optional<Vec3> guidePlane(std::span<const StartupGoal> goals,
                               const Vec3& direction,
                               std::size_t given,
                               const Place& led,
                               const Place& start) {
  const bool noPlane = std::none_of(goals.begin(), goals.end(),
                                    [](const StartupGoal& goal) { return goal.surface.isPlane(); });
  if (noPlane) {
    return std::nullopt;
  }
  const Vec3 there = goals[given].field->at(led.toolEnd, led.axis).normal;
  const Vec3 here = goals[1 - given].field->at(start.toolEnd, start.axis).normal;
  const Vec3 path = there.cross(here);
  const Vec3 along = direction.normalized();
  const Vec3 normal = withinPlane(along, path);
  return normal.norm() > tolerance::nullDirection ? std::optional<Vec3>(normal.normalized())
                                                  : std::nullopt;
}

Sense senseOf(
    const State& state, const Vec3& direction, const Vec3& toolEnd, Role role, bool flat) {
  const auto seen = [&](const Vec3& v) {
    return flat ? Vec3(v - v.dot(state.axis) * state.axis) : v;
  };
  const Vec3 way = seen(toolEnd - state.toolEnd);
  const Vec3 wish = seen(direction);
  if (wish.norm() <= tolerance::nullDirection * direction.norm()) {
    return {};
  }
  const double along = way.dot(wish) / wish.norm();
  if (-along <= std::max(state.band(role), tolerance::sameSide)) {
    return {};
  }
  return {-along, std::acos(std::clamp(along / way.norm(), -1.0, 1.0)) * 180.0 / std::numbers::pi};
}

Failure behind(const LedTo& goal, const Vec3& toolEnd, const Sense& sense) {
  const Vec3 p = told(toolEnd);
  return fail(diag::StartupBehind, certify::spell(goal.condition), goal.surface, p.x(), p.y(),
              p.z(), sense.back);
}

Failure turnsBack(const LedTo& goal, const Sense& sense) {
  return fail(diag::StartupTurnsBack, sense.degrees, goal.surface);
}

}  // namespace arelem::motion
