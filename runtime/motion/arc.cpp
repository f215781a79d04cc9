#include "runtime/motion/arc.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "ir/diag/curves.h"
#include "ir/diag/motion.h"
#include "ir/space/motion_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/motion/written_unit.h"

namespace arelem::motion {

namespace {
constexpr double fullTurn = 2.0 * std::numbers::pi;
constexpr double degree = std::numbers::pi / 180.0;
/// Ends that are farther off than this, and this share of the radius, belong to another arc.
constexpr double worst = 20.0 * tolerance::arcEnd;
constexpr double worstShare = 0.001;
/// A stated angle may differ from that of the ends by so much, in degrees.
constexpr double angleSlack = 0.5;
constexpr int mostTurns = 10'000;

/// The circle seen along its axis.
class Circle {
 public:
  Circle(const Vec3& center, const Vec3& axis) : center_(center), axis_(axis) {}
  [[nodiscard]] double height(const Vec3& p) const { return (p - center_).dot(axis_); }
  [[nodiscard]] Vec3 radial(const Vec3& p) const { return p - center_ - height(p) * axis_; }
  /// From 0 up to a full turn, which is what coinciding ends are.
  [[nodiscard]] double sweep(const Vec3& start, const Vec3& end) const {
    const Vec3 a = radial(start);
    const Vec3 b = radial(end);
    if ((b - a).norm() <= tolerance::symmetric * (1.0 + a.norm())) {
      return fullTurn;
    }
    const double angle = std::atan2(axis_.dot(a.cross(b)), a.dot(b));
    return angle <= 0.0 ? angle + fullTurn : angle;
  }

 private:
  Vec3 center_, axis_;
};

Result<Vec3> axisOf(const runtime::Arc& arc,
                    const Vec3& start,
                    const std::optional<Vec3>& forward) {
  Vec3 axis = arc.axis.value_or(Vec3::Zero());
  if (!arc.axis) {
    if (!forward) {
      return fail(diag::NoForwardDirection);
    }
    axis = (start - arc.center).cross(*forward);
  }
  const double length = axis.norm();
  if (length <= tolerance::nullDirection) {
    return fail(diag::ArcAxis, length);
  }
  return writtenUnit(axis);
}

/// The total turn, by the stated angle and whole turns where they are given.
double totalSweep(const runtime::Arc& arc, double between, std::vector<Failure>& warnings) {
  if (arc.sweepDegrees) {
    const double stated = std::abs(*arc.sweepDegrees) * degree;
    const double turns = std::round((stated - between) / fullTurn);
    const double total = between + std::max(turns, between == fullTurn ? -1.0 : 0.0) * fullTurn;
    if (std::abs(total - stated) > angleSlack * degree) {
      warnings.push_back(fail(diag::ArcAngle, *arc.sweepDegrees, between / degree));
      return between;
    }
    return total;
  }
  return between + arc.turns * fullTurn;
}

cl::Surface surfaceOf(const Vec3& center, const Vec3& axis, double radius) {
  constexpr int drive = 2;
  constexpr double upright = 1.0 - 1e-15;
  const auto type = std::abs(axis.z()) >= upright ? EntityType::circle : EntityType::cylinder;
  return {
      drive,
      0,
      {type, "", 0, {center.x(), center.y(), center.z(), axis.x(), axis.y(), axis.z(), radius}}};
}
}  // namespace

Result<ArcMove> arcMove(const runtime::Arc& arc,
                        const Vec3& start,
                        const Vec3& end,
                        const std::optional<Vec3>& forward) {
  const Result<Vec3> found = axisOf(arc, start, forward);
  if (!found) {
    return Result<Vec3>(found).takeFailure();
  }
  const Vec3 axis = *found;
  const Circle circle(arc.center, axis);
  const double first = circle.radial(start).norm();
  const double last = circle.radial(end).norm();
  const double radius = arc.radius.value_or(first);
  const double off = std::max(std::abs(first - radius), std::abs(last - radius));
  if (!(radius > tolerance::coincidence) || off > worst + worstShare * radius) {
    return fail(diag::ArcEnds, first, last, radius);
  }
  if (arc.turns < 0 || arc.turns > mostTurns) {
    return fail(diag::ArcTurns, arc.turns, mostTurns);
  }
  const double stated = std::abs(arc.sweepDegrees.value_or(0.0)) * degree / fullTurn;
  if (stated > mostTurns + 1.0) {
    constexpr double mostTold = 1e9;  // an int holds it
    return fail(diag::ArcTurns, static_cast<int>(std::min(stated, mostTold)), mostTurns);
  }
  ArcMove move;
  if (off > tolerance::arcEnd) {
    move.warnings.push_back(fail(diag::ArcOff, first, last, radius));
  }
  const double total = totalSweep(arc, circle.sweep(start, end), move.warnings);
  const double rise = circle.height(end) - circle.height(start);
  const auto whole = static_cast<int>(std::ceil(total / fullTurn - tolerance::symmetric)) - 1;
  for (int k = 0; k <= whole; ++k) {
    const Vec3 from = start + axis * (rise * k * fullTurn / total);
    // Where the center is at the height of the start, it stays as it is written.
    const double height = circle.height(from);
    const bool level = std::abs(height) <= tolerance::symmetric * (1.0 + from.norm());
    const Vec3 center = level ? arc.center : Vec3(arc.center + axis * height);
    const Vec3 to = k == whole ? end : Vec3(start + axis * (rise * (k + 1) * fullTurn / total));
    move.pieces.push_back({surfaceOf(center, axis, radius), to});
  }
  move.length = std::hypot(total * radius, rise);
  move.tangent = axis.cross(circle.radial(end)).normalized() * (total * radius) + rise * axis;
  return move;
}

}  // namespace arelem::motion
