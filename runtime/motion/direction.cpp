#include "runtime/motion/direction.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/motion/told.h"

namespace arelem::motion {

namespace {
/// Cosine of 88 degrees, as the old system has it: nearer to square than this a GO word does not
/// decide.
constexpr double leastCosine = 0.0349;

/// The words that turn onto a path to which one is square.
std::string_view others(ir::Heading heading) {
  switch (heading) {
    case ir::Heading::left:
    case ir::Heading::right:
      return "GOFWD and GOBACK go along the path from here";
    case ir::Heading::forward:
    case ir::Heading::back:
      return "GOLFT and GORGT go along the path from here";
    default:
      return "GOUP and GODOWN go along the axis only; the path from here goes across it";
  }
}
}  // namespace

std::string_view spell(ir::Heading heading) {
  switch (heading) {
    case ir::Heading::left:
      return "GOLFT";
    case ir::Heading::right:
      return "GORGT";
    case ir::Heading::forward:
      return "GOFWD";
    case ir::Heading::back:
      return "GOBACK";
    case ir::Heading::up:
      return "GOUP";
    case ir::Heading::down:
      return "GODOWN";
  }
  return "";
}

Result<Vec3> wantedDirection(ir::Heading heading,
                             const std::optional<Vec3>& forward,
                             const std::optional<Vec3>& lastAcross,
                             const Vec3& axis) {
  if (heading == ir::Heading::up) {
    return axis;
  }
  if (heading == ir::Heading::down) {
    return Vec3(-axis);
  }
  const auto isAcross = [&](const std::optional<Vec3>& v) {
    return v && v->cross(axis).norm() > tolerance::nullDirection * v->norm();
  };
  const auto& chosen = isAcross(forward) ? forward : lastAcross;
  if (!isAcross(chosen)) {
    return fail(diag::NoForwardDirection);
  }
  const Vec3 right = chosen->cross(axis).normalized();
  const Vec3 ahead = axis.cross(right).normalized();
  switch (heading) {
    case ir::Heading::left:
      return Vec3(-right);
    case ir::Heading::right:
      return right;
    case ir::Heading::back:
      return Vec3(-ahead);
    default:
      return ahead;
  }
}

Result<Vec3> startDirection(ir::Heading heading,
                            const Vec3& wanted,
                            const Vec3& partNormal,
                            const Vec3& driveNormal,
                            const Vec3& toolEnd) {
  const Vec3 common = partNormal.cross(driveNormal);
  if (common.norm() <= tolerance::nullDirection) {
    return wanted;
  }
  const Vec3 tangent = common.normalized();
  const double cosine = tangent.dot(wanted);
  if (std::abs(cosine) <= leastCosine) {
    const double degrees = std::acos(std::abs(cosine)) * 180.0 / std::numbers::pi;
    const Vec3 p = told(toolEnd);
    return fail(diag::PerpendicularDirection, spell(heading), degrees, p.x(), p.y(), p.z())
        .withHelp(std::string(others(heading)));
  }
  return Vec3(cosine > 0.0 ? tangent : Vec3(-tangent));
}

}  // namespace arelem::motion
