#pragma once
#include <span>

#include "ir/space/motion_tolerance.h"
#include "runtime/certify/core_probe.h"
#include "runtime/certify/curve_search.h"
#include "runtime/certify/hollow_search.h"
#include "runtime/certify/support_planes.h"
#include "runtime/tool/contact.h"
#include "runtime/tool/rounded.h"

namespace arelem::certify {

/// A cutter against any kind of surface. It takes one of four ways:
///   wall     a wall along the axis meets the cutter as a ball of its largest radius
///   ball     a ball end is its ball, or the arc of it below the top of the cutter, where the
///            contact is on that; what is beside it is cleared by the plane that supports the
///            contact, else searched; where that does not do, one of the next two ways (widen)
///   convex   outside a convex solid the gap of a convex cutter is a convex function of the tool
///   end:
///            chords bound it from above, supporting planes from below
///   general  search of all pieces from below, the contact kept on the cutter from above
/// Searches in the hollow of a convex solid need only the rims of the cutter at both ends.
/// Contacts are guesses by runtime/tool: a bound holds whatever they are.
template <surface::Surface S>
class CutterProbe final : public Probe {
 public:
  CutterProbe(S surface, const Relation& relation)
      : surface_(std::move(surface)),
        cutter_(*relation.cutter),
        relation_(relation),
        core_(surface_, relation_),
        search_(surface_, relation_),
        hollow_(surface_, relation_),
        curve_(surface_, cutter_, relation_),
        planes_(surface_, cutter_, relation_),
        pieces_(piecesOf(cutter_)) {
    relation_.cutter = &cutter_;
    convex_ = relation.side > 0.0 && isConvexSolid(surface_) && isConvex(cutter_);
    for (const Piece& p : pieces_) {
      reach_ = std::max(reach_, p.reach() + p.ball);
    }
    if (cutter_.r > 0.0) {
      const double above = cutter_.h - cutter_.f;
      ballEnds_ = isCut() ? cutter_.sinBeta : -above / std::hypot(above, cutter_.sideEnd.rho);
    }
  }

  void take(const Chord& chord) override {
    chord_ = acrossLines(chord);
    before_ = way_;
    hollow_.take();
    if (isWall()) {
      way_ = Way::wall;
      core_.take(chord_, {0.0, cutter_.maxRadius()});
    } else if (!cutter_.ring && cutter_.e == 0.0 && (!isCut() || cutter_.alpha == 0.0)) {
      way_ = Way::ball;
      core_.take(chord_, {cutter_.f, cutter_.r});
    } else {
      way_ = convex_ ? Way::convex : Way::general;
    }
  }

  bool widen() override {
    if (way_ != Way::ball || (pieces_.size() == 1 && !isCut())) {
      return false;
    }
    way_ = convex_ ? Way::convex : Way::general;
    return true;
  }

  Node resume(const Node& previous) override {
    return way_ == before_ ? turned(previous, chord_) : at(0.0);
  }

  Node at(double s) override {
    if (way_ == Way::wall || way_ == Way::ball) {
      Node core = core_.at(s);
      if (way_ == Way::ball && core.normal.dot(core.axis) < ballEnds_) {
        core.high = unbounded;
      }
      return core;
    }
    Node n = placeOn(chord_, s);
    touch(n, guess_);
    n.low = convex_ ? planes_.below(n, n) : -unbounded;
    n.support = n.normal;
    if constexpr (std::is_same_v<S, surface::Cone>) {
      if (convex_) {
        planes_.supportAtTip(n, chord_);
      }
    }
    return n;
  }

