#pragma once
#include <Eigen/Dense>

#include "ir/space/vector.h"

/// What surfaces share that are given by two parameters. Private to runtime/geometry/kinds.
namespace arelem::surface {

/// A place of a sheet with the derivatives by its parameters f and g.
struct SheetPlace {
  Vec3 place, byF, byG, byFF, byFG;
  Vec3 byGG = Vec3::Zero();
};

/// Solution of the symmetric system (a b; b c) x = r.
inline Eigen::Vector2d solved(double a, double b, double c, const Eigen::Vector2d& r) {
  return Eigen::Vector2d(c * r.x() - b * r.y(), a * r.y() - b * r.x()) / (a * c - b * b);
}

struct Descent {
  Eigen::Vector2d step;
  bool newton = true;
};

/// One Newton step of f and g on half the squared distance to a point that is `rest` from the
/// place, turned to Gauss-Newton where it is not convex.
inline Descent descent(const SheetPlace& s, const Vec3& rest) {
  const Eigen::Vector2d slope(rest.dot(s.byF), rest.dot(s.byG));
  const double ff = s.byF.squaredNorm();
  const double fg = s.byF.dot(s.byG);
  const double gg = s.byG.squaredNorm();
  const double a = ff - rest.dot(s.byFF);
  const double b = fg - rest.dot(s.byFG);
  const double c = gg - rest.dot(s.byGG);
  if (a > 0.0 && a * c - b * b > 0.0) {
    return {solved(a, b, c, slope), true};
  }
  return {solved(ff, fg, gg, slope), false};
}

/// The change of the normal of the distance along t at `distance` from the place, `normal` its unit
/// normal. With first form I and second form L (towards the normal) the shape operator of the
/// distance is -I^-1 L, and that of the parallel surface at d is (I - d L)^-1 (-L), all in the
/// basis byF, byG.
inline Vec3 sheetTurn(const SheetPlace& s, const Vec3& normal, double distance, const Vec3& t) {
  const double ff = s.byF.squaredNorm();
  const double fg = s.byF.dot(s.byG);
  const double gg = s.byG.squaredNorm();
  const double bentF = normal.dot(s.byFF);
  const double bentMixed = normal.dot(s.byFG);
  const double bentG = normal.dot(s.byGG);
  const Eigen::Vector2d along = solved(ff, fg, gg, {s.byF.dot(t), s.byG.dot(t)});
  const Eigen::Vector2d bent(bentF * along.x() + bentMixed * along.y(),
                             bentMixed * along.x() + bentG * along.y());
  const Eigen::Vector2d carried =
      solved(ff - distance * bentF, fg - distance * bentMixed, gg - distance * bentG, -bent);
  return carried.x() * s.byF + carried.y() * s.byG;
}

}  // namespace arelem::surface
