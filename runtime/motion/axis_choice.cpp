#include "runtime/motion/axis_choice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"

namespace arelem::motion {

namespace {
using Kind = runtime::ToolAxis::Kind;
constexpr double degree = std::numbers::pi / 180.0;
constexpr int partNumber = 1;  ///< of TLAXIS/PARLEL and ATANGL; 2 is the drive surface

/// `facing`: where the tool end is on the surface, the side to which its normal points.
AngleSide angleSide(const AxisParty& party, double facing) {
  auto field = party.on ? makeField(party.surface->surface, facing, {}) : party.contact();
  return {std::move(field), party.on, party.surface->name, party.side,
          makeField(party.surface->surface, party.side, {})};
}

/// The side of a surface on which the axis is; where it lies in the surface, that away from which
/// the tool comes, if it is not there yet, else the one to which the normal points.
double sideOfAxis(const surface::Foot& foot, const Vec3& axis, double slack) {
  const double dot = foot.normal.dot(axis);
  const double counts = std::abs(dot) > tolerance::symmetric ? dot
                        : std::abs(foot.distance) > slack    ? -foot.distance
                                                             : 1.0;
  return counts < 0.0 ? -1.0 : 1.0;
}

/// A tool whose end is on the surface that does not control has no side of it: its normal counts on
/// the side on which the axis is, if it is there with these angles too; else on that on which it
/// then is. Where neither holds, as it is defined. The motion keeps that side. Four axes may hardly
/// be able to follow that normal: towards it they take the first side.
double facingOf(const Tilt& tilt,
                const AxisParty& control,
                const AxisParty& other,
                const State& state,
                const Vec3& forward) {
  if (!other.on) {
    return 1.0;
  }
  const surface::Foot foot = footOn(other.surface->surface, state.toolEnd);
  const double slack =
      std::max(state.band(driveRole), state.band(partRole)) + tolerance::startLength;
  double side = sideOfAxis(foot, state.axis, slack);
  if (tilt.across && tilt.alpha >= 0.0) {
    return side;
  }
  const AngleSide from = angleSide(control, 1.0);
  Vec3 up = from.field->at(state.toolEnd, state.axis).normal;
  up *= control.on && up.dot(state.axis) < 0.0 ? -1.0 : 1.0;
  const Vec3 common = up.cross(foot.normal);
  const Vec3 ahead = common.dot(forward) < 0.0 ? Vec3(-common) : common;
  for (int tries = 0; tries < 2; ++tries) {
    const auto axis = tilted(tilt, up, side * foot.normal, ahead);
    const double then = axis ? sideOfAxis(foot, *axis, slack) : side;
    if (then == side) {
      return side;
    }
    side = then;
  }
  return 1.0;
}

Tilt tiltOf(const runtime::ToolAxis& axis) {
  Tilt tilt;
  tilt.alpha = axis.alphaDegrees * degree;
  if (axis.cutAngleDegrees) {
    tilt.lead = *axis.cutAngleDegrees * degree;
  }
  if (axis.fourAxis) {
    tilt.across = axis.vector.normalized();
  }
  return tilt;
}
}  // namespace

Result<AxisRule> chooseAxis(const State& state,
                            const AxisParty* part,
                            const AxisParty& drive,
                            const Vec3& forward) {
  const runtime::ToolAxis& axis = state.axisRule;
  if (axis.kind == Kind::vector || axis.kind == Kind::keep) {
    return AxisRule(state.axis);
  }
  const bool byPart = axis.kind == Kind::normalPart ||
                      (axis.kind != Kind::normalDrive && axis.surface == partNumber);
  if (part == nullptr && (byPart || axis.kind == Kind::angle)) {
    return fail(diag::AxisNeedsSurface, axis.kind == Kind::angle      ? "ATANGL"
                                        : axis.kind == Kind::parallel ? "PARLEL"
                                                                      : "NORMPS");
  }
  const AxisParty& control = byPart ? *part : drive;
  if (axis.kind == Kind::angle) {
    const AxisParty& other = byPart ? drive : *part;
    const Tilt tilt = tiltOf(axis);
    const double facing = facingOf(tilt, control, other, state, forward);
    return AxisRule(
        atAngle(tilt, angleSide(control, 1.0), angleSide(other, facing), state.axis, forward));
  }
  if (axis.kind == Kind::parallel) {
    auto source =
        alongRulings(control.surface->surface, control.surface->name, state.toolEnd, state.axis);
    return source ? Result<AxisRule>(AxisRule(*std::move(source)))
                  : Result<AxisRule>(source.takeFailure());
  }
  return AxisRule(normalTo(control.surface->surface, control.side));
}

}  // namespace arelem::motion
