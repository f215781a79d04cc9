#include "runtime/tool/mesh_contact.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/geometry/triangle_tree.h"
#include "runtime/tool/rounded.h"

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
/// Golden sections of the length of a cutter: they end at 1e-12 of it.
constexpr int sections = 58;

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
    : cutter_(cutter), te_(te), axis_(axis), sweep_(sweep), upright_(axis == Vec3::UnitZ()) {
  straight_ = isRounded(cutter) && cutter.alpha == 0.0 && cutter.beta == 0.0;
  radius_ = straight_ ? cutter.e : cutter.maxRadius();
  height_ = straight_ ? cutter.f : 0.0;
  ball_ = straight_ ? cutter.r : 0.0;
}

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
      const double slope = -c.normal.dot(edge);
      if (c.gap < best.gap) {
        best = c;
        best.tangent = c.gap >= 0.0 || std::abs(slope) <= flatEdge * length;
      }
      return slope;
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

/// Support of the cutter towards a plane through `on`, by the side of its normal.
TriangleGap TriangleCutter::ofPlane(const Vec3& on, const Vec3& normal) const {
  const double nz = normal.dot(axis_);
  const ProfilePoint q = reachPoint(cutter_, nz);
  const Vec3 across = nz * axis_ - normal;
  const double length = across.norm();
  const Vec3 deepest =
      te_ + q.z * axis_ +
      q.rho * (length > 0.0 ? Vec3(across / length) : Vec3(axis_.unitOrthogonal()));
  return {normal.dot(deepest - on), normal, deepest};
}

/// The place of a plane that is deepest inside the cutter, where that is more than its corner is
/// round: by symmetry it lies in the plane of axis and normal. The least of a convex function by
/// golden sections.
Vec3 TriangleCutter::deepestPlace(const Vec3& on, const Vec3& normal) const {
  constexpr double golden = 0.6180339887498949;
  const Vec3 start = te_ - normal.dot(te_ - on) * normal;
  const Vec3 across = axis_ - normal.dot(axis_) * normal;
  const double steep = across.norm();
  if (steep <= tolerance::rounding) {
    return start;
  }
  const Vec3 along = across / steep;
  const auto at = [&](double t) { return distance(start + t * along); };
  double high = cutter_.h + cutter_.maxRadius();
  double low = -high;
  double x1 = high - golden * (high - low);
  double x2 = low + golden * (high - low);
  double f1 = at(x1);
  double f2 = at(x2);
  for (int i = 0; i < sections; ++i) {
    if (f1 <= f2) {
      high = x2;
      x2 = x1;
      f2 = f1;
      x1 = high - golden * (high - low);
      f1 = at(x1);
    } else {
      low = x1;
      x1 = x2;
      f1 = f2;
      x2 = low + golden * (high - low);
      f2 = at(x2);
    }
  }
  return start + 0.5 * (low + high) * along;
}

TriangleGap TriangleCutter::gapTo(const geometry::TriangleMesh& mesh, std::size_t triangle) const {
  const Vec3& a = mesh.corner(triangle, 0);
  const Vec3& b = mesh.corner(triangle, 1);
  const Vec3& c = mesh.corner(triangle, 2);
  if (const auto ball = ballGap(a, b, c)) {
    return *ball;
  }
  const Vec3 up = (b - a).cross(c - a).normalized();
  const TriangleGap above = ofPlane(a, up);
  const TriangleGap below = ofPlane(a, -up);
  const TriangleGap& plane = above.gap >= below.gap ? above : below;
  const Vec3 place = plane.onCutter - plane.gap * plane.normal;
  // Outside the plane, and inside as far as the cutter is round, the place is the plane's nearest.
  const bool nearest = plane.gap >= 0.0 || distance(place) <= plane.gap + touching;
  if (nearest && isInside(a, b, c, up, place)) {
    return plane;
  }
  if (!nearest && !cutter_.ring) {
    const Vec3 deepest = deepestPlace(a, up);
    if (isInside(a, b, c, up, deepest)) {
      TriangleGap inside = contactAt(deepest);
      inside.tangent = false;
      return inside;
    }
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

/// The distance to a convex body is a convex function of the place and of the tool end together: it
/// lies above its tangents. One in the middle of the way often says enough, else a second one at
/// the end towards which the tool comes nearer. A ring has only its slope of 1. `spread`: the most
/// that a gradient changes from the center to anywhere else, downwards.
template <class Spread>
bool TriangleCutter::mayReachAround(const Vec3& center, double gap, Spread spread) const {
  const Away middle = away(center);
  const double low = middle.distance - spread(middle.gradient);
  const double fall = middle.gradient.dot(sweep_);  // towards te + sweep
  if (low - std::abs(fall) > gap || low <= gap) {
    return low <= gap;
  }
  const double sense = fall > 0.0 ? 1.0 : -1.0;
  const Away end = away(center - sense * sweep_);  // as if the tool had moved
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
  const double dx = std::max({low.x() - sweep.x() - te_.x(), te_.x() - sweep.x() - high.x(), 0.0});
  const double dy = std::max({low.y() - sweep.y() - te_.y(), te_.y() - sweep.y() - high.y(), 0.0});
  const double beside = std::max(std::sqrt(dx * dx + dy * dy) - radius_, 0.0);
  const double below = std::max(te_.z() + height_ - sweep.z() - high.z(), 0.0);
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
  if (cutter_.ring) {
    return distance(center) - half.norm() - sweep_.norm() <= gap;
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
  if (cutter_.ring) {
    const double radius = std::sqrt(std::max(
        {(a - center).squaredNorm(), (b - center).squaredNorm(), (c - center).squaredNorm()}));
    return distance(center) - radius - sweep_.norm() <= gap;
  }
  return mayReachAround(center, gap, [&](const Vec3& n) {
    return -std::min({n.dot(a - center), n.dot(b - center), n.dot(c - center)});
  });
}

namespace {
class LeastGap final : public geometry::TriangleSearch {
 public:
  LeastGap(const TriangleCutter& cutter, const geometry::TriangleMesh& mesh, std::size_t start)
      : cutter_(cutter), mesh_(mesh), nearest(start), least(cutter.gapTo(mesh, start)) {}

  bool enters(const Vec3& center, const Vec3& half) override {
    return cutter_.mayReach(center, half, least.gap);
  }
  void visit(std::size_t i) override {
    if (i != nearest && cutter_.mayReach(mesh_, i, least.gap)) {
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
