#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "runtime/certify/probe.h"

/// Proof that no point of a cutter comes nearer to a surface than some gap while it moves along a
/// part of a cut vector: branch and bound over time, angle about the axis and place on the profile.
namespace arelem::certify {

/// A piece of the half-profile turned about the axis, thickened by a ball. It is the straight line
/// from a to b, or, with a radius, the arc about a from angle `low` to `high`, counted from
/// straight below a outwards.
struct Piece {
  tool::ProfilePoint a, b;
  double ball = 0.0;
  double radius = 0.0, low = 0.0, high = 0.0;

  [[nodiscard]] double length() const {
    return radius > 0.0 ? radius * (high - low) : std::hypot(b.rho - a.rho, b.z - a.z);
  }
  [[nodiscard]] tool::ProfilePoint at(double share) const {
    const double angle = low + share * (high - low);
    return radius > 0.0
               ? tool::ProfilePoint{a.rho + radius * std::sin(angle),
                                    a.z - radius * std::cos(angle)}
               : tool::ProfilePoint{a.rho + share * (b.rho - a.rho), a.z + share * (b.z - a.z)};
  }
  /// Largest distance from the axis, and from the tool end.
  [[nodiscard]] double widest() const { return std::max(a.rho, b.rho) + radius; }
  [[nodiscard]] double reach() const {
    return std::max(std::hypot(a.rho, a.z), std::hypot(b.rho, b.z)) + radius;
  }
  /// Least of x rho + y z over the part with shares in [from, to].
  [[nodiscard]] double least(double x, double y, double from, double to) const;
};

/// The pieces whose union covers all cutting points of a profile.
[[nodiscard]] std::vector<Piece> piecesOf(const tool::Profile& cutter);

/// An angle by what proofs ask of it.
struct Turn {
  double radians = 0.0, cosine = 1.0, sine = 0.0;

  /// Of an angle of at most pi.
  [[nodiscard]] Turn half() const {
    const double halved = std::sqrt(0.5 * (1.0 + cosine));
    // The sine of a small angle must keep its figures.
    return {0.5 * radians, halved,
            halved > 0.5 ? 0.5 * sine / halved : std::sqrt(0.5 * (1.0 - cosine))};
  }
  [[nodiscard]] Turn plus(const Turn& b, double sign) const {
    return {radians + sign * b.radians, cosine * b.cosine - sign * sine * b.sine,
            sine * b.cosine + sign * cosine * b.sine};
  }
};

/// Least over |x| <= half, half <= pi, of first (1 - cos x) + second sin x.
[[nodiscard]] double leastOfTurn(double first, double second, const Turn& half);

/// Part of a piece at part of the time: centers and half widths of s, of the angle and of the share
/// of the way from a to b.
struct Box {
  double s, halfS;
  Turn angle, halfAngle;
  double share, halfShare;
  surface::Bends bends;     ///< of the distance all over a box that contains it
  double low = -unbounded;  ///< no gap is below
};

struct BodyResult {
  bool proven = false;
  double low = -unbounded;    ///< no gap is below, if it is not proven
  int measured = 0;           ///< places
  double sample = unbounded;  ///< least gap measured
  double sampleAt = 0.0;      ///< its s
};

template <surface::Surface S>
class BodySearch {
 public:
  BodySearch(const S& surface, const Relation& relation)
      : surface_(surface), side_(relation.side), thick_(relation.thick) {}

  /// Whether the gap of the piece is at least `aim` for s in [from, to]. Ends at the first gap
  /// below it, or when `budget` places were measured.
  BodyResult run(
      const Chord& chord, const Piece& piece, double from, double to, double aim, int budget) {
    chord_ = &chord;
    piece_ = &piece;
    reach_ = piece.reach();
    length_ = piece.length();
    BodyResult result;
    boxes_.clear();
    steady_ = baseAt(0.5 * (from + to));
    const Turn half = piece.widest() > 0.0 ? Turn{pi, -1.0, 0.0} : Turn{};
    boxes_.push_back(
        {0.5 * (from + to), 0.5 * (to - from), {}, half, 0.5, length_ > 0.0 ? 0.5 : 0.0, {}});
    while (!boxes_.empty()) {
      Box box = boxes_.back();
      boxes_.pop_back();
      const double gap = measure(box);
      if (gap < result.sample) {
        result.sample = gap;
        result.sampleAt = box.s;
      }
      if (gap < aim || ++result.measured > budget) {
        result.low = std::max(box.low, bound(box, gap, aim));
        for (const Box& left : boxes_) {
          result.low = std::min(result.low, left.low);
        }
        return result;
      }
      const double below = bound(box, gap, aim);
      if (below < aim) {
        box.low = std::max(box.low, below);
        split(box);
      }
    }
    result.proven = true;
    return result;
  }

