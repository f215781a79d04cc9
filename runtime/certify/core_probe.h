#pragma once
#include "runtime/certify/probe.h"

namespace arelem::certify {

/// A ball about a place of the tool axis (or, with radius 0, that place alone) against a surface.
struct Core {
  double height = 0.0;  ///< of the center above the tool end
  double ball = 0.0;
};

/// The upper bound of the bends of the distance on one side of a surface within `radius` of two
/// places, and the lower one.
template <surface::Surface S>
[[nodiscard]] Curving bendsOnSide(
    const S& surface, double side, const Node& a, const Node& b, double radius) {
  const surface::Bends p = surface.bends(a.point, a.foot, radius);
  const surface::Bends q = surface.bends(b.point, b.foot, radius);
  const double low = std::min(p.low, q.low);
  const double high = std::max(p.high, q.high);
  return side > 0.0 ? Curving{low, high} : Curving{-high, -low};
}

/// Bounds by s of a function that bends by `bends` per length, for a point that moves by at most
/// `speed` and is turned aside by at most `aside`.
[[nodiscard]] inline Curving bySpeed(const Curving& bends, double speed, double aside) {
  if (speed == 0.0) {
    return {-aside, aside};
  }
  return {std::min(0.0, bends.least) * speed * speed - aside,
          std::max(0.0, bends.most) * speed * speed + aside};
}

/// The gap of a core along a chord: exact at nodes, bounded between them by the bends of the
/// distance.
template <surface::Surface S>
class CoreGap {
 public:
  CoreGap(const S& surface, const Relation& relation) : surface_(surface), relation_(relation) {}

  void take(const Chord& chord, const Core& core) {
    chord_ = &chord;
    core_ = core;
    const double lever = std::abs(core.height);
    speed_ = chord.length() + chord.turn() * lever;
    aside_ = chord.turn() * chord.turn() * lever;
  }

  [[nodiscard]] Node at(double s) {
    Node n = placeOn(*chord_, s);
    const Vec3 offset = core_.height * n.axis;
    n.point = n.toolEnd + offset;
    n.foot = surface_.foot(n.point, hint_);
    n.normal = relation_.side * n.foot.normal;
    n.high = relation_.side * n.foot.distance - core_.ball - relation_.thick;
    n.low = n.high;
    n.slope = n.normal.dot(chord_->velocity(offset));
    return n;
  }

  /// The gap between two nodes, and the least component along the axis that its normal has there.
  struct Passed {
    Range range;
    double leastAlong = 0.0;
  };
  [[nodiscard]] Passed over(const Node& a, const Node& b) const {
    const double h = b.s - a.s;
    const Curving c = bends(a, b);
    const double turn = std::max(std::abs(c.least), std::abs(c.most)) * speed_ + chord_->turn();
    return {between(a, b, h, bySpeed(c, speed_, aside_), speed_),
            std::min(a.normal.dot(a.axis), b.normal.dot(b.axis)) - 0.5 * turn * h};
  }
  /// The place of the ball that touches at a node.
  [[nodiscard]] Node onBall(Node n) const {
    n.point -= core_.ball * n.normal;
    n.foot.distance -= relation_.side * core_.ball;
    n.slope = n.normal.dot(chord_->velocity(n.point - n.toolEnd));
    return n;
  }

 private:
  /// Every place between is within half the way of one of the two.
  [[nodiscard]] Curving bends(const Node& a, const Node& b) const {
    return bendsOnSide(surface_, relation_.side, a, b, 0.5 * speed_ * (b.s - a.s));
  }

  const S& surface_;
  Relation relation_;
  typename S::Hint hint_{};
  const Chord* chord_ = nullptr;
  Core core_;
  double speed_ = 0.0, aside_ = 0.0;
};

}  // namespace arelem::certify
