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

TriangleCutter::TriangleCutter(const Profile& cutter, const Vec3& te, const Vec3& axis)
    : cutter_(cutter), te_(te), axis_(axis) {}

double TriangleCutter::distance(const Vec3& place) const {
  const Vec3 w = place - te_;
  const double z = w.dot(axis_);
  ProfilePoint nearest;
  return distanceTo(cutter_, {(w - z * axis_).norm(), z}, nearest);
}

/// The contact of the body with a point of the triangle.
TriangleGap TriangleCutter::contactAt(const Vec3& place) const {
  const Vec3 w = place - te_;
  const double z = w.dot(axis_);
  const Vec3 across = w - z * axis_;
  const double rho = across.norm();
  const Vec3 out = rho > 0.0 ? Vec3(across / rho) : Vec3(axis_.unitOrthogonal());
  ProfilePoint q;
  TriangleGap result;
  result.gap = distanceTo(cutter_, {rho, z}, q);
  result.onCutter = te_ + q.rho * out + q.z * axis_;
  Vec3 away = place - result.onCutter;  // out of the body where the place is outside of it
  if (std::abs(result.gap) <= touching) {
    // The direction in which the distance grows, from places around.
    ProfilePoint ignored;
    const double h = 1e-6 * (1.0 + cutter_.maxRadius());
    const double byRho = distanceTo(cutter_, {rho + h, z}, ignored) -
                         distanceTo(cutter_, {std::max(rho - h, 0.0), z}, ignored);
    const double byZ =
        distanceTo(cutter_, {rho, z + h}, ignored) - distanceTo(cutter_, {rho, z - h}, ignored);
    away = byRho * out + byZ * axis_;
  } else if (result.gap < 0.0) {
    away = -away;
  }
  const double length = away.norm();
  result.normal = length > 0.0 ? Vec3(-away / length) : axis_;
  return result;
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

double TriangleCutter::lowerBound(const geometry::TriangleMesh& mesh, std::size_t triangle) const {
  const Vec3& a = mesh.corner(triangle, 0);
  const Vec3& b = mesh.corner(triangle, 1);
  const Vec3& c = mesh.corner(triangle, 2);
  const Vec3 center = (a + b + c) / 3.0;
  const double radius = std::sqrt(std::max(
      {(a - center).squaredNorm(), (b - center).squaredNorm(), (c - center).squaredNorm()}));
  return distance(center) - radius;
}

std::pair<Vec3, Vec3> TriangleCutter::box(double beyond) const {
  const double low = std::min(0.0, cutter_.f - cutter_.r);
  const double half = 0.5 * (cutter_.h - low);
  const Vec3 center = te_ + 0.5 * (cutter_.h + low) * axis_;
  Vec3 extent;
  for (Eigen::Index i = 0; i < 3; ++i) {
    extent[i] = half * std::abs(axis_[i]) +
                cutter_.maxRadius() * std::sqrt(std::max(0.0, 1.0 - axis_[i] * axis_[i])) + beyond;
  }
  return {center - extent, center + extent};
}

}  // namespace arelem::tool