  Stretch over(const Node& a, const Node& b, double aim) override {
    Stretch result;
    if (way_ == Way::wall) {
      static_cast<Range&>(result) = core_.over(a, b).range;
    } else if (way_ == Way::ball) {
      const auto [range, leastAlong] = core_.over(a, b);
      static_cast<Range&>(result) = range;
      if (!(leastAlong >= ballEnds_)) {
        result.high = highest(core_.onBall(a), core_.onBall(b));
      }
      clearRest(a, b, aim, result);
    } else if (way_ == Way::convex) {
      static_cast<Range&>(result) = overConvex(a, b);
      // What supports the cutter with its top face may be far below the gap without it; and a line
      // of the cutter that lies on the solid and turns with it leaves the planes of both ends.
      const bool unsupported =
          std::min(a.low, b.low) < aim || (chord_.turn() > 0.0 && b.s - a.s <= shortTurn);
      if (aim > -unbounded && result.low < aim && unsupported && std::min(a.high, b.high) >= aim) {
        result.low = std::max(result.low, searched(a.s, b.s, aim, pieces_, result));
      }
    } else {
      result.high = highest(a, b);
      const double hull = overHull(a, b);
      result.low = hull >= aim ? hull : searched(a.s, b.s, aim, pieces_, result);
    }
    return result;
  }

  void settle(Node& node, double aim) override {
    Stretch result;
    if (way_ == Way::general || way_ == Way::convex) {
      node.low = std::max(node.low, searched(node.s, node.s, aim, pieces_, result));
      if (result.sample < node.high) {
        Node again = node;
        tool::Search<S> search;
        touch(again, search);
        node = again.high < node.high ? again : node;
      }
      if (result.sample < node.high) {
        measureAt(node, result.sampleOn);
      }
    }
  }

 private:
  enum class Way : std::uint8_t { none, wall, ball, convex, general };
  /// Places measured for one part of a chord.
  static constexpr int budget = 20000;
  /// Places measured in vain for all cut vectors of a motion: what stays undecided must not take
  /// hours.
  static constexpr int patience = 1000000;
  /// A part of a turn on which planes should do. What they lose is halved with it, where others
  /// lose a quarter.
  static constexpr double shortTurn = 1.0 / 256.0;
  /// A contact this near to the cutter is on it. Part unit.
  static constexpr double onCutter = 1e-9;

  [[nodiscard]] bool isWall() const {
    const Vec3 wall = surface::generatrix(surface_);
    return chord_.turn() == 0.0 && !cutter_.ring && wall.squaredNorm() > 0.5 &&
           wall.cross(chord_.axis(0.0)).norm() <= tolerance::wallAlongAxis;
  }

  /// Along the lines of a cylinder the gap of a tool that does not turn stays as it is: the chord
  /// without that part has the same gaps at the same times, and hardly bends.
  [[nodiscard]] Chord acrossLines(const Chord& chord) const {
    if constexpr (std::is_same_v<S, surface::Cylinder>) {
      if (chord.turn() == 0.0) {
        const Vec3 along = chord.step().dot(surface_.axis) * surface_.axis;
        return {chord.toolEnd(0.0), chord.toolEnd(1.0) - along, chord.axis(0.0), chord.axis(1.0)};
      }
    }
    return chord;
  }

  /// True where the ball looks out at the top of the cutter, so that only an arc of it cuts.
  [[nodiscard]] bool isCut() const { return pieces_.front().radius > 0.0; }

  /// Measures the gap at a point of the cutter that is likely to be the contact.
  void touch(Node& n, tool::Search<S>& search) {
    const tool::Contact guess =
        tool::contact(surface_, relation_.side, cutter_, n.toolEnd, n.axis, search);
    const Vec3 w = guess.point - n.toolEnd;
    const double z = w.dot(n.axis);
    const double rho = (w - z * n.axis).norm();
    tool::ProfilePoint nearest;
    const double off = std::abs(tool::distanceTo(cutter_, {rho, z}, nearest));
    const Vec3 out = squareTo(n.axis, w);
    measureAt(n, off <= onCutter ? guess.point
                                 : Vec3(n.toolEnd + nearest.rho * out + nearest.z * n.axis));
  }

