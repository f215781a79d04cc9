#include "runtime/certify/probe.h"

#include "runtime/certify/cutter_probe.h"
#include "runtime/certify/mesh_point_probe.h"
#include "runtime/certify/mesh_probe.h"
#include "runtime/certify/mesh_ring_probe.h"

namespace arelem::certify {

namespace {
/// The tool end alone: relation ON.
template <surface::Surface S>
class PointProbe final : public Probe {
 public:
  PointProbe(S surface, const Relation& relation)
      : surface_(std::move(surface)), core_(surface_, relation) {}
  void take(const Chord& chord) override {
    chord_ = chord;
    core_.take(chord_, {});
  }
  Node resume(const Node& previous) override { return turned(previous, chord_); }
  Node at(double s) override { return core_.at(s); }
  Stretch over(const Node& a, const Node& b, double) override { return {core_.over(a, b).range}; }
  void settle(Node&, double) override {}

 private:
  S surface_;
  CoreGap<S> core_;
  Chord chord_;
};

/// Kinds for which the contact of any cutter has a closed form.
template <surface::Surface S>
class ClosedProbe final : public Probe {
 public:
  ClosedProbe(const S& surface, const Relation& relation)
      : surface_(surface), cutter_(*relation.cutter), relation_(relation) {
    for (const Piece& p : piecesOf(cutter_)) {
      reach_ = std::max(reach_, p.reach() + p.ball);
    }
    convexBody_ = isConvex(cutter_);
  }
  void take(const Chord& chord) override {
    chord_ = chord;
    convex_ = chord.turn() == 0.0 && isConvexGap();
  }
  Node resume(const Node& previous) override { return turned(previous, chord_); }
  Node at(double s) override {
    Node n = placeOn(chord_, s);
    tool::Search<S> search;
    tool::Contact c = tool::contact(surface_, relation_.side, cutter_, n.toolEnd, n.axis, search);
    if constexpr (std::is_same_v<S, surface::Plane>) {
      // The contact of a plane stands for a whole circle or disc of the cutter: one of its points.
      const double nz = c.normal.dot(n.axis);
      const tool::ProfilePoint q = tool::reachPoint(cutter_, nz);
      c.point = n.toolEnd + q.z * n.axis + q.rho * squareTo(n.axis, -c.normal);
    }
    note(c, relation_.thick, chord_, n);
    n.low = n.high;
    return n;
  }
  Stretch over(const Node& a, const Node& b, double) override {
    const double h = b.s - a.s;
    const double turn = chord_.turn();
    const double rate = chord_.length() + turn * reach_;
    const double least = 0.5 * (a.low + b.low - rate * h) + relation_.thick;
    Curving c = bySpeed(bends(least), rate, turn * turn * reach_);
    if (!convex_) {
      c.least = -unbounded;
    }
    return {between(a, b, h, c, rate)};
  }
  void settle(Node&, double) override {}

 private:
  /// Of the distance, for those points of the cutter that may be the contact.
  [[nodiscard]] Curving bends(double least) const {
    if constexpr (std::is_same_v<S, surface::Sphere>) {
      const double radius = surface_.radius + least;
      if (relation_.side < 0.0) {
        return {-unbounded, 0.0};
      }
      return {0.0, radius > 0.0 ? 1.0 / radius : unbounded};
    } else {
      return {0.0, 0.0};
    }
  }
  /// Without a turn a plane's gap is linear; that of a sphere is convex outside for convex bodies
  /// with all of their faces: where the top face, which does not cut, is not the nearest one.
  [[nodiscard]] bool isConvexGap() const {
    if constexpr (std::is_same_v<S, surface::Sphere>) {
      return convexBody_ && relation_.side > 0.0 && !passesOverTop();
    } else {
      return true;
    }
  }
  /// Whether the center of the sphere comes to be right above the top face.
  [[nodiscard]] bool passesOverTop() const requires std::is_same_v<S, surface::Sphere> {
    const Vec3 axis = chord_.axis(0.0);
    const Vec3 first = surface_.center - chord_.toolEnd(0.0);
    const Vec3 last = surface_.center - chord_.toolEnd(1.0);
    if (std::max(first.dot(axis), last.dot(axis)) <= cutter_.h) {
      return false;
    }
    const Vec3 beside = first - first.dot(axis) * axis;
    const Vec3 way = chord_.step() - chord_.step().dot(axis) * axis;
    const double squared = way.squaredNorm();
    const double nearest = squared > 0.0 ? std::clamp(beside.dot(way) / squared, 0.0, 1.0) : 0.0;
    return (beside - nearest * way).norm() < cutter_.sideEnd.rho;
  }

  S surface_;
  tool::Profile cutter_;
  Relation relation_;
  Chord chord_;
  bool convexBody_ = false;
  bool convex_ = false;  ///< the gap, along the chord taken
  double reach_ = 0.0;
};
}  // namespace

std::unique_ptr<Probe> makeProbe(const surface::AnySurface& any, const Relation& relation) {
  return std::visit(
      [&]<class S>(const S& s) -> std::unique_ptr<Probe> {
        Relation point = relation;
        point.thick = relation.cutter == nullptr ? 0.0 : relation.thick;
        if constexpr (std::is_same_v<S, surface::Mesh>) {
          if (relation.cutter == nullptr || relation.cutter->isPoint()) {
            return std::make_unique<MeshPointProbe>(s, point.side, point.thick);
          }
        }
        if (relation.cutter == nullptr) {
          return std::make_unique<PointProbe<S>>(s, point);
        }
        if constexpr (std::is_same_v<S, surface::Mesh>) {
          if (relation.cutter->ring) {
            return makeMeshRingProbe(s, relation);
          }
          if (isConvex(*relation.cutter)) {
            return std::make_unique<MeshProbe>(s, relation);
          }
        }
        if constexpr (std::is_same_v<S, surface::Plane> || std::is_same_v<S, surface::Sphere>) {
          return std::make_unique<ClosedProbe<S>>(s, relation);
        } else {
          return std::make_unique<CutterProbe<S>>(s, relation);
        }
      },
      any);
}

}  // namespace arelem::certify
