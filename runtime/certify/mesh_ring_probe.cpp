#include "runtime/certify/mesh_ring_probe.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "runtime/tool/contact.h"

namespace arelem::certify {

namespace {
/// The ring is searched in so many arcs, each of which is halved.
constexpr int arcs = 8;
/// Places measured for one part of a chord, and in vain for all of a motion.
constexpr int budget = 20000;
constexpr int patience = 200000;
/// A chord that takes more nodes than this is looked at in vain; a motion may have so many such
/// nodes, each of which searches the whole ring.
constexpr int chordNodes = 256;
constexpr int vainNodes = 768;

/// The triangles that may be the nearest one of some place of a hull.
class AroundHull {
 public:
  AroundHull(const surface::MeshShape& shape, double side, std::span<const Vec3> corners)
      : shape_(shape), side_(side), corners_(corners), low_(corners[0]), high_(corners[0]) {
    for (const Vec3& corner : corners) {
      center_ += corner / static_cast<double>(corners.size());
      low_ = low_.cwiseMin(corner);
      high_ = high_.cwiseMax(corner);
    }
  }

  [[nodiscard]] const Vec3& center() const { return center_; }
  /// No place of the hull is farther from the mesh than this.
  [[nodiscard]] double farthest(std::size_t triangle) const {
    double far = 0.0;
    for (const Vec3& corner : corners_) {
      far = std::max(far, away(triangle, corner).norm());
    }
    return far;
  }
  void collect(double reach) {
    reach_ = reach;
    shape_.tree.search(*this);
  }

  bool enters(const Vec3& center, const Vec3& half) const {
    return ((center - half - high_).array() <= reach_).all() &&
           ((low_ - center - half).array() <= reach_).all();
  }
  void visit(std::size_t triangle) {
    // Above the tangent in the middle of the hull.
    const Vec3 w = away(triangle, center_);
    const double distance = w.norm();
    const Vec3 gradient = distance > 0.0 ? Vec3(w / distance) : Vec3(Vec3::Zero());
    const Vec3& normal = shape_.normals[triangle];
    const Vec3& foot = shape_.mesh.corner(triangle, 0);
    double nearest = distance;
    double low = unbounded;
    double high = -unbounded;
    for (const Vec3& corner : corners_) {
      nearest = std::min(nearest, distance + gradient.dot(corner - center_));
      const double height = side_ * normal.dot(corner - foot);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    if (nearest <= reach_) {
      lowest = std::min(lowest, low);
      highest = std::max(highest, high);
      least = std::min(least, nearest);
    }
  }

 private:
  [[nodiscard]] Vec3 away(std::size_t triangle, const Vec3& p) const {
    const geometry::TriangleMesh& mesh = shape_.mesh;
    return p - geometry::nearestOn(mesh.corner(triangle, 0), mesh.corner(triangle, 1),
                                   mesh.corner(triangle, 2), p)
                   .point;
  }

  const surface::MeshShape& shape_;
  double side_;
  std::span<const Vec3> corners_;
  Vec3 center_ = Vec3::Zero(), low_, high_;
  double reach_ = 0.0;

 public:
  double lowest = unbounded, highest = -unbounded;  ///< heights over their planes, on the side
  double least = unbounded;                         ///< distance from any of them
};

class MeshRingProbe final : public Probe {
 public:
  MeshRingProbe(const surface::Mesh& mesh, const Relation& relation)
      : mesh_(mesh),
        side_(relation.side),
        thick_(relation.thick),
        ring_(*relation.cutter),
        arm_(std::hypot(ring_.e, ring_.f)) {}

  void take(const Chord& chord) override {
    chord_ = chord;
    nodes_ = 0;
  }
  Node resume(const Node& previous) override { return turned(previous, chord_); }

  Node at(double s) override {
    Node n = placeOn(chord_, s);
    if (++nodes_ > chordNodes && ++vainNodes_ > vainNodes) {
      n.high = unbounded;
      return n;
    }
    const tool::Contact c = tool::contact(mesh_, side_, ring_, n.toolEnd, n.axis, search_);
    note(c, thick_, chord_, n);
    return n;
  }

  Stretch over(const Node& a, const Node& b, double aim) override {
    Stretch result;
    result.high = std::min(highest(a, b, b.s - a.s), highest(b, a, a.s - b.s));
    result.low = searched(a.s, b.s, aim, result) ? aim : -unbounded;
    return result;
  }

  void settle(Node& node, double aim) override {
    Stretch result;
    if (searched(node.s, node.s, aim, result)) {
      node.low = std::max(node.low, aim);
    }
  }

 private:
  static constexpr double pi = std::numbers::pi;

  /// Part of the ring at part of the time: centers and half widths.
  struct Part {
    double s, halfS, angle, halfAngle;
  };

