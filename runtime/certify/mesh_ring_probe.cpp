#include "runtime/certify/mesh_ring_probe.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "runtime/certify/patience.h"
#include "runtime/tool/contact.h"

namespace arelem::certify {

namespace {
/// The ring is searched in so many arcs, each of which is halved.
constexpr int arcs = 8;
/// Places measured for one part of a chord, and in vain for all of a motion.
constexpr int budget = 20000;
constexpr int patience = 1000000;

/// So many triangles around a hull are looked at together; rounding of heights over their planes,
/// as a share of the coordinates' size.
constexpr std::size_t mostTogether = 8;
constexpr double heightRounding = 1e-13;

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

  /// Every place of the hull is above the mesh, and no nearer than this; -unbounded where that is
  /// not known. Behind an edge that stands out places above the mesh are below the plane of one of
  /// its triangles. But where none of the triangles reaches over the plane of another, a place
  /// above them on average, by any weights, is above: from its foot on one it would go down over
  /// all.
  [[nodiscard]] double lowestTogether() const {
    return standsOut() ? bestOfPairs([this](std::size_t triangle, const Vec3& corner) {
                           return heightOver(triangle, corner);
                         }) - 2.0 * rounding()
                       : -unbounded;
  }
  /// No place of the hull is farther from the mesh than this: behind an edge the one triangle is
  /// nearer, before it the other, and the nearer one is no farther than both on average.
  [[nodiscard]] double farthestTogether() const {
    return -bestOfPairs([this](std::size_t triangle, const Vec3& corner) {
      return -away(triangle, corner).norm();
    });
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
      if (count_ < mostTogether) {
        list_[count_] = triangle;
      }
      ++count_;
      lowest = std::min(lowest, low);
      highest = std::max(highest, high);
      least = std::min(least, nearest);
    }
  }

 private:
  [[nodiscard]] double rounding() const {
    return heightRounding * (1.0 + low_.cwiseAbs().cwiseMax(high_.cwiseAbs()).maxCoeff() + reach_);
  }
  [[nodiscard]] double heightOver(std::size_t triangle, const Vec3& p) const {
    return side_ * shape_.normals[triangle].dot(p - shape_.mesh.corner(triangle, 0));
  }
  /// No triangle is over the plane of another, they face the same way, and none is at the border.
  [[nodiscard]] bool standsOut() const {
    if (count_ > mostTogether) {
      return false;
    }
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        if (shape_.atBorder[shape_.mesh.triangles[list_[i]][corner]]) {
          return false;
        }
        const Vec3& place = shape_.mesh.corner(list_[i], corner);
        for (std::size_t k = 0; k < count_; ++k) {
          if (heightOver(list_[k], place) > rounding()) {
            return false;
          }
        }
      }
      for (std::size_t k = 0; k < i; ++k) {
        if (!(shape_.normals[list_[i]].dot(shape_.normals[list_[k]]) > 0.0)) {
          return false;
        }
      }
    }
    return true;
  }
  using OfCorners = std::array<double, 4>;
  /// Of what is known of each triangle at the corners, the least on average of two triangles, by
  /// the weights with which it is greatest; -unbounded where there are many.
  template <class Value>
  [[nodiscard]] double bestOfPairs(const Value& value) const {
    if (count_ > mostTogether) {
      return -unbounded;
    }
    std::array<OfCorners, mostTogether> known;
    double best = -unbounded;
    for (std::size_t i = 0; i < count_; ++i) {
      std::transform(corners_.begin(), corners_.end(), known[i].begin(),
                     [&](const Vec3& corner) { return value(list_[i], corner); });
      for (std::size_t k = 0; k < i; ++k) {
        best = std::max(best, bestOf(known[i], known[k]));
      }
    }
    return best;
  }
  /// It is greatest with one of them alone, or where two corners are equal.
  [[nodiscard]] double bestOf(const OfCorners& one, const OfCorners& other) const {
    const auto leastBy = [&](double share) {
      double low = unbounded;
      for (std::size_t i = 0; i < corners_.size(); ++i) {
        low = std::min(low, one[i] + share * (other[i] - one[i]));
      }
      return low;
    };
    double best = std::max(leastBy(0.0), leastBy(1.0));
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const double share = (one[k] - one[i]) / ((other[i] - one[i]) - (other[k] - one[k]));
        if (share > 0.0 && share < 1.0) {
          best = std::max(best, leastBy(share));
        }
      }
    }
    return best;
  }
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
  std::array<std::size_t, mostTogether> list_{};
  std::size_t count_ = 0;

 public:
  double lowest = unbounded, highest = -unbounded;  ///< heights over their planes, on the side
  double least = unbounded;                         ///< distance from any of them
};

class MeshRingProbe final : public Probe, public Patient {
 public:
  MeshRingProbe(const surface::Mesh& mesh, const Relation& relation)
      : mesh_(mesh),
        side_(relation.side),
        thick_(relation.thick),
        ring_(*relation.cutter),
        arm_(std::hypot(ring_.e, ring_.f)) {}

  void take(const Chord& chord) override { chord_ = chord; }
  [[nodiscard]] bool givesUp() const override { return inVain_ >= patience; }
  Node resume(const Node& previous) override { return turned(previous, chord_); }

  Node at(double s) override {
    Node n = placeOn(chord_, s);
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
    double far = hull.farthest(static_cast<std::size_t>(hint_.triangle)) + bulge;
    hull.collect(far + bulge + tolerance::sameSide);
    far = std::min(far, hull.farthestTogether() + bulge);
    if (hull.lowest <= bulge) {
      hull.lowest = std::max(hull.lowest, hull.lowestTogether());
    }
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
    if (aim == -unbounded || givesUp()) {
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
};
}  // namespace

std::unique_ptr<Probe> makeMeshRingProbe(const surface::Mesh& mesh, const Relation& relation) {
  return std::make_unique<MeshRingProbe>(mesh, relation);
}

}  // namespace arelem::certify
