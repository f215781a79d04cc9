#include "runtime/tool/section_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/geometry/roots.h"
#include "runtime/tool/rounded.h"

namespace arelem::tool {

namespace {
using Vec2 = Eigen::Vector2d;
using surface::TabulatedCylinder;
using Piece = TabulatedCylinder::Piece;

/// Sine of the angle up to which the generatrix counts as square to the axis.
constexpr double square = 1e-12;
/// Squared sine up to which the curve runs along an edge in a joint of two pieces.
constexpr double sameDirection = 1e-14;
/// A place on an edge is as near as the curve's place below it says, but for rounding.
constexpr double rounding = 1e-10;
/// Share of the sharpest radius of curvature up to which a gouge has one contact.
constexpr double shallow = 0.25;
/// Feet nearer to the center of curvature than this share are not foretold.
constexpr double leastSqueezed = 0.1;

double slope(const Piece& p, double x) {
  return (3.0 * p.a * x + 2.0 * p.b) * x + p.c;
}
Vec2 placeOf(const Piece& p, double x) {
  const double y = ((p.a * x + p.b) * x + p.c) * x;
  return {p.u + x * p.dirU - y * p.dirV, p.v + x * p.dirV + y * p.dirU};
}
/// The unit left normal of a piece.
Vec2 normalOf(const Piece& p, double x) {
  const double s = slope(p, x);
  const double length = std::sqrt(1.0 + s * s);
  return Vec2(-s * p.dirU - p.dirV, p.dirU - s * p.dirV) / length;
}
/// How far the foot of a place goes along a piece, to the first order, as the place goes along
/// `way`: the place is at `distance` and the foot at x, where the left normal is `normal`.
double turned(const Piece& p, double x, double distance, const Vec2& normal, const Vec2& way) {
  const double upright = normal.y() * p.dirU - normal.x() * p.dirV;
  const double along = (normal.y() * way.x() - normal.x() * way.y()) * upright;
  const double bend = 6.0 * p.a * x + 2.0 * p.b;
  const double squeezed = 1.0 - distance * bend * upright * upright * upright;
  return squeezed > leastSqueezed ? along / squeezed : 0.0;
}
double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}
/// At least the sharpest curvature of the curve: slopes only flatten it.
double sharpest(const TabulatedCylinder::Curve& curve) {
  double most = 0.0;
  for (const Piece& p : curve.pieces) {
    if (p.a != 0.0 || p.b != 0.0) {
      most = std::max({most, std::abs(2.0 * p.b), std::abs(6.0 * p.a * p.length + 2.0 * p.b)});
    }
  }
  return most;
}
}  // namespace

void SectionSearch::addBall(double across, double up, double radius, bool cut) {
  Ball& b = balls_[ballCount_++];
  b = {};
  b.center = {across, up};
  b.radius = radius;
  b.cut = cut;
}

/// An edge with the cutter on its left.
void SectionSearch::addEdge(const Vec2& start, const Vec2& direction, double length, double ball) {
  Edge& e = edges_[edgeCount_++];
  e.start = start;
  e.direction = direction;
  e.outward = {direction.y(), -direction.x()};
  e.length = length;
  e.ball = ball;
}

/// A straight part of the profile, on both sides of the axis.
void SectionSearch::addEdges(ProfilePoint from, ProfilePoint to) {
  const Vec2 a(from.rho, from.z);
  const Vec2 b(to.rho, to.z);
  const double length = (b - a).norm();
  if (length <= 0.0) {
    return;
  }
  const Vec2 d = (b - a) / length;
  addEdge(a, d, length, 0.0);
  addEdge({-b.x(), b.y()}, {d.x(), -d.y()}, length, 0.0);
}

