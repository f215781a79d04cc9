#pragma once
#include "runtime/certify/probe.h"
#include "runtime/tool/contact.h"

namespace arelem::certify {

/// A convex cutter against a mesh. While the axis does not turn, the gap to each triangle is a
/// convex function of the tool end: tangents at both ends of a part bound it from below, chords
/// from above. A turn bends both by its square (tool::NearTriangles; `chordOf`). Of the triangles
/// all are looked at that the cutter may reach there.
class MeshProbe final : public Probe {
 public:
  MeshProbe(const surface::Mesh& mesh, const Relation& relation)
      : MeshProbe(mesh, relation, std::make_unique<Own>(*relation.cutter)) {}
  /// With a search of one's own, for the same cutter, which must stay where it is.
  MeshProbe(const surface::Mesh& mesh,
            const Relation& relation,
            tool::Search<surface::Mesh>& search)
      : mesh_(mesh),
        cutter_(*relation.cutter),
        body_(cutter_),
        thick_(relation.thick),
        search_(search) {}

  void take(const Chord& chord) override {
    chord_ = chord;
    floor_ = -unbounded;
  }
  Node resume(const Node& previous) override { return turned(previous, chord_); }

  Node at(double s) override {
    Node n = placeOn(chord_, s);
    const tool::Contact c = tool::contact(mesh_, 1.0, cutter_, n.toolEnd, n.axis, search_);
    n.triangle = static_cast<std::size_t>(search_.hint.triangle);
    note(c, thick_, chord_, n);
    return n;
  }

  Stretch over(const Node& a, const Node& b, double aim) override {
    Stretch result;
    if (floor_ >= aim) {
      result.low = floor_;
    } else {
      result.low = lowest(a, b, aim);
      if (a.s == 0.0 && b.s == 1.0) {
        floor_ = result.low;
      }
    }
    result.high = highest(a, b);
    return result;
  }

  void settle(Node& node, double aim) override {
    node.low = std::max(node.low, lowest(node, node, aim));
  }

 private:
  struct Own {
    explicit Own(const tool::Profile& profile) : cutter(profile) {}
    tool::Profile cutter;
    tool::Search<surface::Mesh> search;
  };
  MeshProbe(const surface::Mesh& mesh, Relation relation, std::unique_ptr<Own> own)
      : MeshProbe(mesh, Relation{&own->cutter, relation.side, relation.thick}, own->search) {
    own_ = std::move(own);
  }

  [[nodiscard]] double turnOver(const Node& a, const Node& b) const {
    return chord_.turn() * (b.s - a.s);
  }

  [[nodiscard]] double lowest(const Node& a, const Node& b, double aim) {
    const tool::Passage way{a.toolEnd, b.toolEnd, a.axis, b.axis, turnOver(a, b)};
    const double least = search_.near.lowest(mesh_.shape(), cutter_, way, aim + thick_);
    // What reaches the aim reaches it after rounding too.
    return least >= aim + thick_ ? std::max(aim, least - thick_) : least - thick_;
  }

  /// Where a triangle is about nearest to the cutter, with the gap of that place.
  struct Contact {
    Vec3 place;
    double gap;
  };
  [[nodiscard]] Contact contactAt(const Node& n, std::size_t triangle) const {
    if (chord_.turn() == 0.0 && triangle == n.triangle) {
      return {n.point, n.high};
    }
    const geometry::TriangleMesh& mesh = mesh_.shape().mesh;
    const tool::Facet facet{mesh.corner(triangle, 0), mesh.corner(triangle, 1),
                            mesh.corner(triangle, 2), mesh_.shape().normals[triangle]};
    const tool::PlacedBody body(body_, n.toolEnd, n.axis);
    const tool::TriangleGap gap = tool::gapOf(body, facet);
    if (chord_.turn() == 0.0) {
      return {gap.onCutter, gap.gap - thick_};
    }
    Contact best{Vec3::Zero(), unbounded};
    for (const Vec3& guess : {gap.onCutter, Vec3(gap.onCutter - gap.gap * gap.normal)}) {
      const Vec3 place = geometry::nearestOn(facet.a, facet.b, facet.c, guess).point;
      const double distance = body.distance(place) - thick_;
      best = distance < best.gap ? Contact{place, distance} : best;
    }
    return best;
  }

  /// The gaps of one triangle at both ends, raised so that their chord lies above its gaps between:
  /// a place that goes evenly from one contact to the other has gaps below the chord while the axis
  /// does not turn, as seen from the cutter it goes straight then. If it turns by w, that place at
  /// y from the tool end leaves the straight line by at most w^2 |y| / 8 + w |y1 - y0| / 4.
  struct Raised {
    double from, to;
  };
  [[nodiscard]] Raised chordOf(const Node& a, const Node& b, std::size_t triangle) const {
    const Contact first = contactAt(a, triangle);
    const Contact last = contactAt(b, triangle);
    const double turn = turnOver(a, b);
    if (turn == 0.0) {
      return {first.gap, last.gap};
    }
    const Vec3 y0 = first.place - a.toolEnd;
    const Vec3 y1 = last.place - b.toolEnd;
    const double aside =
        0.125 * turn * turn * std::max(y0.norm(), y1.norm()) + 0.25 * turn * (y1 - y0).norm();
    return {first.gap + aside, last.gap + aside};
  }

  /// Below the chords of the gaps to the two triangles in contact.
  [[nodiscard]] double highest(const Node& a, const Node& b) const {
    if (a.triangle == b.triangle && chord_.turn() == 0.0) {
      return std::max(a.high, b.high);
    }
    const Raised own = chordOf(a, b, a.triangle);
    if (a.triangle == b.triangle) {
      return std::max(own.from, own.to);
    }
    const Raised other = chordOf(a, b, b.triangle);
    // The highest place of the lower line.
    double most = std::max(std::min(own.from, other.from), std::min(own.to, other.to));
    const double d0 = own.from - other.from;
    const double d1 = own.to - other.to;
    if ((d0 > 0.0) != (d1 > 0.0)) {
      most = std::max(most, own.from + d0 / (d0 - d1) * (own.to - own.from));
    }
    return most;
  }

  surface::Mesh mesh_;
  std::unique_ptr<Own> own_;
  const tool::Profile& cutter_;
  tool::Body body_;
  double thick_;
  Chord chord_;
  double floor_ = -unbounded;  ///< proven for the whole cut vector
  tool::Search<surface::Mesh>& search_;
};

}  // namespace arelem::certify
