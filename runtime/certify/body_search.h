#pragma once
#include <numbers>

#include "runtime/certify/piece.h"
#include "runtime/certify/probe.h"

/// Proof that no point of a cutter comes nearer to a surface than some gap while it moves along a
/// part of a cut vector: branch and bound over time, angle about the axis and place on the profile.
namespace arelem::certify {

/// What the bounds of a box lose to each of its half widths; what is lost most is halved.
struct Loss {
  bool known = false;
  double s = 0.0, angle = 0.0, share = 0.0;
};

/// Part of a piece at part of the time: centers and half widths of s, of the angle and of the share
/// of the way from a to b.
struct Box {
  double s, halfS;
  Turn angle, halfAngle;
  double share, halfShare;
  surface::Bends bends;     ///< of the distance all over a box that contains it
  double low = -unbounded;  ///< no gap is below
  Loss lost = {};
};

struct BodyResult {
  bool proven = false;
  double low = -unbounded;       ///< no gap is below, if it is not proven
  int measured = 0;              ///< places
  double sample = unbounded;     ///< least gap measured
  double sampleAt = 0.0;         ///< its s
  Vec3 sampleOn = Vec3::Zero();  ///< and its point of the cutter

  void note(double gap, double s, const Vec3& point) {
    if (gap < sample) {
      sample = gap;
      sampleAt = s;
      sampleOn = point;
    }
  }
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
      box.lost = {};
      const double gap = measure(box);
      result.note(gap, box.s, onCutter());
      const double below = std::max(box.low, bound(box, gap, aim));
      // A box of no size whose bound is too low lies where the gap passes the aim.
      const bool vain = below < aim && sizeOf(box) < smallest;
      if (vain) {
        descend(box, from, to, aim, result);
      }
      if (gap < aim || vain || ++result.measured > budget) {
        result.low = below;
        for (const Box& left : boxes_) {
          result.low = std::min(result.low, left.low);
        }
        return result;
      }
      if (below < aim) {
        box.low = below;
        split(box);
      }
    }
    result.proven = true;
    return result;
  }

 private:
  static constexpr double pi = std::numbers::pi;
  /// Straight lines that lose less than this share of what there is are no obstacle.
  static constexpr double lostShare = 0.25;
  /// Boxes below this are not halved. Part unit.
  static constexpr double smallest = 1e-9;
  /// Least step downwards, as a share of what there is.
  static constexpr double smallestStep = 1e-10;

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
    return {axis, chord_->pole().cross(axis), chord_->pole()};
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
  /// How far its points are from that of its center, at most, without rests of turns.
  [[nodiscard]] double sizeOf(const Box& box) const {
    return (chord_->length() + chord_->turn() * reach_) * box.halfS +
           widest_ * box.halfAngle.radians + length_ * box.halfShare;
  }
  /// Looks for a gap below `aim` downwards from a box, in [from, to].
  void descend(Box box, double from, double to, double aim, BodyResult& result) {
    double low = unbounded;
    for (double step = 1.0; step > smallestStep && low >= aim;) {
      bool better = false;
      for (const double way : {-step, step}) {
        for (int k = 0; k < 3; ++k) {
          Box next = box;
          const double turn = way * pi;
          if (k == 0) {
            next.s = std::clamp(box.s + way * (to - from), from, to);
          } else if (k == 1) {
            next.angle = box.angle.plus({turn, std::cos(turn), std::sin(turn)}, 1.0);
          } else {
            next.share = std::clamp(box.share + way, 0.0, 1.0);
          }
          const double gap = measure(next);
          ++result.measured;
          if (gap < low) {
            low = gap;
            box = next;
            better = true;
          }
        }
      }
      step *= better ? 1.0 : 0.5;
    }
    result.note(measure(box), box.s, onCutter());
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

  /// The point of the cutter that was measured last.
  [[nodiscard]] Vec3 onCutter() const { return point_ - piece_->ball * normal_; }

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
    // Of what the box is wide by, the parts along straight lines and around.
    const double moves = moved + turned * reach_;
    const double share = length_ * box.halfShare;
    const double straight = 0.5 * (moves * moves + share * share);
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
    // What is straight of it is lowest at its ends, but for what the distance bends up there.
    const double lost = std::max(0.0, high) * straight + bulgeOf(box);
    const bool bounded = std::isfinite(low) && std::isfinite(high);
    const bool little = bounded && lost < lostShare * (gap - aim);
    const bool less = bounded && lost < -0.5 * low * straight;
    if (best < aim && (little || less) && plane - lost >= aim) {
      best = std::max(best, fromRims(box, low) - lost);
    }
    // So are corners, which lose that around too, the plane at the center what it may bend down. No
    // corner is above the plane by more than the box bulges.
    if (best < aim && high < -low && (turned > 0.0 || plane >= aim)) {
      best = std::max(best, fromCorners(box, high));
    }
    // Halving what costs little does not pay, unless the bends are to become narrower.
    if (best < aim && little) {
      box.lost = lossOf(box, low, high);
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

  /// How far straight lines between the places of a box at both ends of its time, and of its share,
  /// are from those places.
  [[nodiscard]] double bulgeOf(const Box& box) const {
    const double turned = chord_->turn() * box.halfS;
    return 0.5 * turned * turned * reach_ +
           piece_->radius * (1.0 - std::cos((piece_->high - piece_->low) * box.halfShare));
  }

  /// Least over the circles at both ends of the time and of the share, each from its place at the
  /// angle of the center, where the distance bends down by at most -low.
  double fromRims(const Box& box, double low) {
    double least = unbounded;
    for (int corner = 0; corner < 4; ++corner) {
      const bool late = (corner & 1) != 0;
      const bool far = (corner & 2) != 0;
      if ((late && box.halfS == 0.0) || (far && box.halfShare == 0.0)) {
        continue;
      }
      const Frame f = frameAt(box.s + (late ? box.halfS : -box.halfS), box.angle);
      const tool::ProfilePoint p = piece_->at(box.share + (far ? box.halfShare : -box.halfShare));
      auto hint = hint_;
      const surface::Foot foot = surface_.foot(f.toolEnd + p.rho * f.radial + p.z * f.axis, hint);
      const double inwards = -side_ * foot.normal.dot(f.radial);
      const double along = side_ * foot.normal.dot(f.around);
      least = std::min(least, side_ * foot.distance - piece_->ball - thick_ +
                                  p.rho * leastOfTurn(inwards + low * p.rho, along, box.halfAngle));
    }
    return least;
  }

  /// What the bounds lose to each half width of the box.
  [[nodiscard]] Loss lossOf(const Box& box, double low, double high) const {
    // Along straight lines either the plane or the corners do.
    const double bend = 0.5 * std::min(std::max(0.0, high), std::max(0.0, -low));
    const double length = length_ * box.halfShare;
    const double moves = (chord_->length() + chord_->turn() * reach_) * box.halfS;
    const double speed = normal_.dot(chord_->velocity(offset_)) * box.halfS;
    const tool::ProfilePoint from = piece_->at(box.share - box.halfShare);
    const tool::ProfilePoint to = piece_->at(box.share + box.halfShare);
    const double rise = 0.5 * (normal_.dot(frame_.radial) * (to.rho - from.rho) +
                               normal_.dot(frame_.axis) * (to.z - from.z));
    // What points off the center turn differently (tilt) is halved with the time and with them.
    const double turned = chord_->turn() * box.halfS;
    const double around = turned * widest_ * std::min(2.0, box.halfAngle.radians);
    Loss loss;
    loss.known = true;
    loss.s = std::abs(speed) + bend * moves * moves + around + turned * length;
    loss.share = std::abs(rise) + bend * length * length + turned * length;
    loss.angle = around - widest_ * leastOfTurn(-normal_.dot(frame_.radial) + low * widest_,
                                                normal_.dot(frame_.around), box.halfAngle);
    return loss;
  }

  void split(const Box& box) {
    const Loss& lost = box.lost;
    const bool any = lost.known && std::max({lost.s, lost.angle, lost.share}) > 0.0;
    const double s = any ? lost.s : (chord_->length() + chord_->turn() * reach_) * box.halfS;
    const double angle = any ? lost.angle : widest_ * box.halfAngle.radians;
    const double share = any ? lost.share : length_ * box.halfShare;
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