/// Places where the slope of a piece is that of the edge, with the surface on the outer side, and
/// joints between whose directions it lies.
void SectionSearch::findLevels(const TabulatedCylinder::Curve& curve,
                               double side,
                               Edge& edge) const {
  const Vec2 wanted = -side * edge.outInPlane;  // the curve's left normal
  const Vec2 a(across_.dot(curve.u), across_.dot(curve.v));
  const Vec2 up(axis_.dot(curve.u), axis_.dot(curve.v));
  const Vec2 start = edge.start.x() * a + edge.start.y() * up;
  const auto add = [&](const Vec2& place, Hint hint) {
    edge.levels.push_back({(place - start).dot(edge.inPlane),
                           (place - start).dot(edge.outInPlane) - edge.ball, hint});
  };
  edge.levels.clear();
  for (std::size_t i = 0; i < curve.pieces.size(); ++i) {
    const Piece& p = curve.pieces[i];
    const int index = static_cast<int>(i);
    const double along = wanted.y() * p.dirU - wanted.x() * p.dirV;
    if (along > 0.0 && (p.a != 0.0 || p.b != 0.0)) {
      const double steep = -(wanted.x() * p.dirU + wanted.y() * p.dirV) / along;
      const auto roots = geometry::solveQuadratic(3.0 * p.a, p.b, p.c - steep);
      for (int k = 0; k < roots.count; ++k) {
        const double x = k == 0 ? roots.first : roots.second;
        if (x >= 0.0 && x <= p.length) {
          add(placeOf(p, x), {index, x});
        }
      }
    }
    if (i + 1 < curve.pieces.size()) {
      const Vec2 before = normalOf(p, p.length);
      const Vec2 behind = normalOf(curve.pieces[i + 1], 0.0);
      const bool between = cross(before, wanted) * cross(wanted, behind) >= -sameDirection;
      if (between && wanted.dot(before) > 0.0 && wanted.dot(behind) > 0.0) {
        add({curve.pieces[i + 1].u, curve.pieces[i + 1].v}, {index + 1, 0.0});
      }
    }
  }
}

void SectionSearch::prepare(const TabulatedCylinder& s,
                            double side,
                            const Profile& cutter,
                            const Vec3& axis) {
  const TabulatedCylinder::Curve& curve = s.curve();
  axis_ = axis;
  ballCount_ = edgeCount_ = last_ = 0;
  state_ = State::useless;
  if (!(std::abs(curve.w.dot(axis)) <= square) || !isRounded(cutter)) {
    return;
  }
  state_ = State::useful;
  across_ = axis.cross(curve.w).normalized();
  side_ = side;
  deepest_ = -shallow / std::max(sharpest(curve), std::numeric_limits<double>::min());
  lowestNormal_ = cutter.sinBeta;
  const bool cut = cutter.h < cutter.f + cutter.r;
  addBall(cutter.e, cutter.f, cutter.r, cut);
  if (cutter.e > 0.0) {
    addBall(-cutter.e, cutter.f, cutter.r, cut);
  }
  if (cutter.alpha == 0.0 && cutter.e > 0.0) {
    addEdge({-cutter.e, cutter.f}, Vec2::UnitX(), 2.0 * cutter.e, cutter.r);
  } else if (cutter.alpha != 0.0) {
    addBall(0.0, 0.0, 0.0, false);
    addEdges({0.0, 0.0}, cutter.bottomEnd);
  }
  addEdges(cutter.sideStart, cutter.sideEnd);
  addBall(cutter.sideEnd.rho, cutter.sideEnd.z, 0.0, false);
  addBall(-cutter.sideEnd.rho, cutter.sideEnd.z, 0.0, false);
  addEdge({cutter.sideEnd.rho, cutter.sideEnd.z}, -Vec2::UnitX(), 2.0 * cutter.sideEnd.rho, 0.0);
  for (std::size_t i = 0; i < ballCount_; ++i) {
    const Vec3 center = inSpace(balls_[i].center);
    balls_[i].inPlane = {center.dot(curve.u), center.dot(curve.v)};
  }
  for (std::size_t i = 0; i < edgeCount_; ++i) {
    Edge& e = edges_[i];
    const Vec3 direction = inSpace(e.direction);
    const Vec3 outward = inSpace(e.outward);
    e.inPlane = {direction.dot(curve.u), direction.dot(curve.v)};
    e.outInPlane = {outward.dot(curve.u), outward.dot(curve.v)};
    findLevels(curve, side, e);
  }
}

