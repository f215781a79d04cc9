#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/geometry/same_form.h"
#include "runtime/tool/bracket.h"
#include "runtime/tool/contact.h"
#include "runtime/tool/small_turn.h"
#include "runtime/tool/turns.h"

/// Descents to a local minimum of side * distance over a piece of the cutter. Private to
/// runtime/tool.
namespace arelem::tool {

template <surface::Surface S>
class ContactDescent {
 public:
  ContactDescent(const S& s,
                 double side,
                 const Profile& cutter,
                 const Vec3& te,
                 const Vec3& axis,
                 Search<S>& search)
      : surface_(s), side_(side), cutter_(cutter), te_(te), axis_(axis), search_(search) {}

  /// The direction about the axis is carried on from the last contact in `search`, or aimed at the
  /// surface.
  void begin() {
    if (!search_.valid) {
      search_.toward = -sample(te_ + cutter_.f * axis_).gradient;
    }
    double angle = 0.0;
    if constexpr (surface::Turning<S>) {
      const Vec3 way = te_ - search_.towardAt;
      angle = search_.towardTurns.dot(way) +
              0.5 * way.dot(search_.turnsAlong) * search_.turnsChange.dot(way);
    }
    const bool foretold = angle != 0.0 && std::abs(angle) <= largestForetold;
    turnTo(foretold ? Vec3(search_.toward + angle * axis_.cross(search_.toward)) : search_.toward);
    search_.valid = true;
  }

  /// The contact of a ball about the corner's center, which is on the axis.
  Contact ofBall() {
    last_ = sample(te_ + cutter_.f * axis_);
    search_.toward = -last_.gradient;
    return result(cutter_.r);
  }

  /// From the corner circle into the piece of the profile to which the normal there points.
  Contact nearestPiece() {
    const Contact corner = alongCircle({cutter_.e, cutter_.f}, cutter_.r);
    onCorner_ = true;
    if (cutter_.ring) {
      return corner;
    }
    const double nz = corner.normal.dot(axis_);
    if (cutter_.e == 0.0 && std::abs(nz) < axial) {
      turnTo(-corner.normal);
    }
    // Over a crest the rim is as near as what is between: the bottom's contact stays where it is.
    const bool inwards = nz > 0.0 && corner.normal.dot(search_.toward) > -levelSlope;
    onCorner_ = !inwards && nz <= cutter_.cosAlpha && nz >= cutter_.sinBeta;
    if (cutter_.alpha == 0.0 && cutter_.e > 0.0 && inwards) {
      return onDisc(corner);
    }
    if (nz > cutter_.cosAlpha || (cutter_.alpha > 0.0 && inwards)) {
      return onBottom();
    }
    return nz < cutter_.sinBeta ? onSide(0.0) : corner;
  }
  /// The place of a level bottom over the foot of the last contact; good where it proves to be one.
  Contact onDiscAgain() {
    turnTo(search_.toward);
    const Vec3 way = search_.discFoot - te_;
    const Vec3 offset = way - way.dot(axis_) * axis_;
    last_ = sample(te_ + offset + cutter_.f * axis_);
    search_.onDisc = offset.norm() <= cutter_.e;
    if (!search_.onDisc) {
      turnTo(offset);  // it leaves the bottom there
      return result(cutter_.r);
    }
    search_.onDisc = inDisc(offset);
    const Contact c = result(cutter_.r);
    search_.discFoot = c.point - c.gap * c.normal;
    return c;
  }
  /// True where nearestPiece ended on the corner arc.
  [[nodiscard]] bool onCorner() const { return onCorner_; }

  /// The bottom, from a share of its length; 1 is its rim. Of a level one the corner's ball goes
  /// along, of which the cutter has what is below the side: a contact above that is one of the
  /// side, unless the ball's center, which the cutter has too, is in the surface.
  Contact onBottom(double along = 1.0) {
    if (cutter_.alpha > 0.0) {
      return onLine({0.0, 0.0}, cutter_.bottomEnd, 0.0, along);
    }
    const Contact c = onLine({0.0, cutter_.f}, {cutter_.e, cutter_.f}, cutter_.r, along);
    return c.normal.dot(axis_) < cutter_.sinBeta && c.gap > -cutter_.r ? onSide(0.0) : c;
  }
  /// The side, from a share of its length.
  Contact onSide(double along) { return onLine(cutter_.sideStart, cutter_.sideEnd, 0.0, along); }

