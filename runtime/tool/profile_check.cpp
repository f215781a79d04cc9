#include "runtime/tool/profile_check.h"

#include <cmath>
#include <numbers>

#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"

namespace arelem::tool {

namespace {
constexpr double degrees = 180.0 / std::numbers::pi;

/// How far the corner arc is from touching a line: the center's distance less the radius.
std::optional<Failure> jointFault(const Profile& p,
                                  double centerDistance,
                                  const DiagKind<double>& crosses,
                                  const DiagKind<double>& misses,
                                  const DiagKind<double>& barely) {
  const double size = std::max(1.0, p.d);
  const double off = centerDistance - p.r;
  if (std::abs(off) <= tolerance::cutterRounding * size) {
    return std::nullopt;
  }
  if (std::abs(off) <= tolerance::cutterJoint * size) {
    return fail(barely, off);
  }
  return off < 0.0 ? fail(crosses, -off) : fail(misses, off);
}
}  // namespace

std::optional<Failure> rangeFault(const Profile& p) {
  if (p.d < 0.0) {
    return fail(diag::CutterDiameter, p.d);
  }
  if (p.r < 0.0) {
    return fail(diag::CutterCornerRadius, p.r);
  }
  if (p.h < 0.0) {
    return fail(diag::CutterHeight, p.h);
  }
  if (p.alpha < 0.0) {
    return fail(diag::CutterAlpha, p.alpha * degrees);
  }
  if (p.beta < 0.0) {
    return fail(diag::CutterBeta, p.beta * degrees);
  }
  if (p.alpha + p.beta >= std::numbers::pi / 2) {
    return fail(diag::CutterAngles, (p.alpha + p.beta) * degrees);
  }
  if (p.e < -tolerance::coincidence || p.f < 0.0) {
    return fail(diag::CutterCornerTooLarge, p.r, p.e, p.f);
  }
  return std::nullopt;
}

std::optional<Failure> shapeFault(const Profile& p) {
  const double size = tolerance::cutterRounding * std::max(1.0, p.d);
  // Distances of the corner's center from the bottom line and from the side line, inside positive.
  const double rim = p.d / 2 * std::tan(p.alpha);
  const double aboveBottom = p.f * p.cosAlpha - p.e * p.sinAlpha;
  const double withinSide = (p.d / 2 - p.e) * p.cosBeta + (p.f - rim) * p.sinBeta;
  if (rim > p.h + size) {
    return fail(diag::CutterBottomTooSteep, p.alpha * degrees, rim, p.h);
  }
  if (withinSide < -size) {
    return fail(diag::CutterCornerOutside, p.e, p.f, -withinSide);
  }
  if (auto bad = jointFault(p, aboveBottom, diag::CutterArcCrossesBottom,
                            diag::CutterArcMissesBottom, diag::CutterArcOffBottom)) {
    return bad;
  }
  if (auto bad = jointFault(p, withinSide, diag::CutterArcCrossesSide, diag::CutterArcMissesSide,
                            diag::CutterArcOffSide)) {
    return bad;
  }
  if (p.sideStart.z > p.h + size) {
    return fail(diag::CutterNoSide, p.h, p.sideStart.z);
  }
  return std::nullopt;
}

}  // namespace arelem::tool
