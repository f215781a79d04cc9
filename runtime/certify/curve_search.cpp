#include "runtime/certify/curve_search.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace arelem::certify {

namespace {
using Vec2 = Eigen::Vector2d;
using Piece = surface::TabulatedCylinder::Piece;

/// Cosine of axis and generatrix up to which the section through the axis is the whole cutter.
constexpr double square = 1e-9;
/// Looks for a better direction where it is not.
constexpr int looks = 4;
/// Parts of the curve and ways of the tool below this are not halved. Part unit.
constexpr double shortest = 1e-9;

double height(const Piece& p, double x) {
  return ((p.a * x + p.b) * x + p.c) * x;
}
double slope(const Piece& p, double x) {
  return (3.0 * p.a * x + 2.0 * p.b) * x + p.c;
}
Vec2 local(const Piece& p, const Vec2& v) {
  return {v.x() * p.dirU + v.y() * p.dirV, v.y() * p.dirU - v.x() * p.dirV};
}
/// The unit left normal.
Vec2 normalOf(const Piece& p, double x) {
  const double s = slope(p, x);
  return Vec2(-s * p.dirU - p.dirV, p.dirU - s * p.dirV) / std::sqrt(1.0 + s * s);
}
Vec2 placeOf(const Piece& p, double x) {
  const double y = height(p, x);
  return {p.u + x * p.dirU - y * p.dirV, p.v + x * p.dirV + y * p.dirU};
}
}  // namespace

CurveSearch::CurveSearch(const surface::TabulatedCylinder& surface,
                         const tool::Profile& cutter,
                         const Relation& relation)
    : surface_(surface),
      cutter_(cutter),
      body_(cutter),
      side_(relation.side),
      thick_(relation.thick) {
  for (const certify::Piece& p : piecesOf(cutter)) {
    reach_ = std::max(reach_, p.reach() + p.ball);
  }
}

void CurveSearch::place(const Chord& chord, double aim) {
  const auto& curve = surface_.curve();
  const auto inPlane = [&](const Vec3& v) { return Vec2(curve.u.dot(v), curve.v.dot(v)); };
  axis_ = chord.axis(0.0);
  oblique_ = curve.w.dot(axis_);
  axisInPlane_ = inPlane(axis_);
  const double length = axisInPlane_.norm();
  const Vec2 up = length > 0.0 ? Vec2(axisInPlane_ / length) : Vec2(Vec2::UnitY());
  across_ = {up.y(), -up.x()};
  start_ = inPlane(chord.toolEnd(0.0));
  step_ = inPlane(chord.toolEnd(1.0)) - start_;
  gap_ = aim + thick_;
}

/// The parts of the curve that the cutter may come near to.
void CurveSearch::begin(double from, double to) {
  const auto& pieces = surface_.curve().pieces;
  const Vec2 middle = toolEnd(0.5 * (from + to));
  const double far = reach_ + std::abs(gap_) + 0.5 * step_.norm() * (to - from) + shortest;
  parts_.clear();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& p = pieces[i];
    const Vec2 q = local(p, middle - Vec2(p.u, p.v));
    Part part{i, std::max(q.x() - far, p.openStart ? q.x() - far : 0.0),
              std::min(q.x() + far, p.openEnd ? q.x() + far : p.length), from, to};
    const double aside = std::max({p.lowY - q.y(), q.y() - p.highY, 0.0});
    if (part.x0 <= part.x1 && aside <= far) {
      parts_.push_back(part);
      const bool joint = !p.openEnd && part.x1 == p.length;
      if (joint && gap_ < 0.0) {
        part.x0 = p.length;
        part.corner = true;
        parts_.push_back(part);
      }
    }
  }
}

double CurveSearch::support(const Vec2& direction) const {
  return tool::reach(cutter_, -direction.dot(axisInPlane_));
}

/// The point of the cutter that reaches farthest, from the tool end.
Vec3 CurveSearch::supportPoint(const Vec2& direction) const {
  const auto& curve = surface_.curve();
  const double along = direction.dot(axisInPlane_);
  const tool::ProfilePoint q = tool::reachPoint(cutter_, -along);
  const Vec3 aside = direction.x() * curve.u + direction.y() * curve.v - along * axis_;
  const double length = aside.norm();
  const Vec3 out = length > 0.0 ? Vec3(aside / length) : Vec3(axis_.unitOrthogonal());
  return q.rho * out + q.z * axis_;
}

/// A unit direction from the cutter to a place, from the tool end, that parts them well.
Vec2 CurveSearch::towards(const Vec2& place) const {
  const double across = place.dot(across_);
  const double up = place.x() * -across_.y() + place.y() * across_.x();
  const tool::Body::Away away = body_.away(std::abs(across), up);
  Vec2 best = (across < 0.0 ? -away.byRho : away.byRho) * across_ +
              away.byZ * Vec2(-across_.y(), across_.x());
  if (std::abs(oblique_) <= square) {
    return best;
  }
  double most = best.dot(place) - support(best);
  for (int i = 0; i < looks; ++i) {
    const Vec3 point = supportPoint(best);
    const Vec2 on(surface_.curve().u.dot(point), surface_.curve().v.dot(point));
    const Vec2 next = (place - on).normalized();
    const Vec2 between = (best + next).normalized();
    for (const Vec2& n : {next, between}) {
      const double value = n.allFinite() ? n.dot(place) - support(n) : -unbounded;
      if (value > most) {
        most = value;
        best = n;
      }
    }
  }
  return best;
}

