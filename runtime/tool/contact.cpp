#include "runtime/tool/contact.h"

#include <optional>
#include <tuple>

#include "ir/space/motion_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/tool/contact_search.h"
#include "runtime/tool/ring_contact.h"
#include "runtime/tool/rounded.h"

namespace arelem::tool {

namespace {
/// Sine of the angle up to which the axis of a cylinder counts as square to that of the tool.
constexpr double square = 1e-12;

bool isWall(const Vec3& generatrix, const Vec3& axis) {
  return std::abs(generatrix.dot(axis)) > 0.5 &&
         generatrix.cross(axis).norm() <= tolerance::wallAlongAxis;
}

/// A wall along the tool axis: the cutter is a disc of its largest radius.
template <surface::Surface S>
Contact wallContact(
    const S& s, double side, const Profile& cutter, const Vec3& te, Search<S>& search) {
  const surface::Foot foot = s.foot(te, search.hint);
  const Vec3 normal = side * foot.normal;
  const double radius = cutter.maxRadius();
  return {side * foot.distance - radius, normal, te - radius * normal};
}

/// True where side * distance is a convex function: it bends towards the cutter nowhere.
template <surface::Surface S>
bool isConvex(const S& s, double side, const Vec3& at) {
  typename S::Hint hint{};
  const surface::Bends b = s.bends(at, s.foot(at, hint), tolerance::farAway);
  return side > 0.0 ? b.low >= 0.0 : b.high <= 0.0;
}

/// Closed forms; the general search does the rest.
template <surface::Surface S>
Contact contactOf(const S& s,
                  double side,
                  const Profile& cutter,
                  const Vec3& te,
                  const Vec3& axis,
                  Search<S>& search) {
  if (isWall(surface::generatrix(s), axis)) {
    return wallContact(s, side, cutter, te, search);
  }
  if (!search.valid) {
    search.convex = isConvex(s, side, te);
  }
  return ContactSearch<S>(s, side, cutter, te, axis, search).run();
}

/// The unit normal of the cutter towards its inside in one of its places; none in the tip of a
/// drill.
std::optional<Vec3> inwards(const Profile& p, const Vec3& fromTip, const Vec3& axis) {
  const double z = fromTip.dot(axis);
  const Vec3 across = fromTip - z * axis;
  const double rho = across.norm();
  if (p.alpha == 0.0 && z <= tolerance::sameSide) {
    return axis;
  }
  if (p.ring || rho <= tolerance::sameSide) {
    return std::nullopt;
  }
  const Vec3 out = across / rho;
  if (rho <= p.bottomEnd.rho && z * p.cosAlpha - rho * p.sinAlpha <= tolerance::sameSide) {
    return p.cosAlpha * axis - p.sinAlpha * out;
  }
  if (p.r > 0.0 && z <= p.sideStart.z) {
    return ((p.f - z) * axis - (rho - p.e) * out) / p.r;
  }
  return p.sinBeta * axis - p.cosBeta * out;
}

/// Where the axis of a cone leaves a cutter that covers its tip, and how deep that is.
Contact whereAxisLeaves(
    const surface::Cone& s, const Profile& cutter, const Vec3& te, const Vec3& axis, Contact c) {
  const auto isInside = [&](double along) {
    const Vec3 way = s.vertex + along * s.axis - te;
    const double z = way.dot(axis);
    ProfilePoint nearest;
    return distanceTo(cutter, {(way - z * axis).norm(), z}, nearest) < 0.0;
  };
  double low = 0.0;
  double high = tolerance::sameSide;
  if (!isInside(low)) {
    return c;
  }
  while (isInside(high)) {
    low = high;
    high *= 2.0;
  }
  for (double middle = 0.5 * (low + high); low < middle && middle < high;
       middle = 0.5 * (low + high)) {
    (isInside(middle) ? low : high) = middle;
  }
  c.gap = -high * s.sinHalf;
  c.point = s.vertex + high * s.axis;
  return c;
}

/// The ball of a corner that reaches into a cone beyond its axis is nearer to the other side of it:
/// how far its center is off does not tell how deep it is.
bool passesAxis(const surface::Cone& s, const Profile& cutter, const Contact& c) {
  if (c.gap >= 0.0 || cutter.r == 0.0 || cutter.e == 0.0) {
    return false;
  }
  const Vec3 way = c.point - s.vertex;
  return (way - way.dot(s.axis) * s.axis).dot(c.normal) < 0.0;
}

/// A cutter that covers the tip of a cone is nearest to it on the cone's axis, where normals of all
/// sides meet. With m the cutter's own normal there, the gap changes with the height of that place,
/// by sin(half): so does their mean, which goes with m and is shorter than 1.
Contact contactOf(const surface::Cone& s,
                  double side,
                  const Profile& cutter,
                  const Vec3& te,
                  const Vec3& axis,
                  Search<surface::Cone>& search) {
  if (side < 0.0) {
    return contactOf<surface::Cone>(s, side, cutter, te, axis, search);
  }
  if (const auto corner = search.corner.contact(s, cutter, te, axis)) {
    return *corner;
  }
  if (search.corner.isKnown()) {
    search.toward = search.corner.toward();
    search.towardTurns = Vec3::Zero();
  }
  Contact c = contactOf<surface::Cone>(s, side, cutter, te, axis, search);
  search.corner.goOn(s, cutter, te, axis, c);
  if (passesAxis(s, cutter, c)) {
    c = whereAxisLeaves(s, cutter, te, axis, c);
  }
  if (c.gap < 0.0 && (c.point - s.vertex).cross(s.axis).norm() <= tolerance::sameSide) {
    const auto m = inwards(cutter, c.point - te, axis);
    const double share = m ? -s.axis.dot(*m) : 0.0;
    if (share > s.sinHalf) {
      c.normal = (s.sinHalf / share) * *m;
    }
  }
  return c;
}

/// Square to the generatrix the section tells all.
Contact contactOf(const surface::TabulatedCylinder& s,
                  double side,
                  const Profile& cutter,
                  const Vec3& te,
                  const Vec3& axis,
                  Search<surface::TabulatedCylinder>& search) {
  if (const auto section = search.section.contact(s, side, cutter, te, axis)) {
    return *section;
  }
  const auto low = search.section.low();
  const Contact found = contactOf<surface::TabulatedCylinder>(s, side, cutter, te, axis, search);
  return low && low->gap < found.gap ? *low : found;
}

Contact contactOf(const surface::Plane& s,
                  double side,
                  const Profile& cutter,
                  const Vec3& te,
                  const Vec3& axis,
                  Search<surface::Plane>&) {
  const Vec3 normal = side * s.normal;
  const double nz = normal.dot(axis);
  const double far = reach(cutter, nz);
  const ProfilePoint q = reachPoint(cutter, nz);
  const Vec3 across = nz * axis - normal;
  const double length = across.norm();
  const Vec3 out = length > tolerance::rounding ? Vec3(across / length) : Vec3(Vec3::Zero());
  return {side * (s.normal.dot(te) - s.offset) - far, normal, te + q.rho * out + q.z * axis};
}

Contact contactOf(const surface::Sphere& s,
                  double side,
                  const Profile& cutter,
                  const Vec3& te,
                  const Vec3& axis,
                  Search<surface::Sphere>&) {
  if (side > 0.0 && isRoundBall(cutter)) {
    // Two convex bodies: what is nearest nearby is nearest of all.
    const Vec3 ball = te + cutter.f * axis;
    const Vec3 away = ball - s.center;
    const double distance = away.norm();
    const Vec3 normal = away / distance;
    if (normal.dot(axis) >= cutter.sinBeta) {
      return {distance - cutter.r - s.radius, normal, ball - cutter.r * normal};
    }
  }
  const Vec3 w = s.center - te;
  const double z = w.dot(axis);
  const Vec3 across = w - z * axis;
  const double rho = across.norm();
  // Where the axis goes through the center, what is left of w is rounding of any direction.
  const bool apart = rho > tolerance::rounding * (1.0 + std::abs(z));
  const Vec3 out = apart ? Vec3(across / rho) : Vec3(axis.unitOrthogonal());
  ProfilePoint q;
  if (side > 0.0) {
    const double distance = distanceUnderTop(cutter, {rho, z}, q);
    const Vec3 point = te + q.rho * out + q.z * axis;
    const Vec3 normal = (point - s.center) / (distance != 0.0 ? distance : 1.0);
    return {distance - s.radius, normal, point};
  }
  const double distance = farthestFrom(cutter, {rho, z}, q);
  const Vec3 point = te - q.rho * out + q.z * axis;
  return {s.radius - distance, (s.center - point) / distance, point};
}

/// Across a cylinder that lies square to the tool axis the cutter is its profile, and the cylinder
/// a circle. The face on top does not cut, but seen along the cylinder its rim lies all over it.
Contact contactOf(const surface::Cylinder& s,
                  double side,
                  const Profile& cutter,
                  const Vec3& te,
                  const Vec3& axis,
                  Search<surface::Cylinder>& search) {
  if (cutter.ring || std::abs(s.axis.dot(axis)) > square) {
    return contactOf<surface::Cylinder>(s, side, cutter, te, axis, search);
  }
  const Vec3 w = s.point - te;
  const double z = w.dot(axis);
  // Square to both axes whatever is left of w there, which may be rounding alone.
  const Vec3 beside = s.axis.cross(axis);
  const double aside = w.dot(beside);
  const double rho = std::abs(aside);
  const Vec3 out = aside < 0.0 ? Vec3(-beside) : beside;
  ProfilePoint q;
  if (side > 0.0) {
    const ProfilePoint top = cutter.sideEnd;
    if (z >= top.z && rho < top.rho) {
      // The upper rim is an edge there, of which the profile has the end only.
      const Vec3 onRim = rho * out + std::sqrt(top.rho * top.rho - rho * rho) * s.axis;
      return {z - top.z - s.radius, -axis, te + onRim + top.z * axis};
    }
    const double distance = distanceUnderTop(cutter, {rho, z}, q);
    const double scale = distance != 0.0 ? 1.0 / distance : 1.0;
    return {distance - s.radius, scale * ((q.rho - rho) * out + (q.z - z) * axis),
            te + q.rho * out + q.z * axis};
  }
  const double distance = farthestFrom(cutter, {rho, z}, q);
  return {s.radius - distance, ((rho + q.rho) * out + (z - q.z) * axis) / distance,
          te - q.rho * out + q.z * axis};
}

/// The least gap of all triangles that the cutter may reach. Sides do not matter: a cutter that has
/// a body touches a mesh from where it is.
Contact contactOf(const surface::Mesh& s,
                  double side,
                  const Profile& cutter,
                  const Vec3& te,
                  const Vec3& axis,
                  Search<surface::Mesh>& search) {
  if (cutter.ring) {
    return ringContact(s, side, cutter, te, axis, search.hint);
  }
  const surface::MeshShape& shape = s.shape();
  if (search.hint.triangle < 0) {
    const Vec3 core = te + cutter.f * axis;
    search.hint.triangle = static_cast<int>(shape.tree.nearest(shape.mesh, core, -1));
  }
  auto nearest = static_cast<std::size_t>(search.hint.triangle);
  const TriangleGap least = search.near.least(shape, cutter, te, axis, nearest);
  search.hint.triangle = static_cast<int>(nearest);
  return {least.gap, least.normal, least.onCutter};
}
}  // namespace

template <surface::Surface S>
Contact contact(const S& s,
                double side,
                const Profile& cutter,
                const Vec3& te,
                const Vec3& axis,
                Search<S>& search) {
  return contactOf(s, side, cutter, te, axis, search);
}

/// Makes the function for every kind in the list of surfaces.
template <class Variant>
struct ContactOfKinds;
template <class... Kinds>
struct ContactOfKinds<std::variant<Kinds...>> {
  static inline const std::tuple functions{&contact<Kinds>...};
};
template struct ContactOfKinds<surface::AnySurface>;

}  // namespace arelem::tool
