#pragma once
#include "runtime/certify/probe.h"
#include "runtime/tool/contact.h"
#include "runtime/tool/mesh_contact.h"

namespace arelem::certify {

/// A convex cutter against a mesh. While the axis does not turn, the gap to each triangle is a
/// convex function of the tool end: tangents at both ends of a part bound it from below, chords
/// from above. Of the triangles all are looked at that the cutter may reach there.
class MeshProbe final : public Probe {
 public:
  MeshProbe(const surface::Mesh& mesh, const Relation& relation)
      : mesh_(mesh), cutter_(*relation.cutter), thick_(relation.thick) {
    reach_ = std::hypot(cutter_.maxRadius(), std::max(cutter_.h, cutter_.f + cutter_.r));
  }

  void take(const Chord& chord) override { chord_ = chord; }
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
    result.low = lowest(a, b, aim);
    result.high = highest(a, b);
    return result;
  }

  void settle(Node& node, double aim) override {
    node.low = std::max(node.low, lowest(node, node, aim));
  }

 private:
  /// What a turn of the axis may add or take between two nodes.
  [[nodiscard]] double turning(const Node& a, const Node& b) const {
    return chord_.turn() * (b.s - a.s) * reach_;
  }

  [[nodiscard]] double lowest(const Node& a, const Node& b, double aim) {
    const tool::TriangleCutter first(cutter_, a.toolEnd, a.axis);
    const tool::TriangleCutter last(cutter_, b.toolEnd, b.axis);
    const double h = b.s - a.s;
    const double wide = turning(a, b);
    const double beyond = std::max(0.0, aim + thick_) + wide;
    const auto [lowA, highA] = first.box(beyond);
    const auto [lowB, highB] = last.box(beyond);
    near_.clear();
    mesh_.shape().tree->within(lowA.cwiseMin(lowB), highA.cwiseMax(highB), near_);
    const geometry::TriangleMesh& mesh = mesh_.shape().mesh;
    const double way = chord_.length() * h;
    double least = aim;
    for (const std::size_t i : near_) {
      if (first.lowerBound(mesh, i) - thick_ - way - wide >= aim) {
        continue;
      }
      const tool::TriangleGap p = first.gapTo(mesh, i);
      if (p.gap - thick_ - way - wide >= aim) {
        continue;
      }
      const tool::TriangleGap q = last.gapTo(mesh, i);
      const Known left{p.gap - thick_, p.gap - thick_, p.normal.dot(chord_.step())};
      const Known right{q.gap - thick_, q.gap - thick_, q.normal.dot(chord_.step())};
      least =
          std::min(least, between(left, right, h, {0.0, unbounded}, chord_.length()).low - wide);
    }
    return least;
  }

  /// Below the chords of the gaps to the two triangles in contact.
  [[nodiscard]] double highest(const Node& a, const Node& b) const {
    const geometry::TriangleMesh& mesh = mesh_.shape().mesh;
    const double otherAtB =
        tool::TriangleCutter(cutter_, b.toolEnd, b.axis).gapTo(mesh, a.triangle).gap - thick_;
    const double otherAtA =
        tool::TriangleCutter(cutter_, a.toolEnd, a.axis).gapTo(mesh, b.triangle).gap - thick_;
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
  tool::Profile cutter_;
  double thick_, reach_;
  Chord chord_;
  tool::Search<surface::Mesh> search_;
  std::vector<std::size_t> near_;
};

}  // namespace arelem::certify
