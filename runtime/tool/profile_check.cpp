#include "runtime/tool/profile_check.h"

#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

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

/// Distances of the corner's center from the bottom line and from the side line, inside positive.
struct CornerPlace {
  double aboveBottom, withinSide;
};

/// What can be described of a corner that is wider than its shank, as a lollipop has it.
std::string lowerHalf(const Profile& p) {
  return fmt::format(
      "the seven values have no place above the widest one of the corner but a side that goes "
      "straight up or widens: of a corner on a thinner shank the lower half can be given, "
      "CUTTER/{0:.6g},{1:.6g},{2:.6g},{3:.6g},{4:.6g},0,{3:.6g}",
      2.0 * (p.e + p.r), p.r, p.e, p.f, p.alpha * degrees);
}

CornerPlace cornerPlace(const Profile& p) {
  const double rim = p.d / 2 * std::tan(p.alpha);
  return {p.f * p.cosAlpha - p.e * p.sinAlpha,
          (p.d / 2 - p.e) * p.cosBeta + (p.f - rim) * p.sinBeta};
}
}  // namespace

ProfilePoint cornerCenter(const Profile& p) {
  const double turn = std::cos(p.alpha + p.beta);
  const double inwards = p.r * (std::cos(p.alpha) - std::sin(p.beta)) / turn;
  const double upwards = p.r * (std::cos(p.beta) - std::sin(p.alpha)) / turn;
  return {p.d / 2 - inwards, p.d / 2 * std::tan(p.alpha) + upwards};
}

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
  const double rim = p.d / 2 * std::tan(p.alpha);
  const auto [aboveBottom, withinSide] = cornerPlace(p);
  if (rim > p.h + size) {
    return fail(diag::CutterBottomTooSteep, p.alpha * degrees, rim, p.h);
  }
  if (withinSide < -size) {
    return fail(diag::CutterCornerOutside, p.e, p.f, -withinSide);
  }
  // A joint that is taken as touching is told unless the cutter cannot be used for another reason.
  const auto noSide = p.sideStart.z > p.h + size
                          ? std::optional(fail(diag::CutterNoSide, p.h, p.sideStart.z))
                          : std::nullopt;
  const auto orNoSide = [&](Failure bad) {
    return noSide && bad.row->severity != Severity::error ? *noSide : std::move(bad);
  };
  if (auto bad = jointFault(p, aboveBottom, diag::CutterArcCrossesBottom,
                            diag::CutterArcMissesBottom, diag::CutterArcOffBottom)) {
    return orNoSide(*std::move(bad));
  }
  if (auto bad = jointFault(p, withinSide, diag::CutterArcCrossesSide, diag::CutterArcMissesSide,
                            diag::CutterArcOffSide)) {
    const bool bulges = withinSide < p.r && bad->row->severity == Severity::error;
    return bulges ? std::move(*bad).withHelp(lowerHalf(p)) : orNoSide(*std::move(bad));
  }
  return noSide;
}

Profile joined(const Profile& p) {
  const double allowed = tolerance::cutterJoint * std::max(1.0, p.d);
  const auto [aboveBottom, withinSide] = cornerPlace(p);
  if (p.ring || std::abs(aboveBottom - p.r) > allowed || std::abs(withinSide - p.r) > allowed) {
    return p;
  }
  Profile out = p;
  if (p.e == 0.0) {
    out.d -= 2.0 * cornerCenter(p).rho;
  }
  const ProfilePoint center = cornerCenter(out);
  out.e = std::max(center.rho, 0.0);
  out.f = center.z;
  completeProfile(out);
  return out;
}

}  // namespace arelem::tool