/// Below zero the curve is set back along its normals: what that gives towards `direction`.
double CurveSearch::setBack(const Part& part, const Vec2& direction) const {
  if (gap_ >= 0.0) {
    return -gap_;
  }
  const auto& pieces = surface_.curve().pieces;
  double least = 1.0;
  const auto consider = [&](const Piece& p, double x) {
    const Vec2 d = local(p, direction);
    const double s = slope(p, x);
    least = std::min(least, side_ * (s * d.x() - d.y()) / std::sqrt(1.0 + s * s));
  };
  const Piece& p = pieces[part.piece];
  consider(p, part.x0);
  if (part.corner) {
    consider(pieces[part.piece + 1], 0.0);
  } else {
    consider(p, part.x1);
    const double vertex = p.a != 0.0 ? -p.b / (3.0 * p.a) : part.x0;
    if (vertex > part.x0 && vertex < part.x1) {
      consider(p, vertex);
    }
  }
  // Between two directions the cosine is least at one of them, unless they are far apart.
  return -gap_ * (least > 0.0 ? least : -1.0);
}

double CurveSearch::clearance(const Part& part, const Vec2& direction) const {
  const Piece& p = surface_.curve().pieces[part.piece];
  const Vec2 d = local(p, direction);
  const double third = (part.x1 - part.x0) / 3.0;
  const double y0 = height(p, part.x0);
  const double y3 = height(p, part.x1);
  const double y1 = y0 + slope(p, part.x0) * third;
  const double y2 = y3 - slope(p, part.x1) * third;
  double least = std::min(d.x() * part.x0 + d.y() * y0, d.x() * part.x1 + d.y() * y3);
  if (third > 0.0) {
    least = std::min(
        {least, d.x() * (part.x0 + third) + d.y() * y1, d.x() * (part.x1 - third) + d.y() * y2});
  }
  const double moved = std::max(direction.dot(toolEnd(part.s0)), direction.dot(toolEnd(part.s1)));
  return direction.dot(Vec2(p.u, p.v)) + least - moved - support(direction) +
         setBack(part, direction);
}

void CurveSearch::split(const Part& part) {
  Part first = part;
  Part second = part;
  const double way = step_.norm() * (part.s1 - part.s0);
  if (part.corner || way >= part.x1 - part.x0) {
    first.s1 = second.s0 = 0.5 * (part.s0 + part.s1);
  } else {
    first.x1 = second.x0 = 0.5 * (part.x0 + part.x1);
  }
  parts_.push_back(first);
  parts_.push_back(second);
}

BodyResult CurveSearch::run(const Chord& chord, double from, double to, double aim, int budget) {
  BodyResult result;
  place(chord, aim);
  begin(from, to);
  // One point of the cutter must be on the right side: then all are that no curve parts from it.
  const auto measure = [&](const Vec2& direction, double s) {
    const Vec3 point = chord.toolEnd(s) + supportPoint(direction);
    const double gap = side_ * surface_.foot(point, hint_).distance - thick_;
    if (gap < result.sample) {
      result.sample = gap;
      result.sampleAt = s;
    }
    return gap >= aim;
  };
  if (!measure(axisInPlane_.norm() > 0.0 ? Vec2(axisInPlane_.normalized()) : across_,
               0.5 * (from + to))) {
    return result;
  }
  while (!parts_.empty()) {
    const Part part = parts_.back();
    parts_.pop_back();
    if (++result.measured > budget) {
      return result;
    }
    const double s = 0.5 * (part.s0 + part.s1);
    const double x = 0.5 * (part.x0 + part.x1);
    const Piece& p = surface_.curve().pieces[part.piece];
    // Square to the cutter, which parts it from a sharper curve, or square to the curve.
    const std::array directions{towards(placeOf(p, x) - toolEnd(s)), Vec2(-side_ * normalOf(p, x))};
    if (clearance(part, directions[0]) >= 0.0 || clearance(part, directions[1]) >= 0.0) {
      continue;
    }
    const double size = std::max(part.x1 - part.x0, step_.norm() * (part.s1 - part.s0));
    const Part middle{part.piece, x, x, s, s, part.corner};
    if (clearance(middle, directions[0]) < 0.0 && clearance(middle, directions[1]) < 0.0 &&
        !measure(directions[0], s)) {
      return result;
    }
    if (size <= shortest) {
      return result;
    }
    split(part);
  }
  result.proven = true;
  return result;
}

}  // namespace arelem::certify
