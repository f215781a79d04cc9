#include "runtime/geometry/kinds/tabulated.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arelem::surface {

namespace {
using Piece = TabulatedCylinder::Piece;

constexpr int newtonLimit = 40;
/// Steps that are smaller than this share of the piece may be the last, if the next would be
/// smaller than this share of it.
constexpr double lastStep = 2e-3;
constexpr double unseenStep = 1e-9;
/// Parts of a piece that are looked at one by one.
constexpr int parts = 4;
/// A place between two feet on a graph that rises by at most 45 degrees is farther off than they
/// are by less than this factor.
constexpr double rise = 1.5;
/// Directions of two neighbors that differ by less than this meet smoothly. Radians.
constexpr double smoothJoint = 1e-7;

double height(const Piece& p, double x) {
  return ((p.a * x + p.b) * x + p.c) * x;
}
double slope(const Piece& p, double x) {
  return (3.0 * p.a * x + 2.0 * p.b) * x + p.c;
}
double second(const Piece& p, double x) {
  return 6.0 * p.a * x + 2.0 * p.b;
}

struct Local {
  double x, y;
};

Local toLocal(const Piece& p, double u, double v) {
  const double du = u - p.u;
  const double dv = v - p.v;
  return {du * p.dirU + dv * p.dirV, dv * p.dirU - du * p.dirV};
}

struct Nearest {
  double x = 0.0;
  double squared = std::numeric_limits<double>::infinity();
};

double low(const Piece& p) {
  return p.openStart ? -std::numeric_limits<double>::infinity() : 0.0;
}
double high(const Piece& p) {
  return p.openEnd ? std::numeric_limits<double>::infinity() : p.length;
}

double squaredTo(const Piece& p, const Local& q, double x) {
  const double dx = x - q.x;
  const double dy = height(p, x) - q.y;
  return dx * dx + dy * dy;
}

/// Safeguarded steps of the third order (Chebyshev's) to a zero of half the derivative of the
/// squared distance, from x, kept in the piece.
Nearest descend(const Piece& p, const Local& q, double x) {
  const double lo = low(p);
  const double hi = high(p);
  x = std::clamp(x, lo, hi);
  for (int i = 0; i < newtonLimit; ++i) {
    const double y = height(p, x) - q.y;
    const double s = slope(p, x);
    const double bend = second(p, x);
    const double gradient = x - q.x + y * s;
    const double curvature = 1.0 + s * s + y * bend;
    double next = x;
    bool last = false;
    if (curvature > 0.1 * (1.0 + s * s)) {
      const double inverse = 1.0 / curvature;
      const double step = -gradient * inverse;
      const double further = -0.5 * step * step * (3.0 * s * bend + 6.0 * p.a * y) * inverse;
      const double size = std::abs(step);
      next = std::clamp(x + step + std::clamp(further, -0.5 * size, 0.5 * size), lo, hi);
      last = size <= lastStep * p.length && 2.0 * further * further <= unseenStep * p.length * size;
    } else {
      // Where the squared distance is hardly convex, next to a center of curvature, the
      // Gauss-Newton step is safe but creeps: Newton's is taken there if it leads farther down.
      next = std::clamp(x - gradient / (1.0 + s * s), lo, hi);
      if (curvature > 0.0) {
        const double bold = std::clamp(x - gradient / curvature, lo, hi);
        next = squaredTo(p, q, bold) < squaredTo(p, q, next) ? bold : next;
      }
    }
    const double moved = std::abs(next - x);
    x = next;
    if (last || moved <= 1e-16 * (std::abs(x) + p.length)) {
      break;
    }
  }
  return {x, squaredTo(p, q, x)};
}

/// Lower bound of the squared distance to a piece, from its bounding box in the local frame.
double boxBound(const Piece& p, const Local& q) {
  const double dx = std::max({low(p) - q.x, 0.0, q.x - high(p)});
  const double dy = std::max({p.lowY - q.y, 0.0, q.y - p.highY});
  return dx * dx + dy * dy;
}

/// The same for a part of a piece, which is within its sag of the box of its chord.
double partBound(const Piece& p, const Local& q, double from, double to) {
  const double width = to - from;
  const double sag =
      0.125 * width * width * std::max(std::abs(second(p, from)), std::abs(second(p, to)));
  const double y0 = height(p, from);
  const double y1 = height(p, to);
  const double dx = std::max({from - q.x, 0.0, q.x - to});
  const double dy = std::max({std::min(y0, y1) - sag - q.y, 0.0, q.y - std::max(y0, y1) - sag});
  return dx * dx + dy * dy;
}

/// True where the squared distance to a piece has no second minimum: its second derivative, 1 + s^2
/// + (y - q.y) y'', is positive all over it.
bool hasOneMinimum(const Piece& p, const Local& q) {
  const double s0 = second(p, 0.0);
  const double s1 = second(p, p.length);
  const double below = p.lowY - q.y;
  const double above = p.highY - q.y;
  return std::min({below * s0, below * s1, above * s0, above * s1}) > -1.0;
}

/// The nearest place of a piece, if it is nearer than `bound`; else no nearer one than there is.
Nearest nearestOf(const Piece& p, const Local& q, double bound) {
  if (p.a == 0.0 && p.b == 0.0) {
    const double x = std::clamp(q.x, low(p), high(p));
    return {x, squaredTo(p, q, x)};
  }
  if (hasOneMinimum(p, q)) {
    // It lies at an end from which the distance rises, or between the ends.
    const double end = q.x + q.y * slope(p, 0.0) <= 0.0                   ? 0.0
                       : q.x - p.length + q.y * slope(p, p.length) >= 0.0 ? p.length
                                                                          : -1.0;
    return end >= 0.0 ? Nearest{end, squaredTo(p, q, end)} : descend(p, q, q.x);
  }
  // A cubic over a chord has at most three minima; the ends of its parts find them for the gentle
  // pieces that definitions produce.
  Nearest best{0.0, bound};
  const double width = p.length / parts;
  for (int i = 0; i < parts; ++i) {
    const double from = i * width;
    const double to = from + width;
    const double least = partBound(p, q, from, to);
    for (const double seed : {from, to}) {
      if (least < best.squared) {
        const Nearest found = descend(p, q, seed);
        best = found.squared < best.squared ? found : best;
      }
    }
  }
  return best;
}

}  // namespace

