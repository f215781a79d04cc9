#include "runtime/geometry/kinds/polyconic.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/geometry/kinds/polyconic_sheet.h"

namespace arelem::surface {

namespace {
constexpr int newtonLimit = 60;
constexpr int halvings = 12;
/// A Newton step of s and t at most this long is the last.
constexpr double smallStep = 1e-9;
/// After one at most this long the sheet is known well enough from where it began.
constexpr double foretoldStep = 1e-5;
/// A Newton step is at most this share of the ranges of s and t, which are of length one.
constexpr double stride = 0.25;
/// A vector product this small against its factors has no direction.
constexpr double noArea = 1e-9;

/// The sheet a little aside, to the second order.
SheetPlace aside(const SheetPlace& from, double byS, double byT) {
  SheetPlace to = from;
  const Vec3 changeF = byS * from.byFF + byT * from.byFG;
  const Vec3 changeG = byS * from.byFG + byT * from.byGG;
  to.place += byS * (from.byF + 0.5 * changeF) + byT * (from.byG + 0.5 * changeG);
  to.byF += changeF;
  to.byG += changeG;
  return to;
}
}  // namespace

SheetPlace Polyconic::Sheet::at(double s, double t) const {
  const auto jets = form_.at<double>(s, t, form_.partOf(s), geometry::Polyconic::along(t));
  using geometry::Jet;
  const auto member = [&](double Jet<double>::*m) {
    return Vec3(form_.rows.transpose() * Vec3(jets[0].*m, jets[1].*m, jets[2].*m));
  };
  SheetPlace place{
      form_.rows.transpose() * (Vec3(jets[0].value, jets[1].value, jets[2].value) - form_.shift),
      member(&Jet<double>::s), member(&Jet<double>::t), member(&Jet<double>::ss),
      member(&Jet<double>::st)};
  place.byGG = member(&Jet<double>::tt);
  return place;
}

Vec3 Polyconic::Sheet::normalAt(double s, const SheetPlace& p) const {
  Vec3 across = p.byG.cross(p.byF);
  if (across.norm() <= noArea * p.byF.squaredNorm()) {
    across = p.byFG.cross(p.byF);
  } else {
    across *= upwards(s);
  }
  const double length = across.norm();
  return length > 0.0 ? Vec3(mirrored_ / length * across) : Vec3(p.byF.unitOrthogonal());
}

Polyconic::Sheet::Reached Polyconic::Sheet::descend(const Vec3& p, const Hint& from) const {
  Reached here{from, at(from.s, from.t)};
  for (int i = 0; i < newtonLimit; ++i) {
    auto [step, newton] = descent(here.place, p - here.place.place);
    if (!step.allFinite()) {
      break;
    }
    const double size = step.cwiseAbs().maxCoeff();
    const Hint whole{true, here.at.s + step.x(), here.at.t + step.y()};
    if (newton && size <= foretoldStep && form_.partOf(whole.s) == form_.partOf(here.at.s) &&
        geometry::Polyconic::along(whole.t) == geometry::Polyconic::along(here.at.t)) {
      return {whole, aside(here.place, step.x(), step.y())};
    }
    step *= std::min(1.0, stride / std::max(size, stride));
    const double before = (p - here.place.place).squaredNorm();
    for (int k = 0;; ++k) {
      const Hint next{true, here.at.s + step.x(), here.at.t + step.y()};
      const SheetPlace place = at(next.s, next.t);
      const bool last = size <= smallStep || k == halvings;
      if (last || (p - place.place).squaredNorm() <= before) {
        here = {next, place};
        break;
      }
      step *= 0.5;
    }
    // Newton squares the error: what it leaves after a small step is rounding.
    if (size <= 1e-15 || (newton && size <= smallStep)) {
      return here;
    }
  }
  here.found = false;
  return here;
}

Polyconic::Polyconic(const geometry::Polyconic& surface)
    : sheet_(std::make_shared<const Sheet>(surface)) {}

Foot Polyconic::foot(const Vec3& p, Hint& hint) const {
  const bool known = hint.valid;
  Sheet::Reached there = known ? sheet_->descend(p, hint) : sheet_->nearest(p, nullptr);
  if (known) {
    there = sheet_->nearest(p, there.found ? &there : nullptr);
  }
  hint = there.at;
  const Vec3 normal = sheet_->normalAt(there.at.s, there.place);
  return {(p - there.place.place).dot(normal) - sheet_->thickness(), normal};
}

Vec3 Polyconic::turn(const Vec3&, const Foot& foot, const Vec3& t, Hint& hint) const {
  return hint.valid ? sheetTurn(sheet_->at(hint.s, hint.t), foot.normal,
                                foot.distance + sheet_->thickness(), t)
                    : Vec3(Vec3::Zero());
}

Bends Polyconic::bends(const Vec3& p, const Foot& foot, double radius) const {
  const Vec3 on = p - (foot.distance + sheet_->thickness()) * foot.normal;
  const Sheet::Reached there = sheet_->nearest(on, nullptr);
  Hint hint = there.at;
  if (!((there.place.place - on).norm() <= tolerance::sameSide)) {
    hint = {};
    (void)this->foot(p, hint);
  }
  return bends(p, foot, radius, hint);
}

Bends Polyconic::bends(const Vec3&, const Foot& foot, double radius, const Hint& hint) const {
  const double distance = foot.distance + sheet_->thickness();
  const double away = std::abs(distance);
  const Bends any = bendsOfAnySet(distance, radius);
  // Feet of all places within the radius lie within 2 (|distance| + radius) of the foot.
  const Sheet::Part part = sheet_->about(hint, 2.0 * (away + radius));
  if (!part.curvatures) {
    return any;
  }
  return both(any, bendsOfCurvature(*part.curvatures, distance, radius,
                                    part.alone && part.sharpest * (away + 3.0 * radius) < 1.0));
}

}  // namespace arelem::surface
