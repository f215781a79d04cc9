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
  /// What a turn of the axis may add or take between two nodes.
  [[nodiscard]] double turning(const Node& a, const Node& b) const {
    return chord_.turn() * (b.s - a.s) * reach_;
  }

  /// Visits the triangles that the cutter may come nearer to than `least` from one node to another.
  class Lowest final : public geometry::TriangleSearch {
   public:
    Lowest(MeshProbe& probe, const Node& a, const Node& b, double aim)
        : mesh_(probe.mesh_.shape().mesh),
          first_(probe.cutter_, a.toolEnd, a.axis),
          last_(probe.cutter_, b.toolEnd, b.axis),
          between_(
              probe.cutter_, 0.5 * (a.toolEnd + b.toolEnd), a.axis, 0.5 * (b.toolEnd - a.toolEnd)),
          chord_(probe.chord_),
          h_(b.s - a.s),
          wide_(probe.turning(a, b)),
          thick_(probe.thick_),
          least(aim) {}

    bool enters(const Vec3& center, const Vec3& half) override {
      return between_.mayReach(center, half, least + thick_ + wide_);
    }
    void visit(std::size_t i) override {
      if (!between_.mayReach(mesh_, i, least + thick_ + wide_)) {
        return;
      }
      const tool::TriangleGap p = first_.gapTo(mesh_, i);
      const tool::TriangleGap q = last_.gapTo(mesh_, i);
      const double steepest = chord_.length();
      const double leaves = p.tangent ? p.normal.dot(chord_.step()) : -steepest;
      const double arrives = q.tangent ? q.normal.dot(chord_.step()) : steepest;
      const Known left{p.gap - thick_, p.gap - thick_, leaves};
      const Known right{q.gap - thick_, q.gap - thick_, arrives};
      const double low = between(left, right, h_, {0.0, unbounded}, chord_.length()).low;
      least = std::min(least, low - wide_);
    }

   private:
    const geometry::TriangleMesh& mesh_;
    tool::TriangleCutter first_, last_, between_;
    const Chord& chord_;
    double h_, wide_, thick_;

   public:
    double least;
  };

  [[nodiscard]] double lowest(const Node& a, const Node& b, double aim) {
    Lowest search(*this, a, b, aim);
    mesh_.shape().tree->search(search);
    return search.least;
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
  double floor_ = -unbounded;  ///< proven for the whole cut vector
  tool::Search<surface::Mesh> search_;
};

}  // namespace arelem::certify