  /// The base turns with the tool: its first direction lies in the plane of the turn.
  [[nodiscard]] Vec3 place(double s, double angle) const {
    const Vec3 axis = chord_.axis(s);
    const Vec3 out = std::cos(angle) * chord_.pole().cross(axis) + std::sin(angle) * chord_.pole();
    return chord_.toolEnd(s) + ring_.f * axis + ring_.e * out;
  }

  /// The gaps of all places within `bulge` of the hull of some.
  [[nodiscard]] Range overHull(std::span<const Vec3> corners, double bulge) {
    AroundHull hull(mesh_.shape(), side_, corners);
    (void)mesh_.foot(hull.center(), hint_);
    const double far = hull.farthest(static_cast<std::size_t>(hint_.triangle)) + bulge;
    hull.collect(far + bulge + tolerance::sameSide);
    const double above = std::max(hull.lowest, hull.least) - bulge;
    const double below = std::max(-hull.highest, hull.least) - bulge;
    // Beside an open edge, level with it, a place counts as above it.
    const bool isAbove = side_ > 0.0 ? hull.lowest >= bulge : hull.lowest > bulge;
    const bool isBelow = side_ > 0.0 ? hull.highest < -bulge : hull.highest <= -bulge;
    return {(isAbove ? std::min(far, above) : -far) - thick_,
            (isBelow ? -std::min(far, below) : far) - thick_};
  }

  /// The contact of one node, kept on the ring, to the other.
  [[nodiscard]] double highest(const Node& from, const Node& to, double part) {
    const double turn = chord_.turn() * std::abs(part);
    Vec3 offset = from.point - from.toolEnd;
    if (turn > 0.0) {
      offset = Eigen::AngleAxisd(chord_.turn() * part, chord_.pole()) * offset;
    }
    const std::array way{from.point, Vec3(to.toolEnd + offset)};
    return overHull(way, 0.125 * turn * turn * arm_).high;
  }

  /// Whether the gap is at least `aim` for s in [from, to]; notes a lower gap that was measured.
  bool searched(double from, double to, double aim, Stretch& result) {
    if (aim == -unbounded || inVain_ >= patience) {
      return false;
    }
    parts_.clear();
    for (int i = 0; i < arcs; ++i) {
      parts_.push_back({0.5 * (from + to), 0.5 * (to - from), pi * (2 * i + 1) / arcs, pi / arcs});
    }
    int measured = 0;
    while (!parts_.empty()) {
      const Part part = parts_.back();
      parts_.pop_back();
      const double gap = side_ * mesh_.foot(place(part.s, part.angle), hint_).distance - thick_;
      if (gap < result.sample) {
        result.sample = gap;
        result.sampleAt = part.s;
      }
      if (gap < aim) {
        return false;
      }
      if (++measured > budget) {
        inVain_ += measured;
        return false;
      }
      if (gap - size(part) < aim && lowestOf(part) < aim) {
        halve(part);
      }
    }
    return true;
  }

  [[nodiscard]] double size(const Part& part) const {
    return alongTime(part) + ring_.e * part.halfAngle;
  }
  [[nodiscard]] double alongTime(const Part& part) const {
    return (chord_.length() + chord_.turn() * arm_) * part.halfS;
  }

  [[nodiscard]] double lowestOf(const Part& part) {
    std::array<Vec3, 4> corners;
    const std::size_t count = part.halfS > 0.0 ? 4 : 2;
    for (std::size_t i = 0; i < count; ++i) {
      corners[i] = place(part.s + (i < 2 ? -part.halfS : part.halfS),
                         part.angle + (i % 2 == 0 ? -part.halfAngle : part.halfAngle));
    }
    // Straight lines between corners leave both arcs by at most the eighth part of their bend.
    const double turn = chord_.turn() * part.halfS;
    const double bulge = 0.5 * (turn * turn * arm_ + part.halfAngle * part.halfAngle * ring_.e);
    return overHull(std::span(corners).first(count), bulge).low;
  }

  void halve(Part part) {
    const bool inTime = alongTime(part) > ring_.e * part.halfAngle;
    double& center = inTime ? part.s : part.angle;
    double& half = inTime ? part.halfS : part.halfAngle;
    half *= 0.5;
    center -= half;
    parts_.push_back(part);
    center += 2.0 * half;
    parts_.push_back(part);
  }

  surface::Mesh mesh_;
  double side_, thick_;
  tool::Profile ring_;
  double arm_;  ///< from the tool end to the ring
  Chord chord_;
  tool::Search<surface::Mesh> search_;
  surface::Mesh::Hint hint_;
  std::vector<Part> parts_;
  int inVain_ = 0;
  int nodes_ = 0, vainNodes_ = 0;
};
}  // namespace

std::unique_ptr<Probe> makeMeshRingProbe(const surface::Mesh& mesh, const Relation& relation) {
  return std::make_unique<MeshRingProbe>(mesh, relation);
}

}  // namespace arelem::certify