  /// The present direction about the axis, at some angle from it.
  [[nodiscard]] Vec3 direction(double angle) const {
    return std::cos(angle) * search_.toward + std::sin(angle) * axis_.cross(search_.toward);
  }
  void turnTo(const Vec3& toward) {
    const Vec3 across = toward - toward.dot(axis_) * axis_;
    const double squared = across.squaredNorm();
    if (squared > alongAxis * alongAxis) {
      search_.toward = unitOf(across, squared);
      if (squared < nearAxis * nearAxis) {
        // What is left of a direction near the axis is rounding too, and leans.
        search_.toward = (search_.toward - search_.toward.dot(axis_) * axis_).normalized();
      }
    } else {
      search_.toward = axis_.unitOrthogonal();
    }
  }
  /// Of a point of the cutter.
  surface::Foot footAt(ProfilePoint q, const Vec3& toward) {
    return surface_.foot(te_ + q.rho * toward + q.z * axis_, search_.hint);
  }

 private:
  static constexpr int limit = 60;
  /// Largest turn about the axis that the last contact foretells for this one. Radians.
  static constexpr double largestForetold = 0.3;
  /// What the gap may be off where the last step of Newton is not looked at. Part unit.
  static constexpr double unseenStep = 1e-11;
  /// Newton's error after a turn this small is its square, and that of the distance the square of
  /// that. Radians.
  static constexpr double settledTurn = 1e-6;
  /// Where the distance bends more than this along the circle, by its radius, a tip is near: the
  /// normal counts there too, which the last step turns by at most that. Radians.
  static constexpr double sharp = 100.0, settledNormal = 1e-4;
  static constexpr double smallestTurn = 1e-15, largestTurn = 1.0;
  /// Turns by a slope that is rounding become no smaller: what one gains. Part unit.
  static constexpr double unseenGain = 1e-24;
  /// Sines of the angle to the axis up to which what is square to it is rounding, or leans by it.
  static constexpr double alongAxis = 1e-12, nearAxis = 1e-4;
  static constexpr int mostClipped = 3;  ///< times that Newton may be held on the rim of the disc
  /// Steps across the disc that are not looked at are not longer than this share of its radius.
  static constexpr double unseenShare = 1e-3;
  /// A normal at the center of a ball with a larger cosine to the axis points nowhere about it.
  static constexpr double axial = 1.0 - 1e-9;
  /// A turn that leaves a maximum. Radians.
  static constexpr double kick = 0.1;
  /// Slopes below this are those of an extreme.
  static constexpr double levelSlope = 1e-12, smallMove = 1e-12;

  struct Sample {
    Vec3 at;
    surface::Foot foot;
    Vec3 gradient;  ///< of side * distance
  };

  void turnBy(double angle) {
    const auto turned = smallTurn(search_.toward, axis_, angle);
    turned ? void(search_.toward = *turned) : turnTo(direction(angle));
  }

  Sample sample(const Vec3& at) {
    const surface::Foot foot = surface_.foot(at, search_.hint);
    return {at, foot, side_ * foot.normal};
  }
  double bend(const Sample& s, const Vec3& t) {
    return side_ * surface_.bend(s.at, s.foot, t, search_.hint);
  }
  [[nodiscard]] Vec3 place(ProfilePoint q) const {
    return te_ + q.rho * search_.toward + q.z * axis_;
  }
  [[nodiscard]] Contact result(double ball) const {
    return {side_ * last_.foot.distance - ball, last_.gradient, last_.at - ball * last_.gradient};
  }

  /// The change of the normal along t: all of it, or only its parts along t and the normal.
  Vec3 turnOf(const Sample& s, const Vec3& t) {
    if constexpr (surface::Turning<S>) {
      return side_ * surface_.turn(s.at, s.foot, t, search_.hint);
    } else {
      return bend(s, t) * t;
    }
  }

