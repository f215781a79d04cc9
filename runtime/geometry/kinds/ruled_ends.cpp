#include "runtime/geometry/kinds/ruled_ends.h"

#include <algorithm>
#include <limits>

#include "runtime/geometry/kinds/ruled_sheet.h"

/// Where motions along a ruled surface end.
namespace arelem::surface {

namespace {
/// Places along each end of the sheet that are looked at for the nearest one, and the share of its
/// distance that surely is no more than that of those between them.
constexpr int placesOfAnEnd = 64;
constexpr double keptOfThem = 0.75;
/// In distances of the curves and of their end points.
constexpr double farthest = farEdges.back();
}  // namespace

double Ruled::Sheet::endBefore(double f, double g) const {
  if (f < low_ - farthest || f > high_ + farthest) {
    return farthest * at(f, g).byF.norm();
  }
  return g < -farthest || g > 1.0 + farthest ? farthest * at(f, g).byG.norm() : 0.0;
}

void Ruled::Sheet::findEnds() {
  middle_ = at(0.5 * (low_ + high_), 0.5).place;
  double least = std::numeric_limits<double>::infinity();
  const double from = low_ - farthest;
  const double width = high_ + farthest - from;
  for (int i = 0; i <= placesOfAnEnd; ++i) {
    const double share = static_cast<double>(i) / placesOfAnEnd;
    const double f = from + share * width;
    const double g = share * (1.0 + 2.0 * farthest) - farthest;
    for (const auto& end :
         {at(from, g), at(from + width, g), at(f, -farthest), at(f, 1.0 + farthest)}) {
      least = std::min(least, (end.place - middle_).squaredNorm());
    }
  }
  amidst_ = keptOfThem * keptOfThem * least;
}

double Ruled::Sheet::endBefore(const Ruled& surface, const Vec3& p) {
  const Sheet& sheet = *surface.sheet_;
  if ((p - sheet.middle_).squaredNorm() < sheet.amidst_) {
    return 0.0;
  }
  Hint hint;
  (void)surface.foot(p, hint);
  return sheet.endBefore(hint.f, hint.g);
}

double endBefore(const Ruled& surface, const Vec3& p) {
  return Ruled::Sheet::endBefore(surface, p);
}

}  // namespace arelem::surface
