#include "runtime/motion/startup_faults.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/ends.h"
#include "runtime/motion/told.h"

namespace arelem::motion {

Failure noPosition(const tool::Profile& cutter,
                   std::span<const StartupGoal> goals,
                   const Settled& found,
                   const Vec3& from) {
  double atFirst = 0.0;
  for (const StartupGoal& goal : goals) {
    atFirst = std::max(atFirst, std::abs(goal.field->at(from, found.axis).gap));
  }
  // Farther from the surfaces than at the beginning: from far away all of them look parallel, and
  // no hollow is near.
  const bool lost = !(found.worst <= atFirst);
  const Vec3 p = told(lost ? from : found.toolEnd);
  const auto parallel = [](const Vec3& a, const Vec3& b) {
    return a.cross(b).norm() <= tolerance::nullDirection;
  };
  // Where two surfaces are missed least they are parallel, so look at the beginning too.
  for (std::size_t i = 0; i < goals.size() && !lost; ++i) {
    const Vec3 first = goals[i].field->at(from, found.axis).normal;
    for (std::size_t k = i + 1; k < goals.size(); ++k) {
      if (parallel(found.contacts[i].normal, found.contacts[k].normal) &&
          parallel(first, goals[k].field->at(from, found.axis).normal)) {
        return fail(diag::SurfacesParallel, goals[i].surface.name, goals[k].surface.name, p.x(),
                    p.y(), p.z());
      }
    }
  }
  for (const StartupGoal& goal : goals) {
    if (goal.condition == ir::Condition::on) {
      continue;
    }
    const double hollow = hollowRadius(goal.surface.surface, goal.side, p);
    const double over = cutter.maxRadius() - hollow;
    if (over > 0.0) {
      return fail(diag::CutterDoesNotFit, cutter.maxRadius(), goal.surface.name, hollow, over,
                  p.x(), p.y(), p.z());
    }
  }
  return diverged(goals, found);
}

std::optional<Failure> behindEnd(std::span<const StartupGoal> goals,
                                 const Vec3& toolEnd,
                                 const Vec3& axis) {
  for (const StartupGoal& goal : goals) {
    const double length =
        surface::endBefore(goal.surface.surface, goal.field->at(toolEnd, axis).point);
    if (length > 0.0) {
      const Vec3 p = told(toolEnd);
      return fail(diag::StartupBehindEnd, p.x(), p.y(), p.z(), goal.surface.name, length);
    }
  }
  return std::nullopt;
}

Failure diverged(std::span<const StartupGoal> goals, const Settled& found) {
  const Vec3 p = told(found.toolEnd);
  return fail(diag::StartupDiverges, p.x(), p.y(), p.z(), found.worst,
              goals[found.worstAt].surface.name);
}

Failure offsetMisses(const NamedSurface& drive,
                     const Vec3& toolEnd,
                     const Vec3& axis,
                     const Vec3& along) {
  const auto field = makeField(drive.surface, 1.0, {});
  AxisRule fixed(axis);
  const Vec3 across = along.unitOrthogonal();
  const std::array onRay{Constraint{across, toolEnd}, Constraint{along.cross(across), toolEnd}};
  const std::array wanted{Wanted{field.get(), 0.0}};
  const Settled near = closest(toolEnd, fixed, wanted, onRay);
  const bool isBehind = (near.toolEnd - toolEnd).dot(along) < 0.0;
  const Vec3 p = told(isBehind ? toolEnd : near.toolEnd);
  return fail(diag::OffsetMisses, drive.name, std::abs(field->at(p, axis).gap), p.x(), p.y(),
              p.z());
}

}  // namespace arelem::motion