  /// Least distance over the circle of a profile point, by Newton on the angle.
  Contact alongCircle(ProfilePoint q, double ball) {
    last_ = sample(place(q));
    const Vec3 turnedBefore = search_.towardTurns;
    search_.towardTurns = Vec3::Zero();
    if (q.rho == 0.0) {
      return result(ball);
    }
    Bracket bracket;
    double turned = 0.0;
    for (int i = 0; i < limit; ++i) {
      const Vec3 tangent = axis_.cross(search_.toward);
      const double slope = last_.gradient.dot(tangent);
      const double pull = -last_.gradient.dot(search_.toward);
      const Vec3 turning = turnOf(last_, tangent);
      const double bent = q.rho * turning.dot(tangent);
      const double curvature = bent + pull;
      const bool newton = curvature > 0.1 * std::abs(pull) && curvature > 0.0;  // NaN amidst
      double angle =
          newton ? -slope / curvature
                 : bracket.paced(-slope / std::max(1e-3, std::abs(pull) + std::abs(curvature)));
      const double steps = std::abs(angle) * (1.0 + std::abs(bent));
      if constexpr (surface::Turning<S>) {
        if (newton && q.rho * steps * steps * std::abs(angle) <= unseenStep &&
            q.rho * std::abs(angle) <= surface::sameForm(surface_, last_.at) &&
            (std::abs(bent) <= sharp || steps <= settledNormal)) {
          finishCircle(q.rho, angle, slope, turning, tangent);
          noteTurns(search_, te_, -1.0 / curvature * turning, turnedBefore);
          break;
        }
      }
      if (std::abs(slope) <= levelSlope && curvature < -settledTurn) {
        angle = kick;
      }
      if (bracket.note(turned, side_ * last_.foot.distance, q.rho * slope, last_.gradient)) {
        if (bracket.lesser() != turned) {
          turnBy(bracket.lesser() - turned);
          last_ = sample(place(q));
        }
        last_.gradient = bracket.meanNormal();
        break;
      }
      const double next = bracket.keep(turned + std::clamp(angle, -largestTurn, largestTurn), i);
      angle = next - turned;
      turned = next;
      turnBy(angle);
      last_ = sample(place(q));
      const double gain = q.rho * std::abs(slope * angle);
      if (newton ? steps <= settledTurn : std::abs(angle) <= smallestTurn || gain <= unseenGain) {
        break;
      }
    }
    return result(ball);
  }

  /// The last step of Newton, by what is known where it begins: the distance to the second order.
  void finishCircle(
      double rho, double angle, double slope, const Vec3& turning, const Vec3& tangent) {
    const Vec3 turned = unitOf(search_.toward + angle * tangent);
    last_.at += rho * (turned - search_.toward);
    search_.toward = turned;
    last_.foot.distance += side_ * 0.5 * rho * angle * slope;
    last_.gradient += rho * angle * turning;
    last_.gradient = unitOf(last_.gradient);
    last_.foot.normal = side_ * last_.gradient;
  }

  /// The curvature of side * distance over the plane of a level bottom.
  struct Across {
    Vec3 turn1 = Vec3::Zero(), turn2 = Vec3::Zero();  ///< changes of the normal, if known
    Eigen::Matrix2d curvature = Eigen::Matrix2d::Zero();
  };
  Across acrossDisc(const Vec3& e1, const Vec3& e2) {
    Across a;
    if constexpr (surface::Turning<S>) {
      a.turn1 = turnOf(last_, e1);
      a.turn2 = turnOf(last_, e2);
      const double mixed = a.turn1.dot(e2);
      a.curvature << a.turn1.dot(e1), mixed, mixed, a.turn2.dot(e2);
    } else {
      const double mixed = 0.25 * (bend(last_, e1 + e2) - bend(last_, e1 - e2));
      a.curvature << bend(last_, e1), mixed, mixed, bend(last_, e2);
    }
    return a;
  }

