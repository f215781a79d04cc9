#include "runtime/motion/axis_choice.h"

#include <numbers>

#include "ir/diag/motion.h"

namespace arelem::motion {

namespace {
using Kind = runtime::ToolAxis::Kind;
constexpr double degree = std::numbers::pi / 180.0;
constexpr int partNumber = 1;  ///< of TLAXIS/PARLEL and ATANGL; 2 is the drive surface

AngleSide angleSide(const AxisParty& party) {
  auto field = party.on ? makeField(party.surface->surface, 1.0, {}) : party.contact();
  return {std::move(field), party.on, party.surface->name, party.side,
          makeField(party.surface->surface, party.side, {})};
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
    return AxisRule(atAngle(tiltOf(axis), angleSide(control), angleSide(byPart ? drive : *part),
                            state.axis, forward));
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
