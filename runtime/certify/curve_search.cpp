#include "runtime/certify/curve_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/geometry/least.h"

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
/// Below this a direction is looked for again, though that at the middle parts the cutter from it.
constexpr double small = 1e-6;

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

Vec2 CurveSearch::inPlane(const Vec3& v) const {
  return {surface_.curve().u.dot(v), surface_.curve().v.dot(v)};
}

CurveSearch::Pose CurveSearch::poseOf(const Vec3& axis, const Vec2& toolEnd) const {
  Pose pose{axis, inPlane(axis), Vec2::UnitX(), surface_.curve().w.dot(axis), toolEnd};
  const double length = pose.axisInPlane.norm();
  const Vec2 up = length > 0.0 ? Vec2(pose.axisInPlane / length) : Vec2(Vec2::UnitY());
  pose.across = {up.y(), -up.x()};
  return pose;
}

CurveSearch::Pose CurveSearch::poseAt(double s) const {
  const Vec2 toolEnd = first_.toolEnd + s * step_;
  if (chord_->turn() > 0.0) {
    return poseOf(chord_->axis(s), toolEnd);
  }
  Pose pose = first_;
  pose.toolEnd = toolEnd;
  return pose;
}

void CurveSearch::place(const Chord& chord, double aim) {
  chord_ = &chord;
  first_ = poseOf(chord.axis(0.0), inPlane(chord.toolEnd(0.0)));
  step_ = inPlane(chord.toolEnd(1.0)) - first_.toolEnd;
  inPlaneTurn_ = chord.turn() * chord.pole().dot(surface_.curve().w);
  gap_ = aim + thick_;
}

/// The way of the tool during a part, at its fastest place.
double CurveSearch::wayOf(const Part& part) const {
  return (step_.norm() + chord_->turn() * reach_) * (part.s1 - part.s0);
}

/// The parts of the curve that the cutter may come near to.
void CurveSearch::begin(double from, double to) {
  const auto& pieces = surface_.curve().pieces;
  const Vec2 middle = poseAt(0.5 * (from + to)).toolEnd;
  const double far = reach_ + std::abs(gap_) + 0.5 * step_.norm() * (to - from) + shortest;
  far_ = 0.0;
  parts_.clear();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& p = pieces[i];
    const Vec2 q = local(p, middle - Vec2(p.u, p.v));
    Part part{i, std::max(q.x() - far, p.openStart ? q.x() - far : 0.0),
              std::min(q.x() + far, p.openEnd ? q.x() + far : p.length), from, to};
    const double aside = std::max({p.lowY - q.y(), q.y() - p.highY, 0.0});
    if (part.x0 <= part.x1 && aside <= far) {
      parts_.push_back(part);
      for (const Vec2& corner : polygonOf(part)) {
        far_ = std::max(far_, (corner - middle).norm() + step_.norm());
      }
      const bool joint = !p.openEnd && part.x1 == p.length;
      if (joint && gap_ < 0.0) {
        part.x0 = p.length;
        part.corner = true;
        parts_.push_back(part);
      }
    }
  }
}

double CurveSearch::support(const Pose& pose, const Vec2& direction) const {
  return tool::reach(cutter_, -direction.dot(pose.axisInPlane));
}

/// The point of the cutter that reaches farthest, from the tool end.
Vec3 CurveSearch::supportPoint(const Pose& pose, const Vec2& direction) const {
  const auto& curve = surface_.curve();
  const double along = direction.dot(pose.axisInPlane);
  const tool::ProfilePoint q = tool::reachPoint(cutter_, -along);
  const Vec3 out = squareTo(pose.axis, direction.x() * curve.u + direction.y() * curve.v);
  return q.rho * out + q.z * pose.axis;
}

/// A unit direction from the cutter to a place, from the tool end, that parts them well.
Vec2 CurveSearch::towards(const Pose& pose, const Vec2& place) const {
  const double across = place.dot(pose.across);
  const double up = place.x() * -pose.across.y() + place.y() * pose.across.x();
  const tool::Body::Away away = body_.away(std::abs(across), up);
  Vec2 best = (across < 0.0 ? -away.byRho : away.byRho) * pose.across +
              away.byZ * Vec2(-pose.across.y(), pose.across.x());
  if (std::abs(pose.oblique) <= square) {
    return best;
  }
  double most = best.dot(place) - support(pose, best);
  for (int i = 0; i < looks; ++i) {
    const Vec3 point = supportPoint(pose, best);
    const Vec2 on(surface_.curve().u.dot(point), surface_.curve().v.dot(point));
    const Vec2 next = (place - on).normalized();
    const Vec2 between = (best + next).normalized();
    for (const Vec2& n : {next, between}) {
      const double value = n.allFinite() ? n.dot(place) - support(pose, n) : -unbounded;
      if (value > most) {
        most = value;
        best = n;
      }
    }
  }
  return best;
}

