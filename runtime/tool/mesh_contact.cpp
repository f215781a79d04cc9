#include "runtime/tool/mesh_contact.h"

#include <algorithm>
#include <cmath>

#include "runtime/geometry/triangle_tree.h"

namespace arelem::tool {

namespace {
constexpr int edgeSteps = 60;
/// Places of an edge are told to this. Part unit.
constexpr double placeOnEdge = 1e-12;
/// A ring is no convex body: its edges are searched in parts.
constexpr int ringParts = 8;
/// Slope of the distance along an edge that counts as its least place. Dimensionless.
constexpr double flatEdge = 1e-10;
/// Distances below this have no direction of their own. Part unit.
constexpr double touching = 1e-11;

/// True where p, a point of the plane of a, b, c with normal n, lies in the triangle.
bool isInside(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& n, const Vec3& p) {
  return n.dot((b - a).cross(p - a)) >= 0.0 && n.dot((c - b).cross(p - b)) >= 0.0 &&
         n.dot((a - c).cross(p - c)) >= 0.0;
}
}  // namespace

TriangleCutter::TriangleCutter(const Profile& cutter,
                               const Vec3& te,
                               const Vec3& axis,
                               const Vec3& sweep)
    : cutter_(cutter), te_(te), axis_(axis), sweep_(sweep) {}

double TriangleCutter::distance(const Vec3& place) const {
  const Vec3 w = place - te_;
  const double z = w.dot(axis_);
  ProfilePoint nearest;
  return distanceTo(cutter_, {(w - z * axis_).norm(), z}, nearest);
}

TriangleCutter::Away TriangleCutter::away(const Vec3& place) const {
  const Vec3 w = place - te_;
  const double z = w.dot(axis_);
  const Vec3 across = w - z * axis_;
  const double rho = across.norm();
  const Vec3 out = rho > 0.0 ? Vec3(across / rho) : Vec3(axis_.unitOrthogonal());
  ProfilePoint q;
  Away result;
  result.distance = distanceTo(cutter_, {rho, z}, q);
  double byRho = rho - q.rho;
  double byZ = z - q.z;
  if (std::abs(result.distance) <= touching) {
    // The direction in which the distance grows, from places around.
    ProfilePoint ignored;
    const double h = 1e-6 * (1.0 + cutter_.maxRadius());
    byRho = distanceTo(cutter_, {rho + h, z}, ignored) -
            distanceTo(cutter_, {std::max(rho - h, 0.0), z}, ignored);
    byZ = distanceTo(cutter_, {rho, z + h}, ignored) - distanceTo(cutter_, {rho, z - h}, ignored);
  } else if (result.distance < 0.0) {
    byRho = -byRho;
    byZ = -byZ;
  }
  const double length = std::sqrt(byRho * byRho + byZ * byZ);
  result.gradient = length > 0.0 ? Vec3((byRho * out + byZ * axis_) / length) : Vec3(-axis_);
  result.onCutter = te_ + q.rho * out + q.z * axis_;
  return result;
}

/// The contact of the body with a point of the triangle.
TriangleGap TriangleCutter::contactAt(const Vec3& place) const {
  const Away a = away(place);
  return {a.distance, -a.gradient, a.onCutter};
}

/// The distance along an edge is convex: the zero of its slope by regula falsi (Illinois).
void TriangleCutter::considerEdge(const Vec3& a, const Vec3& b, TriangleGap& best) const {
  const Vec3 edge = b - a;
  const double length = edge.norm();
  const int parts = cutter_.ring ? ringParts : 1;
  for (int part = 0; part < parts; ++part) {
    double low = static_cast<double>(part) / parts;
    double high = (part + 1.0) / parts;
    if (distance(a + 0.5 * (low + high) * edge) - 0.5 * length * (high - low) >= best.gap) {
      continue;
    }
    const auto slopeAt = [&](double t) {
      const TriangleGap c = contactAt(a + t * edge);
      best = c.gap < best.gap ? c : best;
      return -c.normal.dot(edge);
    };
    double atLow = slopeAt(low);
    double atHigh = slopeAt(high);
    int kept = 0;  // how often the same end stayed
    for (int i = 0;
         i < edgeSteps && atLow < 0.0 && atHigh > 0.0 && (high - low) * length > placeOnEdge; ++i) {
      const double t =
          i % 4 == 3 ? 0.5 * (low + high) : low - atLow * (high - low) / (atHigh - atLow);
      const double slope = slopeAt(t);
      if (std::abs(slope) <= flatEdge * length) {
        break;
      }
      if (slope > 0.0) {
        high = t;
        atHigh = slope;
        atLow *= kept < 0 ? 0.5 : 1.0;
        kept = -1;
      } else {
        low = t;
        atLow = slope;
        atHigh *= kept > 0 ? 0.5 : 1.0;
        kept = 1;
      }
    }
  }
}

/// A ball's nearest point of the triangle is that of its center, if the ball touches with its lower
/// half.
std::optional<TriangleGap> TriangleCutter::ballGap(const Vec3& a,
                                                   const Vec3& b,
                                                   const Vec3& c) const {
  if (!cutter_.isBall() || cutter_.r <= 0.0) {
    return std::nullopt;
  }
  const Vec3 center = te_ + cutter_.f * axis_;
  const Vec3 w = center - geometry::nearestOn(a, b, c, center).point;
  const double distance = w.norm();
  const Vec3 normal = w / distance;
  if (!(distance > touching) || normal.dot(axis_) < cutter_.sinBeta) {
    return std::nullopt;
  }
  return TriangleGap{distance - cutter_.r, normal, center - cutter_.r * normal};
}

TriangleGap TriangleCutter::gapTo(const geometry::TriangleMesh& mesh, std::size_t triangle) const {
  const Vec3& a = mesh.corner(triangle, 0);
  const Vec3& b = mesh.corner(triangle, 1);
  const Vec3& c = mesh.corner(triangle, 2);
  if (const auto ball = ballGap(a, b, c)) {
    return *ball;
  }
  const Vec3 up = (b - a).cross(c - a).normalized();
  // The side from which the cutter comes: that of the middle of its axis.
  const Vec3 middle = te_ + std::max(cutter_.f, std::min(cutter_.h, cutter_.d) / 2) * axis_;
  const Vec3 normal = up.dot(middle - a) < 0.0 ? Vec3(-up) : up;
  const double nz = normal.dot(axis_);
  const ProfilePoint q = farthestAgainst(cutter_, nz);
  const Vec3 across = nz * axis_ - normal;
  const double length = across.norm();
  const Vec3 deepest =
      te_ + q.z * axis_ +
      q.rho * (length > 0.0 ? Vec3(across / length) : Vec3(axis_.unitOrthogonal()));
  const double gap = normal.dot(deepest - a);
  if (isInside(a, b, c, up, deepest - gap * normal)) {
    return {gap, normal, deepest};
  }
  TriangleGap best = contactAt(a);
  for (const Vec3& corner : {b, c}) {
    if (distance(corner) < best.gap) {
      best = contactAt(corner);
    }
  }
  considerEdge(a, b, best);
  considerEdge(b, c, best);
  considerEdge(c, a, best);
  return best;
}

// The distance to a convex body is a convex function of the place and of the tool end: it lies
// above its tangent at the middle. A ring has only its slope of 1.

double TriangleCutter::lowerBound(const Vec3& center, const Vec3& half) const {
  if (cutter_.ring) {
    return distance(center) - half.norm() - sweep_.norm();
  }
  const Away a = away(center);
  return a.distance - a.gradient.cwiseAbs().dot(half) - std::abs(a.gradient.dot(sweep_));
}

double TriangleCutter::lowerBound(const geometry::TriangleMesh& mesh, std::size_t triangle) const {
  const Vec3& a = mesh.corner(triangle, 0);
  const Vec3& b = mesh.corner(triangle, 1);
  const Vec3& c = mesh.corner(triangle, 2);
  const Vec3 center = (a + b + c) / 3.0;
  if (cutter_.ring) {
    const double radius = std::sqrt(std::max(
        {(a - center).squaredNorm(), (b - center).squaredNorm(), (c - center).squaredNorm()}));
    return distance(center) - radius - sweep_.norm();
  }
  const Away there = away(center);
  const Vec3& n = there.gradient;
  return there.distance + std::min({n.dot(a - center), n.dot(b - center), n.dot(c - center)}) -
         std::abs(n.dot(sweep_));
}

namespace {
class LeastGap final : public geometry::TriangleSearch {
 public:
  LeastGap(const TriangleCutter& cutter, const geometry::TriangleMesh& mesh, std::size_t start)
      : cutter_(cutter), mesh_(mesh), nearest(start), least(cutter.gapTo(mesh, start)) {}

  bool enters(const Vec3& center, const Vec3& half) override {
    return cutter_.lowerBound(center, half) <= least.gap;
  }
  void visit(std::size_t i) override {
    if (i != nearest && cutter_.lowerBound(mesh_, i) <= least.gap) {
      const TriangleGap gap = cutter_.gapTo(mesh_, i);
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