Foot TabulatedCylinder::foot(const Vec3& point, Hint& hint) const {
  const PlaneFoot found = footInPlane(curve_->u.dot(point), curve_->v.dot(point), hint);
  return {found.distance, found.normalU * curve_->u + found.normalV * curve_->v};
}

TabulatedCylinder::PlaneFoot TabulatedCylinder::footInPlane(double u, double v, Hint& hint) const {
  const Curve& curve = *curve_;
  Nearest best;
  int bestPiece = hint.piece;
  bool whole = hint.piece < 0;  // every piece is to be looked at
  if (!whole) {
    const Piece& p = curve.pieces[static_cast<std::size_t>(hint.piece)];
    const Local q = toLocal(p, u, v);
    best = descend(p, q, hint.x);
    if (!hasOneMinimum(p, q)) {
      const Nearest found = nearestOf(p, q, best.squared);
      best = found.squared < best.squared ? found : best;
    }
    // The others are nearer by the way since they were looked at, at most.
    const double moved = (u - hint.u) * (u - hint.u) + (v - hint.v) * (v - hint.v);
    whole = best.squared + moved + 2.0 * std::sqrt(best.squared * moved) >
            hint.others * std::abs(hint.others);
  }
  if (whole) {
    double others = std::numeric_limits<double>::infinity();
    const int count = static_cast<int>(curve.pieces.size());
    for (int i = 0; i < count; ++i) {
      if (i == hint.piece) {
        continue;
      }
      const Piece& p = curve.pieces[static_cast<std::size_t>(i)];
      const Local q = toLocal(p, u, v);
      const double bound = boxBound(p, q);
      if (bound >= best.squared) {
        others = std::min(others, bound);
        continue;
      }
      const Nearest found = nearestOf(p, q, best.squared);
      others = std::min(others, std::max(found.squared, best.squared));
      if (found.squared < best.squared) {
        best = found;
        bestPiece = i;
      }
    }
    hint.others = std::sqrt(others);
    hint.u = u;
    hint.v = v;
  }
  hint.piece = bestPiece;
  hint.x = best.x;
  const Piece& p = curve.pieces[static_cast<std::size_t>(bestPiece)];
  const Local q = toLocal(p, u, v);
  const double s = slope(p, best.x);
  const double norm = std::sqrt(1.0 + s * s);
  // Left normal of the curve direction (1, s) in the local frame.
  const double nx = -s / norm;
  const double ny = 1.0 / norm;
  const double dx = q.x - best.x;
  const double dy = q.y - height(p, best.x);
  const double across = dx * nx + dy * ny;
  const double length = std::sqrt(best.squared);
  // At an end of a piece, which may be a corner, the exact gradient is the direction from the foot;
  // elsewhere it is the curve's normal, and what Newton left of the foot's place counts by its
  // square only.
  const bool atEnd = best.x == low(p) || best.x == high(p);
  const bool fromFoot = atEnd && length > 1e-9 * (1.0 + p.length);
  const double distance = fromFoot ? std::copysign(length, across) : across;
  const double gx = fromFoot ? dx / distance : nx;
  const double gy = fromFoot ? dy / distance : ny;
  const double gu = gx * p.dirU - gy * p.dirV;
  const double gv = gx * p.dirV + gy * p.dirU;
  return {distance, gu, gv};
}

