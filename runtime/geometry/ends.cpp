#include "runtime/geometry/ends.h"

#include "runtime/geometry/kinds/polyconic_ends.h"
#include "runtime/geometry/kinds/ruled_ends.h"

namespace arelem::surface {

double endBefore(const AnySurface& surface, const Vec3& p) {
  if (const auto* ruled = std::get_if<Ruled>(&surface)) {
    return endBefore(*ruled, p);
  }
  if (const auto* conics = std::get_if<Polyconic>(&surface)) {
    return endBefore(*conics, p);
  }
  const auto* tabulated = std::get_if<TabulatedCylinder>(&surface);
  if (tabulated == nullptr) {
    return 0.0;
  }
  const TabulatedCylinder::Curve& curve = tabulated->curve();
  const double u = curve.u.dot(p);
  const double v = curve.v.dot(p);
  const auto along = [&](const TabulatedCylinder::Piece& piece) {
    return (u - piece.u) * piece.dirU + (v - piece.v) * piece.dirV;
  };
  const TabulatedCylinder::Piece& first = curve.pieces.front();
  const TabulatedCylinder::Piece& last = curve.pieces.back();
  // Only a place that is nearest to the end can be behind it.
  const auto isNearest = [&](std::size_t piece) {
    TabulatedCylinder::Hint hint;
    (void)tabulated->foot(p, hint);
    return hint.piece == static_cast<int>(piece);
  };
  if (first.openStart && along(first) < 0.0 && isNearest(0)) {
    return first.length;
  }
  const bool behind = last.openEnd && along(last) > last.length;
  return behind && isNearest(curve.pieces.size() - 1) ? last.length : 0.0;
}

}  // namespace arelem::surface