  void measureAt(Node& n, const Vec3& point) {
    n.point = point;
    n.foot = surface_.foot(n.point, hint_);
    n.normal = relation_.side * n.foot.normal;
    n.high = relation_.side * n.foot.distance - relation_.thick;
    n.slope = n.normal.dot(chord_.velocity(n.point - n.toolEnd));
  }

  [[nodiscard]] Range overConvex(const Node& a, const Node& b) const {
    const double h = b.s - a.s;
    const double rate = chord_.length() + chord_.turn() * reach_;
    if (chord_.turn() == 0.0) {
      const Known left{a.low, a.high, a.support.dot(chord_.step())};
      const Known right{b.low, b.high, b.support.dot(chord_.step())};
      Range range = between(left, right, h, {0.0, unbounded}, rate);
      if (!planes_.reachesBelowTop(a, b, range.low, chord_)) {
        range.high = highest(a, b);
      }
      return range;
    }
    // The reach towards a fixed plane is the greatest of circular motions: over a chord it bulges
    // by at most turn^2 reach h^2 / 8.
    const double bulge = 0.125 * chord_.turn() * chord_.turn() * reach_ * h * h;
    const double byA = std::min(planes_.best(a, a), planes_.best(a, b));
    const double byB = std::min(planes_.best(b, a), planes_.best(b, b));
    return {std::max(byA, byB) - bulge, highest(a, b)};
  }

  /// Lower bound by planes that support the hull of the surface, where that is known.
  [[nodiscard]] double overHull(const Node& a, const Node& b) const {
    if constexpr (std::is_same_v<S, surface::Torus>) {
      if (relation_.side > 0.0) {
        const double turned = chord_.turn() * (b.s - a.s);
        const double byA = std::min(planes_.belowHull(a, a), planes_.belowHull(a, b));
        const double byB = std::min(planes_.belowHull(b, a), planes_.belowHull(b, b));
        return std::max(byA, byB) - 0.125 * turned * turned * reach_;
      }
    }
    return -unbounded;
  }

  /// Upper bound between two nodes: the contacts of both, kept on the cutter.
  [[nodiscard]] double highest(const Node& a, const Node& b) const {
    const double h = b.s - a.s;
    const double lever = std::max((a.point - a.toolEnd).norm(), (b.point - b.toolEnd).norm());
    const double speed = chord_.length() + chord_.turn() * lever;
    const Curving bends = bendsOnSide(surface_, relation_.side, a, b, speed * h);
    const double aside = chord_.turn() * chord_.turn() * lever;
    const double most = hollow_.applies() ? std::min(0.0, bends.most) : bends.most;
    return between(a, b, h, bySpeed({-unbounded, most}, speed, aside), speed).high;
  }

  /// The pieces beside the core: above `aim` by the plane that supports the core's contact, or by
  /// search.
  void clearRest(const Node& a, const Node& b, double aim, Stretch& result) {
    const std::span<const Piece> rest = std::span(pieces_).subspan(1);
    if (aim == -unbounded) {
      result.low = rest.empty() ? result.low : aim;
      return;
    }
    if (rest.empty() || cleared(a, b, rest, std::min(aim, result.low))) {
      return;
    }
    result.low = std::min(result.low, searched(a.s, b.s, aim, rest, result));
  }

  [[nodiscard]] bool cleared(const Node& a,
                             const Node& b,
                             std::span<const Piece> rest,
                             double aim) const {
    const double h = b.s - a.s;
    const double way = h * (chord_.length() + chord_.turn() * reach_);
    double size = way;
    for (const Piece& p : rest) {
      size = std::max(size, way + std::max(std::hypot(p.a.rho, p.a.z - cutter_.f),
                                           std::hypot(p.b.rho, p.b.z - cutter_.f)));
    }
    const surface::Bends bends = surface_.bends(a.point, a.foot, size);
    const double low = std::min(0.0, relation_.side > 0.0 ? bends.low : -bends.high);
    const double nz = a.normal.dot(a.axis);
    const double sine = std::sqrt(std::max(0.0, 1.0 - nz * nz));
    for (const Piece& p : rest) {
      // Least of n . (y - core) over the piece.
      const double least = p.least(-sine, nz, 0.0, 1.0) - nz * cutter_.f;
      const double gap = relation_.side * a.foot.distance - relation_.thick + least +
                         std::min(0.0, a.slope) * h - (chord_.turn() > 0.0 ? way : 0.0) +
                         0.5 * low * size * size;
      if (!(gap >= aim)) {
        return false;
      }
    }
    return true;
  }

