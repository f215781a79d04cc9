#pragma once
#include "runtime/certify/probe.h"
#include "runtime/tool/contact.h"

namespace arelem::certify {

/// A convex cutter against a mesh. While the axis does not turn, the gap to each triangle is a
/// convex function of the tool end: tangents at both ends of a part bound it from below, chords
/// from above. Of the triangles all are looked at that the cutter may reach there.
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
        reach_(std::hypot(cutter_.maxRadius(), std::max(cutter_.h, cutter_.f + cutter_.r))),
        search_(search) {}

  void take(const Chord& chord) override {
    chord_ = chord;
    floor_ = -unbounded;
  }
  Node resume(const Node& previous) override { return turned(previous, chord_); }

  Node at(double s) override {
    Node n;
    n.s = s;
    n.toolEnd = chord_.toolEnd(s);
    n.axis = chord_.axis(s);
    const tool::Contact c = tool::contact(mesh_, 1.0, cutter_, n.toolEnd, n.axis, search_);
    n.triangle = static_cast<std::size_t>(search_.hint.triangle);
    n.point = c.point;
    n.normal = c.normal;
    n.high = c.gap - thick_;
    n.low = -unbounded;
    n.slope = n.normal.dot(chord_.step());
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

  /// What a turn of the axis may add or take between two nodes.
  [[nodiscard]] double turning(const Node& a, const Node& b) const {
    return chord_.turn() * (b.s - a.s) * reach_;
  }

  [[nodiscard]] double lowest(const Node& a, const Node& b, double aim) {
    const double more = thick_ + turning(a, b);
    const double least =
        search_.near.lowest(mesh_.shape(), cutter_, a.toolEnd, b.toolEnd, a.axis, aim + more);
    // What reaches the aim reaches it after rounding too.
    return least >= aim + more ? std::max(aim, least - more) : least - more;
  }

  [[nodiscard]] double gapAt(const Node& n, std::size_t triangle) const {
    const geometry::TriangleMesh& mesh = mesh_.shape().mesh;
    const tool::Facet facet{mesh.corner(triangle, 0), mesh.corner(triangle, 1),
                            mesh.corner(triangle, 2), mesh_.shape().normals[triangle]};
    return tool::gapOf(tool::PlacedBody(body_, n.toolEnd, n.axis), facet).gap - thick_;
  }

  /// Below the chords of the gaps to the two triangles in contact.
  [[nodiscard]] double highest(const Node& a, const Node& b) const {
    if (a.triangle == b.triangle) {
      return std::max(a.high, b.high) + turning(a, b);
    }
    const double otherAtB = gapAt(b, a.triangle);
    const double otherAtA = gapAt(a, b.triangle);
    // a.high .. otherAtB and otherAtA .. b.high: the highest place of the lower line.
    double most = std::max(std::min(a.high, otherAtA), std::min(b.high, otherAtB));
    const double d0 = a.high - otherAtA;
    const double d1 = otherAtB - b.high;
    if ((d0 > 0.0) != (d1 > 0.0)) {
      const double u = d0 / (d0 - d1);
      most = std::max(most, a.high + u * (otherAtB - a.high));
    }
    return most + turning(a, b);
  }

  surface::Mesh mesh_;
  std::unique_ptr<Own> own_;
  const tool::Profile& cutter_;
  tool::Body body_;
  double thick_, reach_;
  Chord chord_;
  double floor_ = -unbounded;  ///< proven for the whole cut vector
  tool::Search<surface::Mesh>& search_;
};

}  // namespace arelem::certify