 private:
  static constexpr double pi = std::numbers::pi;

  /// The axis and two directions square to it.
  struct Base {
    Vec3 axis, e1, e2;
  };
  struct Frame {
    Vec3 toolEnd, axis, radial, around;
  };

  /// The base turns with the tool: its first direction lies in the plane of the turn.
  [[nodiscard]] Base baseAt(double s) const {
    const Vec3 axis = chord_->axis(s);
    const Vec3 e2 = chord_->turn() > 0.0 ? chord_->pole() : Vec3(axis.unitOrthogonal());
    return {axis, e2.cross(axis), e2};
  }
  [[nodiscard]] Frame frameAt(double s, const Turn& angle) const {
    const Base base = chord_->turn() > 0.0 ? baseAt(s) : steady_;
    return {chord_->toolEnd(s), base.axis, angle.cosine * base.e1 + angle.sine * base.e2,
            angle.cosine * base.e2 - angle.sine * base.e1};
  }
  /// Largest distance from the axis within a box: near a tip, where the surface may have one too,
  /// that is little. An arc bulges beyond its ends.
  [[nodiscard]] double widestIn(const Box& box) const {
    const double bulge =
        piece_->radius * (1.0 - std::cos((piece_->high - piece_->low) * box.halfShare));
    return bulge + std::max(piece_->at(box.share - box.halfShare).rho,
                            piece_->at(box.share + box.halfShare).rho);
  }
  double measure(const Box& box) {
    frame_ = frameAt(box.s, box.angle);
    profile_ = piece_->at(box.share);
    widest_ = widestIn(box);
    offset_ = profile_.rho * frame_.radial + profile_.z * frame_.axis;
    point_ = frame_.toolEnd + offset_;
    foot_ = surface_.foot(point_, hint_);
    normal_ = side_ * foot_.normal;
    return side_ * foot_.distance - piece_->ball - thick_;
  }

  /// Lower bound of the gap over the box, from the measured one at its center: the cheapest that
  /// reaches `aim`, or the best.
  double bound(Box& box, double gap, double aim) {
    const double moved = chord_->length() * box.halfS;
    const double turned = chord_->turn() * box.halfS;
    // How far a point of the box is from its center: on the cutter, and in all.
    const double onCutter =
        widest_ * std::min(2.0, box.halfAngle.radians) + length_ * box.halfShare;
    const double away = moved + turned * reach_ + onCutter;
    double best = gap - away;
    if (best >= aim) {
      return best;
    }
    const double plane = gap + tilt(box, turned, onCutter);
    const double squared = 0.5 * away * away;
    const auto bend = [&] {
      const surface::Bends& b = box.bends;
      return side_ > 0.0 ? b : surface::Bends{-b.high, -b.low};
    };
    if (std::isfinite(bend().low)) {
      best = std::max(best, plane + bend().low * squared);
    }
    // No bound is better than what the distance reaches at most where the plane is lowest.
    if (best >= aim || plane + std::max(0.0, bend().high) * squared < aim) {
      return best;
    }
    box.bends = surface::both(box.bends, surface::bendsOf(surface_, point_, foot_, away, hint_));
    const auto [low, high] = bend();
    if (std::isfinite(low)) {
      best = std::max(best, plane + low * squared);
    }
    // Corners lose what the distance may bend up, the plane at the center what it may bend down.
    if (best < aim && high < -low) {
      best = std::max(best, fromCorners(box, high));
    }
    return best;
  }