/// The direction near another one that parts the cutter best from a place.
Vec2 CurveSearch::sharpened(const Pose& pose, const Vec2& place, const Vec2& direction) const {
  const Vec2 aside(-direction.y(), direction.x());
  const auto turned = [&](double t) -> Vec2 { return (direction + t * aside).normalized(); };
  const auto reachBeyond = [&](double t) {
    const Vec2 n = turned(t);
    return support(pose, n) - n.dot(place);
  };
  return turned(geometry::narrowLeast(reachBeyond, -1.0, 1.0,
                                      [](double, double width) { return width > shortest; }));
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
    consider(pieces[(part.piece + 1) % pieces.size()], 0.0);
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

/// The polygon that holds a part of the curve, and is it where the part has no length.
CurveSearch::Polygon CurveSearch::polygonOf(const Part& part) const {
  const Piece& p = surface_.curve().pieces[part.piece];
  const double third = (part.x1 - part.x0) / 3.0;
  const double y0 = height(p, part.x0);
  const double y3 = height(p, part.x1);
  const auto place = [&](double x, double y) {
    return Vec2(p.u + x * p.dirU - y * p.dirV, p.v + x * p.dirV + y * p.dirU);
  };
  return {place(part.x0, y0), place(part.x0 + third, y0 + slope(p, part.x0) * third),
          place(part.x1 - third, y3 - slope(p, part.x1) * third), place(part.x1, y3)};
}

/// How far a polygon is beyond the cutter.
double CurveSearch::beyond(const Pose& pose, const Vec2& direction, const Polygon& polygon) const {
  double least = unbounded;
  for (const Vec2& corner : polygon) {
    least = std::min(least, direction.dot(corner - pose.toolEnd));
  }
  return least - support(pose, direction);
}

double CurveSearch::clearance(const Part& part, const Vec2& direction) const {
  const Polygon polygon = polygonOf(part);
  const double half = 0.5 * (part.s1 - part.s0) * inPlaneTurn_;
  const Eigen::Rotation2Dd turn(half);
  const Vec2 before = half == 0.0 ? direction : Vec2(turn.inverse() * direction);
  const Vec2 after = half == 0.0 ? direction : Vec2(turn * direction);
  const double least =
      std::min(beyond(poseAt(part.s0), before, polygon), beyond(poseAt(part.s1), after, polygon));
  const double back =
      std::min(setBack(part, before), half == 0.0 ? unbounded : setBack(part, after));
  return least - bulge(part.s1 - part.s0) + back;
}

/// What lines that turn with the tool lose between the ends of a time: of the way of the tool end,
/// of places of the curve, and of the cutter as seen from a line, where the tool turns in another
/// plane.
double CurveSearch::bulge(double time) const {
  const double turn = chord_->turn();
  if (turn == 0.0) {
    return 0.0;
  }
  const double along = std::abs(inPlaneTurn_);
  const double aside = std::sqrt(std::max(0.0, turn * turn - along * along));
  return 0.125 * time * time *
         (2.0 * along * step_.norm() + along * along * far_ + aside * (turn + along) * reach_);
}

void CurveSearch::split(const Part& part) {
  Part first = part;
  Part second = part;
  if (part.corner || wayOf(part) >= part.x1 - part.x0) {
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
  const auto measure = [&](const Pose& pose, const Vec2& direction, double s) {
    const Vec3 point = chord.toolEnd(s) + supportPoint(pose, direction);
    const double gap = side_ * surface_.foot(point, hint_).distance - thick_;
    result.note(gap, s, point);
    return gap >= aim;
  };
  const Pose middle = poseAt(0.5 * (from + to));
  const Vec2& up = middle.axisInPlane;
  if (!measure(middle, up.norm() > 0.0 ? Vec2(up.normalized()) : middle.across,
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
    const Pose pose = poseAt(s);
    const Piece& p = surface_.curve().pieces[part.piece];
    // Square to the cutter, which parts it from a sharper curve, or square to the curve.
    const std::array directions{towards(pose, placeOf(p, x) - pose.toolEnd),
                                Vec2(-side_ * normalOf(p, x))};
    if (clearance(part, directions[0]) >= 0.0 || clearance(part, directions[1]) >= 0.0) {
      continue;
    }
    const double size = std::max(part.x1 - part.x0, wayOf(part));
    const Part place{part.piece, x, x, s, s, part.corner};
    const bool parted =
        clearance(place, directions[0]) >= 0.0 || clearance(place, directions[1]) >= 0.0;
    if (!parted && !measure(pose, directions[0], s)) {
      return result;
    }
    if (!parted || size <= small) {
      // The point is far enough away, so there may be a better direction.
      const Vec2 sharp = sharpened(pose, placeOf(p, x) - pose.toolEnd, directions[0]);
      if (clearance(part, sharp) >= 0.0) {
        continue;
      }
      if (clearance(place, sharp) < 0.0 && !measure(pose, sharp, s)) {
        return result;
      }
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