  /// Newton in the plane of the level bottom, from a sampled place. False where there is no
  /// minimum.
  bool inDisc(Vec3 offset) {
    const Vec3 e1 = search_.toward;
    const Vec3 e2 = axis_.cross(e1);
    int clipped = 0;
    for (int i = 0; i < limit; ++i) {
      const Across across = acrossDisc(e1, e2);
      const Eigen::Vector2d slope(last_.gradient.dot(e1), last_.gradient.dot(e2));
      // A flat direction has no single minimum: stay on the axis along it.
      const double ridge = 1e-9 / std::max(cutter_.e, 1e-9);
      const Eigen::Matrix2d ridged = across.curvature + ridge * Eigen::Matrix2d::Identity();
      const double det = ridged.determinant();
      // Newton that leaves the disc again and again looks for what no curvature foretells: the tip
      // of a cone, an edge.
      if (!(det > 0.0) || ridged(0, 0) <= 0.0 || clipped > mostClipped) {
        return false;
      }
      const double p1 = slope.x() + ridge * offset.dot(e1);
      const double p2 = slope.y() + ridge * offset.dot(e2);
      const Eigen::Vector2d step(-(ridged(1, 1) * p1 - ridged(0, 1) * p2) / det,
                                 -(ridged(0, 0) * p2 - ridged(0, 1) * p1) / det);
      Vec3 next = offset + step.x() * e1 + step.y() * e2;
      const double away = next.norm();
      if (away > cutter_.e) {
        next *= cutter_.e / away;
        ++clipped;
      }
      const double moved = (next - offset).norm();
      if constexpr (surface::Turning<S>) {
        const Vec3 turned = step.x() * across.turn1 + step.y() * across.turn2;
        if (away <= cutter_.e && moved <= unseenShare * cutter_.e &&
            turned.squaredNorm() * moved <= unseenStep) {
          last_.at += next - offset;
          last_.foot.distance +=
              side_ * (slope.dot(step) + 0.5 * step.dot(across.curvature * step));
          last_.gradient = (last_.gradient + turned).normalized();
          break;
        }
      }
      offset = next;
      last_ = sample(te_ + offset + cutter_.f * axis_);
      if (moved <= smallMove * (1.0 + cutter_.e)) {
        break;
      }
    }
    last_.gradient = levelled(last_.gradient, axis_);
    last_.foot.normal = side_ * last_.gradient;
    return true;
  }

  /// The flat bottom; on its rim the circle search has the answer already.
  Contact onDisc(const Contact& rim) {
    const Vec3 e1 = search_.toward;
    if (!inDisc(cutter_.e * e1)) {
      turnTo(e1);
      return onBottom();
    }
    const Contact inner = result(cutter_.r);
    if (inner.gap > rim.gap + levelSlope) {
      return rim;
    }
    search_.onDisc = true;
    search_.discFoot = inner.point - inner.gap * inner.normal;
    return inner;
  }

  /// A straight piece of the profile turned about the axis: the zero of the slope along it, with
  /// the angle at its best everywhere.
  Contact onLine(ProfilePoint a, ProfilePoint b, double ball, double along) {
    const double length = std::hypot(b.rho - a.rho, b.z - a.z);
    if (length <= 0.0) {
      return alongCircle(a, ball);
    }
    Bracket bracket;
    double before = along;
    double slopeBefore = 0.0;
    Contact best;
    for (int i = 0; i < limit; ++i) {
      const ProfilePoint q = at(a, b, along);
      best = alongCircle(q, ball);
      if (q.rho == 0.0 && std::abs(last_.gradient.dot(axis_)) < axial) {
        turnTo(-last_.gradient);  // a tip is left to where the distance falls
      }
      const Vec3 direction = (b.rho - a.rho) * search_.toward + (b.z - a.z) * axis_;
      const double slope = last_.gradient.dot(direction);
      const bool atEnd = (along <= 0.0 && slope >= 0.0) || (along >= 1.0 && slope <= 0.0);
      if (atEnd || std::abs(slope) <= levelSlope * length) {
        break;
      }
      if (bracket.note(along, best.gap, slope, last_.gradient)) {
        if (bracket.lesser() != along) {
          alongCircle(at(a, b, bracket.lesser()), ball);
        }
        last_.gradient = bracket.meanNormal();
        return result(ball);
      }
      const double secant = i > 0 && along != before ? (slope - slopeBefore) / (along - before)
                                                     : bend(last_, direction);
      const double step =
          secant > levelSlope * length ? -slope / secant : (slope < 0.0 ? 1.0 : -1.0);
      const double next = bracket.keep(std::clamp(along + step, 0.0, 1.0), i);
      before = along;
      slopeBefore = slope;
      along = next;
      if (std::abs(along - before) <= smallMove) {
        break;
      }
    }
    return best;
  }
  static ProfilePoint at(ProfilePoint a, ProfilePoint b, double s) {
    return {a.rho + s * (b.rho - a.rho), a.z + s * (b.z - a.z)};
  }

  const S& surface_;
  double side_;
  const Profile& cutter_;
  const Vec3& te_;
  const Vec3& axis_;
  Search<S>& search_;
  Sample last_;
  bool onCorner_ = false;
};

}  // namespace arelem::tool
