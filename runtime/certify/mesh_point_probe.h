#pragma once
#include <algorithm>
#include <cmath>

#include "runtime/certify/probe.h"

namespace arelem::certify {

/// A tool end, or a tool without size, against a mesh. The distance to each triangle is a convex
/// function of the place, so the chords of the distances to two of them bound the depth and the
/// height alike. Where all triangles that may be the nearest one have a part of the way on the same
/// side of their planes, it is on that side: the normal at an edge or a corner is a sum of theirs
/// with positive weights. And there no nearest triangle is nearer than its plane.
class MeshPointProbe final : public Probe {
 public:
  MeshPointProbe(surface::Mesh mesh, double side, double thick)
      : mesh_(std::move(mesh)), side_(side), thick_(thick) {}

  void take(const Chord& chord) override { chord_ = chord; }
  Node resume(const Node& previous) override { return turned(previous, chord_); }

  Node at(double s) override {
    Node n = placeOn(chord_, s);
    n.point = n.toolEnd;
    n.foot = mesh_.foot(n.point, hint_);
    n.triangle = static_cast<std::size_t>(hint_.triangle);
    n.normal = side_ * n.foot.normal;
    n.high = n.low = side_ * n.foot.distance - thick_;
    n.slope = n.normal.dot(chord_.step());
    return n;
  }

  Stretch over(const Node& a, const Node& b, double) override {
    const double far = farthest(a, b);
    const Near near = around(a, b, far);
    Stretch result;
    // Beside an open edge, level with it, a place counts as above it.
    const bool isAbove = side_ > 0.0 ? near.lowest >= 0.0 : near.lowest > 0.0;
    const bool isBelow = side_ > 0.0 ? near.highest < 0.0 : near.highest <= 0.0;
    result.low = (isAbove ? std::min(far, std::max(near.lowest, near.least)) : -far) - thick_;
    result.high = (isBelow ? -std::min(far, std::max(-near.highest, near.least)) : far) - thick_;
    return result;
  }
  void settle(Node&, double) override {}

 private:
  /// A distance from one triangle.
  struct Away {
    double distance = 0.0;
    Vec3 gradient = Vec3::Zero();
  };
  [[nodiscard]] Away awayFrom(std::size_t triangle, const Vec3& p) const {
    const geometry::TriangleMesh& mesh = mesh_.shape().mesh;
    const Vec3 w = p - geometry::nearestOn(mesh.corner(triangle, 0), mesh.corner(triangle, 1),
                                           mesh.corner(triangle, 2), p)
                           .point;
    const double distance = w.norm();
    return {distance, distance > 0.0 ? Vec3(w / distance) : Vec3(Vec3::Zero())};
  }

  /// No place of the way is farther from the mesh than this: below the chords of the distances to
  /// the two nearest triangles.
  [[nodiscard]] double farthest(const Node& a, const Node& b) const {
    const double ownAtA = std::abs(a.foot.distance);
    const double ownAtB = std::abs(b.foot.distance);
    if (a.triangle == b.triangle) {
      return std::max(ownAtA, ownAtB);
    }
    const double otherAtB = awayFrom(a.triangle, b.point).distance;
    const double otherAtA = awayFrom(b.triangle, a.point).distance;
    // They cross: from ownAtA to otherAtB, and from otherAtA, which is more, down to ownAtB.
    const double sum = otherAtA - ownAtA + otherAtB - ownAtB;
    const double u = sum > 0.0 ? std::clamp((otherAtA - ownAtA) / sum, 0.0, 1.0) : 0.0;
    return std::max({ownAtA, ownAtB, ownAtA + u * (otherAtB - ownAtA)});
  }

  /// Bounds by the triangles that are within some distance of a way.
  struct Near {
    double lowest = unbounded, highest = -unbounded;  ///< heights over their planes, on the side
    double least = unbounded;                         ///< distance from any of them
  };
  class Collect;
  [[nodiscard]] Near around(const Node& a, const Node& b, double reach) const;

  surface::Mesh mesh_;
  double side_, thick_;
  Chord chord_;
  surface::Mesh::Hint hint_;
};

class MeshPointProbe::Collect {
 public:
  Collect(const MeshPointProbe& probe, const Vec3& a, const Vec3& b, double reach)
      : probe_(probe),
        a_(a),
        b_(b),
        middle_(0.5 * (a + b)),
        half_(0.5 * (b - a)),
        length_(half_.norm()),
        reach_(reach + tolerance::sameSide) {}

  bool enters(const Vec3& center, const Vec3& half) {
    const Vec3 w = center - middle_;
    if (((w.cwiseAbs() - half - half_.cwiseAbs()).array() > reach_).any()) {
      return false;
    }
    const double along = length_ > 0.0 ? w.dot(half_) / length_ : 0.0;
    const double most = half.norm() + reach_;
    return w.squaredNorm() - along * along <= most * most;
  }

  void visit(std::size_t triangle) {
    const double distance = lowest(triangle);
    if (distance > reach_) {
      return;
    }
    const surface::MeshShape& shape = probe_.mesh_.shape();
    const Vec3 normal = probe_.side_ * shape.normals[triangle];
    const Vec3& corner = shape.mesh.corner(triangle, 0);
    const double atA = normal.dot(a_ - corner);
    const double atB = normal.dot(b_ - corner);
    near.lowest = std::min({near.lowest, atA, atB});
    near.highest = std::max({near.highest, atA, atB});
    near.least = std::min(near.least, distance);
  }

 private:
  /// No place of the way is nearer to the triangle than this: above the tangents at both ends.
  [[nodiscard]] double lowest(std::size_t triangle) const {
    const Away a = probe_.awayFrom(triangle, a_);
    const Away b = probe_.awayFrom(triangle, b_);
    const double rise = 2.0 * a.gradient.dot(half_);
    const double fall = -2.0 * b.gradient.dot(half_);
    const double atA = std::max(a.distance, b.distance + fall);
    const double atB = std::max(b.distance, a.distance + rise);
    double least = std::min(atA, atB);
    if (rise < 0.0 && fall < 0.0) {
      const double u = (a.distance - b.distance - fall) / (-rise - fall);
      least = std::min(least, a.distance + std::clamp(u, 0.0, 1.0) * rise);
    }
    return std::max(0.0, least);
  }

  const MeshPointProbe& probe_;
  const Vec3 &a_, &b_;
  Vec3 middle_, half_;
  double length_, reach_;

 public:
  Near near;
};

inline MeshPointProbe::Near MeshPointProbe::around(const Node& a,
                                                   const Node& b,
                                                   double reach) const {
  Collect search(*this, a.point, b.point, reach);
  mesh_.shape().tree.search(search);
  return search.near;
}

}  // namespace arelem::certify