  static void note(const BodyResult& r, Stretch& result) {
    if (r.sample < result.sample) {
      result.sample = r.sample;
      result.sampleAt = r.sampleAt;
      result.sampleOn = r.sampleOn;
    }
  }

  /// `aim` if the gap of the pieces is proven to be at least that, else what is known of it; notes
  /// a lower gap that was measured.
  double searched(
      double from, double to, double aim, std::span<const Piece> pieces, Stretch& result) {
    if (aim > -unbounded && curve_.run(*this, from, to, aim, result)) {
      return aim;
    }
    if (aim == -unbounded) {
      return aim;
    }
    if (inVain_ >= patience || result.sample < aim) {
      return outermost(from, to);
    }
    if (hollow_.applies()) {
      return inHollow(from, to, aim, pieces, result);
    }
    double low = aim;
    for (const Piece& p : pieces) {
      const BodyResult r = search_.run(chord_, p, from, to, aim, budget);
      note(r, result);
      if (r.sample < aim) {
        return outermost(from, to);
      }
      low = r.proven ? low : std::min(low, r.low);
      inVain_ += r.proven ? 0 : r.measured;
    }
    return low;
  }

  /// Lower bound from the tool end alone: all places of the cutter are within its reach.
  [[nodiscard]] double outermost(double from, double to) {
    typename S::Hint hint = hint_;
    const surface::Foot foot = surface_.foot(chord_.toolEnd(0.5 * (from + to)), hint);
    return relation_.side * foot.distance - relation_.thick - reach_ -
           0.5 * (to - from) * chord_.length();
  }

  double inHollow(
      double from, double to, double aim, std::span<const Piece> pieces, Stretch& result) {
    const BodyResult r = hollow_.run(chord_, pieces, reach_, from, to, aim, budget);
    note(r, result);
    inVain_ += r.proven ? 0 : r.measured;
    return std::isfinite(r.low) ? r.low : outermost(from, to);
  }

  /// The search in the plane, for surfaces along which nothing changes.
  struct NoCurve {
    NoCurve(const S&, const tool::Profile&, const Relation&) {}
    bool run(const CutterProbe&, double, double, double, Stretch&) { return false; }
  };
  struct Curve {
    Curve(const S& surface, const tool::Profile& cutter, const Relation& relation)
        : search(surface, cutter, relation) {}
    bool run(const CutterProbe& probe, double from, double to, double aim, Stretch& result) {
      const BodyResult r = search.run(probe.chord_, from, to, aim, budget);
      note(r, result);
      return r.proven;
    }
    CurveSearch search;
  };

  S surface_;
  tool::Profile cutter_;
  Relation relation_;
  CoreGap<S> core_;
  BodySearch<S> search_;
  HollowSearch<S> hollow_;
  std::conditional_t<std::is_same_v<S, surface::TabulatedCylinder>, Curve, NoCurve> curve_;
  SupportPlanes<S> planes_;
  std::vector<Piece> pieces_;
  tool::Search<S> guess_;
  typename S::Hint hint_{};
  Chord chord_;
  Way way_ = Way::none, before_ = Way::none;
  bool convex_ = false;
  int inVain_ = 0;
  double reach_ = 0.0;
  /// Least component along the axis of a normal of the ball by which it touches, or what is nearer
  /// than the ball does: below that the ball looks out of the cutter at the top.
  double ballEnds_ = -unbounded;
};

}  // namespace arelem::certify