/// The gap of a ball, exactly, in the place where the tool is.
double SectionSearch::measure(const TabulatedCylinder& s, Ball& ball, const Vec2& at) {
  const Vec2 center = at + ball.inPlane;
  if (ball.known && ball.hint.piece >= 0) {
    const Piece& p = s.curve().pieces[static_cast<std::size_t>(ball.hint.piece)];
    ball.hint.x +=
        turned(p, ball.hint.x, side_ * (ball.gap + ball.radius), ball.normal, at - ball.at);
  }
  const auto foot = s.footInPlane(center.x(), center.y(), ball.hint);
  ball.gap = side_ * foot.distance - ball.radius;
  ball.normal = {foot.normalU, foot.normalV};
  ball.at = at;
  ball.known = true;
  return ball.gap;
}

/// The nearest ball. Balls are measured only where they may have come as near as the nearest by the
/// way of the tool.
const SectionSearch::Ball& SectionSearch::nearestBall(const TabulatedCylinder& s, const Vec2& at) {
  double least = measure(s, balls_[last_], at);
  for (std::size_t i = 0; i < ballCount_; ++i) {
    Ball& b = balls_[i];
    if (i == last_ || (b.known && b.gap >= least &&
                       (b.gap - least) * (b.gap - least) >= (at - b.at).squaredNorm())) {
      continue;
    }
    if (measure(s, b, at) < least) {
      least = b.gap;
      last_ = i;
    }
  }
  return balls_[last_];
}

std::optional<Contact> SectionSearch::contact(const TabulatedCylinder& s,
                                              double side,
                                              const Profile& cutter,
                                              const Vec3& te,
                                              const Vec3& axis) {
  low_.reset();
  if (state_ == State::unknown || axis != axis_) {
    prepare(s, side, cutter, axis);
  }
  if (state_ == State::useless) {
    return std::nullopt;
  }
  const Vec2 at(te.dot(s.curve().u), te.dot(s.curve().v));
  const Ball& ball = nearestBall(s, at);
  double least = ball.gap;
  const Edge* edge = nullptr;
  const Level* level = nullptr;
  for (std::size_t i = 0; i < edgeCount_; ++i) {
    if (edges_[i].levels.empty()) {
      continue;
    }
    const double moved = at.dot(edges_[i].inPlane);
    const double raised = at.dot(edges_[i].outInPlane);
    for (const Level& l : edges_[i].levels) {
      const double along = l.along - moved;
      if (l.gap - raised < least && along >= 0.0 && along <= edges_[i].length) {
        least = l.gap - raised;
        edge = &edges_[i];
        level = &l;
      }
    }
  }
  const Vec3 normal = side * (ball.normal.x() * s.curve().u + ball.normal.y() * s.curve().v);
  if (!ball.cut || normal.dot(axis) >= lowestNormal_) {
    low_ = Contact{ball.gap, normal, te + inSpace(ball.center) - ball.radius * normal};
  }
  if (edge != nullptr) {
    return onEdge(s, te, *edge, *level, {level->along - at.dot(edge->inPlane), least});
  }
  return least >= deepest_ ? low_ : std::nullopt;
}

/// The contact with an edge; below the surface another of its places may be nearer than the one
/// that runs along the edge.
std::optional<Contact> SectionSearch::onEdge(const TabulatedCylinder& s,
                                             const Vec3& te,
                                             const Edge& edge,
                                             const Level& level,
                                             const Level& here) {
  const Vec3 outward = inSpace(edge.outward);
  const Vec2 place = edge.start + here.along * edge.direction;
  Vec3 on = te + inSpace(place);
  if (edge.outward.y() == 1.0) {
    // The top: only its rim cuts, which is beside the section.
    const double rim = edge.start.x();
    on += std::sqrt(std::max(0.0, rim * rim - place.x() * place.x())) * s.generatrix();
  }
  const Contact contact{here.gap, -outward, on + edge.ball * outward};
  if (here.gap >= 0.0) {
    return contact;
  }
  Hint hint = level.hint;
  const surface::Foot foot = s.foot(on, hint);
  const double gap = side_ * foot.distance - edge.ball;
  if (here.gap >= deepest_ && std::abs(gap - here.gap) <= rounding * (1.0 + std::abs(gap))) {
    return contact;
  }
  if (!low_ || gap < low_->gap) {
    const Vec3 normal = side_ * foot.normal;
    low_ = Contact{gap, normal, on - edge.ball * normal};
  }
  return std::nullopt;
}

}  // namespace arelem::tool
