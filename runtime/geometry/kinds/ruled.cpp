#include "runtime/geometry/kinds/ruled.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ir/space/tolerance.h"
#include "runtime/geometry/kinds/ruled_sheet.h"

namespace arelem::surface {

namespace {
constexpr int newtonLimit = 50;
/// A Newton step of f and g at most this long is the last. What is left is its square, in
/// curvatures of the sheet, and that of the distance the square of that; the sheet at its end is
/// known to the third order.
constexpr double smallStep = 3e-5;
}  // namespace

Ruled::Ruled(const geometry::RuledSurface& surface)
    : sheet_(std::make_shared<const Sheet>(surface)) {}

Foot Ruled::foot(const Vec3& p, Hint& hint) const {
  if (!hint.valid) {
    hint = sheet_->seed(p);
  }
  Vec3 normal = Vec3::Zero();
  Vec3 rest = Vec3::Zero();
  for (int i = 0;; ++i) {
    const SheetPlace& s = hint.near;
    rest = p - s.place;
    normal = s.byF.cross(s.byG);
    hint.f = hint.nearF;
    hint.g = hint.nearG;
    const auto [step, newton] = descent(s, rest);
    const double size = step.cwiseAbs().maxCoeff();
    if (!step.allFinite() || size <= 1e-15 || i == newtonLimit) {
      break;
    }
    // A stride of at most a quarter of the strip keeps to the part of the sheet that is meant.
    const double stride = std::max(1.0, 4.0 * std::abs(step.x()));
    const double df = step.x() / stride;
    const double dg = step.y() / stride;
    hint.f += df;
    hint.g += dg;
    if (newton && size <= smallStep && sheet_->isSmooth(hint.nearF, hint.f)) {
      const Vec3 byF = s.byF + df * s.byFF + dg * s.byFG;
      const Vec3 byG = s.byG + df * s.byFG;
      rest -= 0.5 * (df * (s.byF + byF) + dg * (s.byG + byG));
      normal = byF.cross(byG);
      break;
    }
    hint.nearF = hint.f;
    hint.nearG = hint.g;
    hint.near = sheet_->at(hint.f, hint.g);
  }
  const double length = normal.norm();
  normal = length > 0.0 ? Vec3(normal / length) : Vec3(hint.near.byG.unitOrthogonal());
  return {rest.dot(normal), normal};
}

Vec3 Ruled::turn(const Vec3&, const Foot& foot, const Vec3& t, Hint& hint) const {
  if (!hint.valid) {
    return Vec3::Zero();
  }
  if (hint.f != hint.nearF || hint.g != hint.nearG) {
    hint.nearF = hint.f;
    hint.nearG = hint.g;
    hint.near = sheet_->at(hint.f, hint.g);
  }
  return sheetTurn(hint.near, foot.normal, foot.distance, t);
}

Vec3 Ruled::ruling(const Vec3& p) const {
  Hint hint;
  (void)foot(p, hint);
  return sheet_->at(hint.f, hint.g).byG;
}

Bends Ruled::bends(const Vec3& p, const Foot& foot, double radius) const {
  const Vec3 on = p - foot.distance * foot.normal;
  Hint hint = sheet_->seedOn(on);
  (void)this->foot(on, hint);
  if (!((sheet_->at(hint.f, hint.g).place - on).norm() <= tolerance::sameSide)) {
    hint = {};
    (void)this->foot(p, hint);
  }
  return bends(p, foot, radius, hint);
}

Bends Ruled::bends(const Vec3&, const Foot& foot, double radius, const Hint& hint) const {
  const Bends any = bendsOfAnySet(foot.distance, radius);
  const double away = std::abs(foot.distance);
  // Feet of all places within the radius lie within 2 (away + radius) of the foot.
  const auto range = sheet_->curvatures(hint.f, hint.g, 2.0 * (away + radius));
  if (!range) {
    return any;
  }
  const double sharpest = std::max(std::abs(range->low), std::abs(range->high));
  return both(
      any, bendsOfCurvature(*range, foot.distance, radius, sharpest * (away + 3.0 * radius) < 1.0));
}

}  // namespace arelem::surface