  /// Least change over the box of the linear function that touches the distance at its center.
  [[nodiscard]] double tilt(const Box& box, double turned, double onCutter) const {
    const double out = normal_.dot(frame_.radial);
    const double along = normal_.dot(frame_.around);
    // Least of out cos x + along sin x for |x| <= halfAngle: within it where x turns it backwards.
    const double size = std::sqrt(out * out + along * along);
    const double least = -out >= size * box.halfAngle.cosine
                             ? -size
                             : out * box.halfAngle.cosine - std::abs(along) * box.halfAngle.sine;
    const double nz = normal_.dot(frame_.axis);
    double change = piece_->least(least, nz, box.share - box.halfShare, box.share + box.halfShare) -
                    (profile_.rho * out + profile_.z * nz);
    const Vec3 velocity = chord_->velocity(offset_);
    change -= std::abs(normal_.dot(velocity)) * box.halfS;
    if (turned > 0.0) {
      // Points off the center turn differently, and along arcs.
      change -= turned * onCutter + 0.5 * turned * turned * reach_;
    }
    return change;
  }

  /// Where the distance bends away from the surface by at most `high`, it is lowest at the corners,
  /// but for the parabola of that bend and for what the box bulges beyond them.
  double fromCorners(const Box& box, double high) {
    const Vec3 center = point_;
    double least = unbounded;
    for (int corner = 0; corner < 8; ++corner) {
      if (((corner & 1) != 0 && box.halfS == 0.0) ||
          ((corner & 2) != 0 && box.halfAngle.radians == 0.0) ||
          ((corner & 4) != 0 && box.halfShare == 0.0)) {
        continue;
      }
      const auto pick = [&](int bit, double middle, double half) {
        return (corner & bit) != 0 ? middle + half : middle - half;
      };
      const Frame f = frameAt(pick(1, box.s, box.halfS),
                              box.angle.plus(box.halfAngle, (corner & 2) != 0 ? 1.0 : -1.0));
      const tool::ProfilePoint p = piece_->at(pick(4, box.share, box.halfShare));
      const Vec3 at = f.toolEnd + p.rho * f.radial + p.z * f.axis;
      auto hint = hint_;
      const double gap = side_ * surface_.foot(at, hint).distance - piece_->ball - thick_;
      least = std::min(least, gap - 0.5 * high * (high > 0.0 ? (at - center).squaredNorm() : 0.0));
    }
    const double turned = chord_->turn() * box.halfS;
    const double bulge =
        widest_ * (1.0 - box.halfAngle.cosine) + 0.5 * turned * turned * reach_ +
        piece_->radius * (1.0 - std::cos((piece_->high - piece_->low) * box.halfShare));
    return least - bulge;
  }

  void split(const Box& box) {
    const double s = (chord_->length() + chord_->turn() * reach_) * box.halfS;
    const double angle = widest_ * box.halfAngle.radians;
    const double share = length_ * box.halfShare;
    Box first = box;
    Box second = box;
    const auto halve = [](double& a, double& b, double& halfA, double& halfB) {
      halfA *= 0.5;
      halfB = halfA;
      a -= halfA;
      b += halfB;
    };
    if (s >= angle && s >= share) {
      halve(first.s, second.s, first.halfS, second.halfS);
    } else if (angle >= share) {
      first.halfAngle = second.halfAngle = box.halfAngle.half();
      first.angle = box.angle.plus(first.halfAngle, -1.0);
      second.angle = box.angle.plus(first.halfAngle, 1.0);
    } else {
      halve(first.share, second.share, first.halfShare, second.halfShare);
    }
    boxes_.push_back(first);
    boxes_.push_back(second);
  }

  const S& surface_;
  double side_, thick_;
  typename S::Hint hint_{};
  const Chord* chord_ = nullptr;
  const Piece* piece_ = nullptr;
  double reach_ = 0.0, length_ = 0.0;
  double widest_ = 0.0;  ///< within the box that was measured last
  std::vector<Box> boxes_;
  Base steady_;  ///< while the axis does not turn
  Frame frame_;
  tool::ProfilePoint profile_;
  Vec3 offset_, point_, normal_;
  surface::Foot foot_;
};

}  // namespace arelem::certify
