#include "runtime/geometry/kinds/ruled.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ir/space/tolerance.h"
#include "runtime/geometry/kinds/ruled_sheet.h"

namespace arelem::surface {

namespace {
constexpr int newtonLimit = 15;
/// Rulings on the way to a foot that Newton does not find, and the first stride between them.
constexpr int rulingsLimit = 100;
constexpr double firstStride = 1.0 / 64.0;
/// A place this near to the foot, as a share of what is asked about, does for its bends.
constexpr double sameFoot = 1e-3;
constexpr double unbounded = std::numeric_limits<double>::infinity();
/// A Newton step of f and g at most this long is the last. What is left is its square, in
/// curvatures of the sheet, and that of the distance the square of that; the sheet at its end is
/// known to the third order.
constexpr double smallStep = 3e-5;
}  // namespace

Ruled::Ruled(const geometry::RuledSurface& surface)
    : sheet_(std::make_shared<const Sheet>(surface)) {}

Foot Ruled::Sheet::settle(const Vec3& p, Hint& hint) const {
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
    if (size <= 1e-15) {
      break;
    }
    if (!(size < unbounded) || i == newtonLimit) {
      settleAlongRulings(p, hint);
      rest = p - hint.near.place;
      normal = hint.near.byF.cross(hint.near.byG);
      break;
    }
    // A stride of at most a quarter of the strip keeps to the part of the sheet that is meant.
    const double stride = std::max(1.0, 4.0 * std::abs(step.x()));
    const double df = step.x() / stride;
    const double dg = step.y() / stride;
    hint.f += df;
    hint.g += dg;
    if (newton && size <= smallStep && isSmooth(hint.nearF, hint.f)) {
      const Vec3 byF = s.byF + df * s.byFF + dg * s.byFG;
      const Vec3 byG = s.byG + df * s.byFG;
      rest -= 0.5 * (df * (s.byF + byF) + dg * (s.byG + byG));
      normal = byF.cross(byG);
      break;
    }
    hint.nearF = hint.f;
    hint.nearG = hint.g;
    hint.near = at(hint.f, hint.g);
  }
  const double length = normal.norm();
  normal = length > 0.0 ? Vec3(normal / length) : Vec3(hint.near.byG.unitOrthogonal());
  return {rest.dot(normal), normal};
}

/// Where Newton goes to and fro, over an end of the curves behind which they bend no more: each
/// ruling has one nearest place, and the slope of its distance by f changes sign at the foot.
void Ruled::Sheet::settleAlongRulings(const Vec3& p, Hint& hint) const {
  double low = -unbounded;
  double high = unbounded;
  double stride = firstStride;
  for (int i = 0; i < rulingsLimit; ++i) {
    const SheetPlace start = at(hint.f, 0.0);
    hint.g = (p - start.place).dot(start.byG) / start.byG.squaredNorm();
    hint.nearF = hint.f;
    hint.nearG = hint.g;
    hint.near = at(hint.f, hint.g);
    const Vec3 rest = p - hint.near.place;
    const double slope = -rest.dot(hint.near.byF);
    (slope < 0.0 ? low : high) = hint.f;
    const double bent = hint.near.byF.squaredNorm() - rest.dot(hint.near.byFF);
    const double mixed = hint.near.byF.dot(hint.near.byG) - rest.dot(hint.near.byFG);
    const double curved = bent - mixed * mixed / hint.near.byG.squaredNorm();
    const double step = curved > 0.0 ? -slope / curved : (slope < 0.0 ? stride : -stride);
    double next = hint.f + std::clamp(step, -stride, stride);
    stride *= 2.0;
    if (low > -unbounded && high < unbounded && (!(next > low && next < high) || i > newtonLimit)) {
      next = 0.5 * (low + high);
    }
    if (slope == 0.0 || !(std::abs(next - hint.f) > 1e-15)) {
      break;
    }
    hint.f = next;
  }
  hint.f = hint.nearF;
}

Foot Ruled::foot(const Vec3& p, Hint& hint) const {
  if (!hint.valid) {
    return sheet_->nearest(p, nullptr, hint);
  }
  const Foot foot = sheet_->settle(p, hint);
  return sheet_->isNearest(foot, hint) ? foot : sheet_->nearest(p, &foot, hint);
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
  return bends(p, foot, radius, {});
}

Bends Ruled::bends(const Vec3& p, const Foot& foot, double radius, const Hint& hint) const {
  const Bends any = bendsOfAnySet(foot.distance, radius);
  const double away = std::abs(foot.distance);
  const Vec3 on = p - foot.distance * foot.normal;
  Hint near = hint;
  const auto off = [&] { return (sheet_->at(near.f, near.g).place - on).norm(); };
  if (!near.valid || !(off() <= sameFoot * (1.0 + away + radius))) {
    near.valid = false;
    (void)this->foot(on, near);
    if (!(off() <= tolerance::sameSide)) {
      near.valid = false;
      (void)this->foot(p, near);
    }
  }
  // Feet of all places within the radius lie within 2 (away + radius) of the foot.
  const Sheet::Part part = sheet_->curvatures(near.f, near.g, 2.0 * (away + radius) + off());
  if (!part.curvatures) {
    return any;
  }
  const double sharpest = std::max(std::abs(part.curvatures->low), std::abs(part.curvatures->high));
  return both(any, bendsOfCurvature(*part.curvatures, foot.distance, radius,
                                    part.alone && sharpest * (away + 3.0 * radius) < 1.0));
}

}  // namespace arelem::surface
