#pragma once
#include <span>

#include "runtime/certify/rim_search.h"

namespace arelem::certify {

/// True where the solid on the negative side is convex; then the distance is a convex function.
template <surface::Surface S>
[[nodiscard]] bool isConvexSolid(const S& s) {
  if constexpr (requires { s.isConvex(); }) {
    return s.isConvex();
  } else {
    return std::is_same_v<S, surface::Cylinder> || std::is_same_v<S, surface::Cone>;
  }
}

/// A cutter in the hollow of a convex solid. How deep a place is inside is a concave function of
/// the place, so along a straight line it is least at an end. That leaves of the cutter the rims of
/// its lines (the tip and the circles where they end), and of a part of a chord its two ends: while
/// the axis turns, places of the cutter are off the straight lines between them by at most
/// turn^2 reach h^2 / 8.
template <surface::Surface S>
class HollowSearch {
 public:
  HollowSearch(const S& surface, const Relation& relation)
      : inside_(relation.side < 0.0 && isConvexSolid(surface)),
        rims_(surface, relation),
        body_(surface, relation) {}

  /// Whether the place is in a hollow at all.
  [[nodiscard]] bool applies() const { return inside_; }
  void take() { known_.clear(); }

  /// Whether the gap of the pieces, which reach as far as `reach` from the tool end, is at least
  /// `aim` for s in [from, to]; `low` holds always.
  BodyResult run(const Chord& chord,
                 std::span<const Piece> pieces,
                 double reach,
                 double from,
                 double to,
                 double aim,
                 int budget) {
    const double turned = chord.turn() * (to - from);
    const double bulge = 0.125 * turned * turned * reach;
    BodyResult result = at(chord, pieces, from, aim + bulge, budget);
    if (to > from && result.sample >= aim) {
      const BodyResult last = at(chord, pieces, to, aim + bulge, budget);
      result.proven = result.proven && last.proven;
      result.low = std::min(result.low, last.low);
      result.measured += last.measured;
      result.note(last.sample, last.sampleAt, last.sampleOn);
    } else if (to > from) {
      result.proven = false;
      result.low = -unbounded;
    }
    result.low -= bulge;
    return result;
  }

 private:
  /// What was found at a place of the chord.
  struct Known {
    std::span<const Piece> pieces;
    double aim;
    BodyResult result;
  };

  BodyResult at(
      const Chord& chord, std::span<const Piece> pieces, double s, double aim, int budget) {
    for (Known& k : known_) {
      if (k.result.sampleAt == s && k.pieces.data() == pieces.data() &&
          k.pieces.size() == pieces.size()) {
        const bool better =
            k.result.low < aim && k.result.sample >= aim && (k.aim > aim || k.result.proven);
        if (better) {
          k.result = search(chord, pieces, s, aim, budget);
          k.aim = aim;
        }
        BodyResult result = k.result;
        result.proven = result.low >= aim;
        result.measured = better ? result.measured : 0;
        return result;
      }
    }
    known_.push_back({pieces, aim, search(chord, pieces, s, aim, budget)});
    return known_.back().result;
  }

  BodyResult search(
      const Chord& chord, std::span<const Piece> pieces, double s, double aim, int budget) {
    BodyResult all;
    all.proven = true;
    all.low = unbounded;
    all.sampleAt = s;
    const auto add = [&](const BodyResult& r) {
      all.proven = all.proven && r.proven;
      // The search of arcs does not tell by how much it was proven.
      all.low = std::min(all.low, r.proven ? std::max(aim, r.low) : r.low);
      all.note(r.sample, s, r.sampleOn);
      all.measured += r.measured;
    };
    const auto rim = [&](const tool::ProfilePoint& p, double ball) {
      const Vec3 axis = chord.axis(s);
      add(rims_.run(chord.toolEnd(s) + p.z * axis, axis, p.rho, ball, aim, budget));
    };
    for (const Piece& p : pieces) {
      if (p.radius > 0.0) {
        // The whole ball is nearer than the arc of it that cuts, and quickly judged.
        const Vec3 axis = chord.axis(s);
        const BodyResult whole =
            rims_.run(chord.toolEnd(s) + p.a.z * axis, axis, p.a.rho, p.radius, aim, budget);
        if (whole.proven) {
          all.low = std::min(all.low, whole.low);
        } else {
          add(body_.run(chord, p, s, s, aim, budget));
        }
      } else {
        rim(p.a, p.ball);
        if (p.length() > 0.0) {
          rim(p.b, p.ball);
        }
      }
    }
    return all;
  }

  bool inside_;
  RimSearch<S> rims_;
  BodySearch<S> body_;
  std::vector<Known> known_;  ///< of the chord taken last
};

}  // namespace arelem::certify
