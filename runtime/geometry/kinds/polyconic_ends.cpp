#include "runtime/geometry/kinds/polyconic_ends.h"

#include <algorithm>
#include <limits>

#include "runtime/geometry/kinds/polyconic_sheet.h"

/// Where motions along a POLCON end.
namespace arelem::surface {

namespace {
/// In ranges of s and t, beyond which the sheet goes on for that; and of the way to where its
/// conics are flat or a point.
constexpr double farthest = 10.0;
constexpr double mostOfProper = 0.99;
/// Places along each end of the sheet that are looked at for the nearest one, and the share of its
/// distance that surely is no more than that of those between them.
constexpr int placesOfAnEnd = 64;
constexpr double keptOfThem = 0.75;
constexpr double high = geometry::Polyconic::high;
}  // namespace

void Polyconic::Sheet::findEnds() {
  endLow_ = form_.low() - std::min(farthest, mostOfProper * (form_.low() - properLow_));
  endHigh_ = high + std::min(farthest, mostOfProper * (properHigh_ - high));
  amid_ = at(0.5 * (form_.low() + high), 0.5).place;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= placesOfAnEnd; ++i) {
    const double share = static_cast<double>(i) / placesOfAnEnd;
    const double s = endLow_ + share * (endHigh_ - endLow_);
    const double t = share * (1.0 + 2.0 * farthest) - farthest;
    for (const auto& end :
         {at(endLow_, t), at(endHigh_, t), at(s, -farthest), at(s, 1.0 + farthest)}) {
      least = std::min(least, (end.place - amid_).squaredNorm());
    }
  }
  amidst_ = keptOfThem * keptOfThem * least;
}

double Polyconic::Sheet::endBefore(const Polyconic& surface, const Vec3& p) {
  const Sheet& sheet = *surface.sheet_;
  if ((p - sheet.amid_).squaredNorm() < sheet.amidst_) {
    return 0.0;
  }
  Hint at;
  (void)surface.foot(p, at);
  if (at.s < sheet.endLow_) {
    return (sheet.form_.low() - sheet.endLow_) * sheet.at(at.s, at.t).byF.norm();
  }
  if (at.s > sheet.endHigh_) {
    return (sheet.endHigh_ - high) * sheet.at(at.s, at.t).byF.norm();
  }
  const bool beside = at.t < -farthest || at.t > 1.0 + farthest;
  return beside ? farthest * sheet.at(at.s, at.t).byG.norm() : 0.0;
}

double endBefore(const Polyconic& surface, const Vec3& p) {
  return Polyconic::Sheet::endBefore(surface, p);
}

}  // namespace arelem::surface
