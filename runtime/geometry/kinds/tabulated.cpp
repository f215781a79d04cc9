#include "runtime/geometry/kinds/tabulated.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "runtime/geometry/kinds/tabulated_piece.h"

namespace arelem::surface {

namespace {
using namespace tabulated;

constexpr int newtonLimit = 40;
/// Steps that are smaller than this share of the piece may be the last, if the next would be
/// smaller than this share of it.
constexpr double lastStep = 2e-3;
constexpr double unseenStep = 1e-9;
/// Parts of a piece that are looked at one by one.
constexpr int parts = 4;

struct PlaneVector {
  double u, v;
};

struct Nearest {
  double x = 0.0;
  double squared = std::numeric_limits<double>::infinity();
};

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

/// Left normal of a piece where it has the slope, in the plane of the curve.
PlaneVector leftNormal(const Piece& p, double s) {
  const double inverse = 1.0 / std::sqrt(1.0 + s * s);
  return {(-s * p.dirU - p.dirV) * inverse, (p.dirU - s * p.dirV) * inverse};
}

/// Positive where a place whose foot is an end of a piece, seen from there in direction (u, v),
/// lies on the left of the curve: of a sharp corner neither of its pieces alone tells.
double leftOfEnd(const TabulatedCylinder::Curve& curve, int piece, bool atStart, PlaneVector seen) {
  const int count = static_cast<int>(curve.pieces.size());
  const Piece& p = curve.pieces[static_cast<std::size_t>(piece)];
  PlaneVector normal = leftNormal(p, slope(p, atStart ? 0.0 : p.length));
  const int other = atStart ? piece - 1 : piece + 1;
  if (curve.isClosed() || (other >= 0 && other < count)) {
    const Piece& q = curve.pieces[static_cast<std::size_t>((other + count) % count)];
    const PlaneVector beside = leftNormal(q, slope(q, atStart ? q.length : 0.0));
    normal = {normal.u + beside.u, normal.v + beside.v};
  }
  return seen.u * normal.u + seen.v * normal.v;
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
  const double dx = q.x - best.x;
  const double dy = q.y - height(p, best.x);
  const double length = std::sqrt(best.squared);
  // At an end of a piece, which may be a corner, the exact gradient is the direction from the foot;
  // elsewhere it is the curve's normal, and what Newton left of the foot's place counts by its
  // square only.
  const bool atStart = best.x == low(p);
  const bool atEnd = atStart || best.x == high(p);
  if (atEnd && length > 1e-9 * (1.0 + p.length)) {
    const PlaneVector seen{dx * p.dirU - dy * p.dirV, dx * p.dirV + dy * p.dirU};
    const double distance = std::copysign(length, leftOfEnd(curve, bestPiece, atStart, seen));
    return {distance, seen.u / distance, seen.v / distance};
  }
  const double s = slope(p, best.x);
  const PlaneVector normal = leftNormal(p, s);
  return {(dy - s * dx) / std::sqrt(1.0 + s * s), normal.u, normal.v};
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

}  // namespace arelem::surface
