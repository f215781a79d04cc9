#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/geometry/kinds/tabulated.h"
#include "runtime/geometry/kinds/tabulated_piece.h"

namespace arelem::surface {

using namespace tabulated;

namespace {
/// A place between two feet on a graph that rises by at most 45 degrees is farther off than they
/// are by less than this factor.
constexpr double rise = 1.5;

/// Range of the curvature, positive where the curve bends away from its left side, for the part of
/// a piece with local x in [from, to].
Bends curvatures(const Piece& p, double from, double to) {
  const double s0 = second(p, from);
  const double s1 = second(p, to);
  // The slope is a parabola: its least square lies at an end, at the vertex, or is 0 between.
  const double at0 = slope(p, from);
  const double at1 = slope(p, to);
  double least = at0 * at1 <= 0.0 ? 0.0 : std::min(at0 * at0, at1 * at1);
  double most = std::max(at0 * at0, at1 * at1);
  const double vertex = p.a != 0.0 ? -p.b / (3.0 * p.a) : from;
  if (vertex > from && vertex < to) {
    const double extreme = slope(p, vertex);
    least = extreme * at0 <= 0.0 || extreme * at1 <= 0.0 ? 0.0 : std::min(least, extreme * extreme);
    most = std::max(most, extreme * extreme);
  }
  const double large = 1.0 / ((1.0 + least) * std::sqrt(1.0 + least));
  const double small = 1.0 / ((1.0 + most) * std::sqrt(1.0 + most));
  const double low = -std::max(s0, s1);
  const double high = -std::min(s0, s1);
  return {low * (low < 0.0 ? large : small), high * (high > 0.0 ? large : small)};
}

/// True where all tangents of a part of a piece, all its slopes being between those at its ends and
/// at its vertex, are within 45 degrees of a unit direction (u, v).
bool runsAlong(const Piece& p, double from, double to, double u, double v) {
  const double along = u * p.dirU + v * p.dirV;
  const double aside = v * p.dirU - u * p.dirV;
  const double vertex = p.a != 0.0 ? std::clamp(-p.b / (3.0 * p.a), from, to) : from;
  for (const double x : {from, to, vertex}) {
    const double s = slope(p, x);
    const double dot = along + s * aside;
    if (!(dot > 0.0 && 2.0 * dot * dot > 1.0 + s * s)) {
      return false;
    }
  }
  return true;
}

/// Local x of the part of a piece that may be within reach, none if from >= to.
std::pair<double, double> partInReach(const Piece& p, const Local& q, double reach) {
  const double from = std::max(low(p), q.x - reach);
  const double to = std::min(high(p), q.x + reach);
  const bool far =
      from < to && (boxBound(p, q) > reach * reach || partBound(p, q, from, to) > reach * reach);
  return far ? std::pair(0.0, 0.0) : std::pair(from, to);
}

/// The piece to begin with, so that of a closed curve no part within reach is cut in two.
std::size_t beginOfReach(const TabulatedCylinder::Curve& curve, double u, double v, double reach) {
  for (std::size_t i = 0; curve.isClosed() && i < curve.pieces.size(); ++i) {
    const Piece& p = curve.pieces[i];
    const auto [from, to] = partInReach(p, toLocal(p, u, v), reach);
    if (!(from < to)) {
      return i;
    }
  }
  return 0;
}

void widen(Bends& range, const Bends& by) {
  range = {std::min(range.low, by.low), std::max(range.high, by.high)};
}

/// Angle by which the direction turns from one piece to the next, positive to the left.
double turnBetween(const Piece& p, const Piece& q) {
  const double a = slope(p, p.length);
  const double b = slope(q, 0.0);
  const double cross = p.dirU * q.dirV - p.dirV * q.dirU;
  const double dot = p.dirU * q.dirU + p.dirV * q.dirV;
  // Directions (1, a) and (1, b) in frames turned by (dot, cross).
  return std::atan2(cross * (1.0 + a * b) + dot * (b - a), dot * (1.0 + a * b) - cross * (b - a));
}
}  // namespace

Bends TabulatedCylinder::bends(const Vec3& point, const Foot& foot, double radius) const {
  const Curve& curve = *curve_;
  const double u = curve.u.dot(point);
  const double v = curve.v.dot(point);
  // Feet of all places within the radius lie within this of the place.
  const double away = std::abs(foot.distance);
  const double reach = away + 2.0 * radius;
  // Along the generatrix nothing bends.
  Bends curvature{0.0, 0.0};
  // Whether the part of the curve within reach is one: then two feet of one place have a place
  // between them where the curvature reaches 1 over the distance.
  bool one = true;
  // Whether that part runs within 45 degrees of its direction at the foot: a graph that a place has
  // on one side only, so that only the curvature towards that side makes two feet.
  const double alongU = foot.normal.dot(curve.v);
  const double alongV = -foot.normal.dot(curve.u);
  bool graph = away > radius;
  bool seen = false;
  bool joined = false;  // the part of the last piece runs to its end
  const std::size_t count = curve.pieces.size();
  const std::size_t begin = beginOfReach(curve, u, v, reach);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (begin + k) % count;
    const Piece& p = curve.pieces[i];
    const Local q = toLocal(p, u, v);
    const auto [from, to] = partInReach(p, q, reach);
    if (!(from < to)) {
      joined = false;
      continue;
    }
    one = one && (!seen || (joined && from == 0.0));
    seen = true;
    widen(curvature, curvatures(p, from, to));
    graph = graph && runsAlong(p, from, to, alongU, alongV);
    joined = to == p.length;
    if (joined && (i + 1 < count || curve.isClosed())) {
      const double turn = turnBetween(p, curve.pieces[(i + 1) % count]);
      if (std::abs(turn) > smoothJoint) {
        // A corner out of reach is no foot, but the parts on both of its sides may have one each.
        joined = squaredTo(p, q, p.length) <= reach * reach;
        if (joined) {
          widen(curvature, turn > 0.0 ? Bends{Bends{}.low, 0.0} : Bends{0.0, Bends{}.high});
          graph = false;
        }
      }
    }
  }
  const double hollow = foot.distance > 0.0 ? -curvature.low : curvature.high;
  const double sharpest =
      graph ? rise * hollow : std::max(std::abs(curvature.low), std::abs(curvature.high));
  return bendsOfCurvature(curvature, foot.distance, radius,
                          one && sharpest * (away + 3.0 * radius) < 1.0);
}

}  // namespace arelem::surface
