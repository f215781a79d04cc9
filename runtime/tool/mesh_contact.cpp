#include "runtime/tool/mesh_contact.h"

#include <algorithm>
#include <cmath>

#include "runtime/geometry/triangle_tree.h"

namespace arelem::tool {

TriangleCutter::TriangleCutter(const Body& cutter,
                               const Vec3& te,
                               const Vec3& axis,
                               const Vec3& sweep)
    : body_(cutter, te, axis), sweep_(sweep), upright_(axis == Vec3::UnitZ()) {
  const Profile& p = cutter.cutter();
  straight_ = cutter.isPlain() && p.beta == 0.0;
  radius_ = straight_ ? p.e : p.maxRadius();
  height_ = straight_ ? p.f : 0.0;
  ball_ = straight_ ? p.r : 0.0;
}

/// The distance to a convex body is a convex function of the place and of the tool end together: it
/// lies above its tangents. One in the middle of the way often says enough, else a second one at
/// the end towards which the tool comes nearer. Other bodies have only their slope of 1. `spread`:
/// the most that a gradient changes from the center to anywhere else, downwards.
template <class Spread>
bool TriangleCutter::mayReachAround(const Vec3& center, double gap, Spread spread) const {
  const PlacedBody::Away middle = body_.away(center);
  const double low = middle.distance - spread(middle.gradient);
  const double fall = middle.gradient.dot(sweep_);  // towards te + sweep
  if (low - std::abs(fall) > gap || low <= gap) {
    return low <= gap;
  }
  const double sense = fall > 0.0 ? 1.0 : -1.0;
  const PlacedBody::Away end = body_.away(center - sense * sweep_);  // as if the tool had moved
  const double lowThere = end.distance - spread(end.gradient);
  const double fallThere = sense * end.gradient.dot(sweep_);
  if (lowThere <= gap || fallThere >= 0.0) {
    return lowThere <= gap;
  }
  const double steep = sense * fall;
  const double s = (low - lowThere - fallThere) / (steep - fallThere);
  return low - steep * s <= gap;
}

/// True where a box is farther than `gap` from the cylinder around an upright cutter, all the way:
/// cheap, and enough for most boxes.
bool TriangleCutter::isBeside(const Vec3& low, const Vec3& high, double gap) const {
  const Vec3 sweep = sweep_.cwiseAbs();
  const double dx =
      std::max({low.x() - sweep.x() - body_.te().x(), body_.te().x() - sweep.x() - high.x(), 0.0});
  const double dy =
      std::max({low.y() - sweep.y() - body_.te().y(), body_.te().y() - sweep.y() - high.y(), 0.0});
  const double beside = std::max(std::sqrt(dx * dx + dy * dy) - radius_, 0.0);
  const double below = std::max(body_.te().z() + height_ - sweep.z() - high.z(), 0.0);
  const double most = gap + ball_;
  return most < 0.0 ? beside > 0.0 || below > 0.0 : beside * beside + below * below > most * most;
}

bool TriangleCutter::mayReach(const Vec3& center, const Vec3& half, double gap) const {
  if (upright_) {
    const bool beside = isBeside(center - half, center + half, gap);
    if (beside || straight_) {
      return !beside;
    }
  }
  if (!body_.isConvex()) {
    return body_.distance(center) - half.norm() - sweep_.norm() <= gap;
  }
  return mayReachAround(center, gap, [&](const Vec3& n) { return n.cwiseAbs().dot(half); });
}

bool TriangleCutter::mayReach(const geometry::TriangleMesh& mesh,
                              std::size_t triangle,
                              double gap) const {
  const Vec3& a = mesh.corner(triangle, 0);
  const Vec3& b = mesh.corner(triangle, 1);
  const Vec3& c = mesh.corner(triangle, 2);
  if (upright_ && isBeside(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), gap)) {
    return false;
  }
  if (upright_ && straight_ && radius_ == 0.0 && sweep_.isZero(0.0)) {
    return true;  // a ball's gap itself costs no more
  }
  const Vec3 center = (a + b + c) / 3.0;
  if (!body_.isConvex()) {
    const double radius = std::sqrt(std::max(
        {(a - center).squaredNorm(), (b - center).squaredNorm(), (c - center).squaredNorm()}));
    return body_.distance(center) - radius - sweep_.norm() <= gap;
  }
  return mayReachAround(center, gap, [&](const Vec3& n) {
    return -std::min({n.dot(a - center), n.dot(b - center), n.dot(c - center)});
  });
}

namespace {
class LeastGap {
 public:
  LeastGap(const TriangleCutter& cutter, const geometry::TriangleMesh& mesh, std::size_t start)
      : cutter_(cutter), mesh_(mesh), nearest(start), least(cutter.gapTo(mesh, start)) {}

  bool enters(const Vec3& center, const Vec3& half) {
    return cutter_.mayReach(center, half, least.gap);
  }
  void visit(std::size_t i) {
    if (i != nearest && cutter_.mayReach(mesh_, i, least.gap)) {
      const TriangleGap gap = cutter_.gapTo(mesh_, i, least.gap);
      if (gap.gap < least.gap || (gap.gap == least.gap && i < nearest)) {
        least = gap;
        nearest = i;
      }
    }
  }

 private:
  const TriangleCutter& cutter_;
  const geometry::TriangleMesh& mesh_;

 public:
  std::size_t nearest;
  TriangleGap least;
};
}  // namespace

TriangleGap leastGap(const TriangleCutter& cutter,
                     const geometry::TriangleMesh& mesh,
                     const geometry::TriangleTree& tree,
                     std::size_t& triangle) {
  LeastGap search(cutter, mesh, triangle);
  tree.search(search);
  triangle = search.nearest;
  return search.least;
}

}  // namespace arelem::tool