double TabulatedCylinder::bend(const Vec3&, const Foot& foot, const Vec3& t, Hint& hint) const {
  if (hint.piece < 0) {
    return 0.0;
  }
  const Piece& p = curve_->pieces[static_cast<std::size_t>(hint.piece)];
  const double s = slope(p, hint.x);
  const double squared = 1.0 + s * s;
  const double across = curve_->w.cross(foot.normal).dot(t);
  // At a corner of the curve the distance is that to the corner.
  const double gu = foot.normal.dot(curve_->u);
  const double gv = foot.normal.dot(curve_->v);
  const double alongCurve = (gu * p.dirU + gv * p.dirV + s * (gv * p.dirU - gu * p.dirV));
  if (std::abs(alongCurve) > smoothJoint * std::sqrt(squared) && foot.distance != 0.0) {
    return across * across / foot.distance;
  }
  // Curvature of the curve, positive where it turns left, that is towards the positive side.
  const double k = second(p, hint.x) / (squared * std::sqrt(squared));
  const double parallel = -k / std::max(1.0 - k * foot.distance, 1e-12);
  return parallel * across * across;
}

namespace {
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
  for (std::size_t i = 0; i < curve.pieces.size(); ++i) {
    const Piece& p = curve.pieces[i];
    const Local q = toLocal(p, u, v);
    const double from = std::max(low(p), q.x - reach);
    const double to = std::min(high(p), q.x + reach);
    if (!(from < to) || boxBound(p, q) > reach * reach ||
        partBound(p, q, from, to) > reach * reach) {
      joined = false;
      continue;
    }
    one = one && (!seen || (joined && from == 0.0));
    seen = true;
    widen(curvature, curvatures(p, from, to));
    graph = graph && runsAlong(p, from, to, alongU, alongV);
    joined = to == p.length;
    if (joined && i + 1 < curve.pieces.size()) {
      const double turn = turnBetween(p, curve.pieces[i + 1]);
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
