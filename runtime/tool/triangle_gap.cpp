#include "runtime/tool/triangle_gap.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "runtime/geometry/least.h"
#include "runtime/geometry/triangle_tree.h"

namespace arelem::tool {

namespace {
using Away = PlacedBody::Away;

/// Distances below this have no direction of their own. Part unit.
constexpr double touching = 1e-11;
/// The least distance along an edge is told to this. Part unit.
constexpr double leastOfEdge = 1e-13;
constexpr int edgeSteps = 60;
/// Parts of an edge that are not searched any more. Part unit.
constexpr double placeOnEdge = 1e-12;
/// Slope of the distance along an edge that counts as its least place. Dimensionless.
constexpr double flatEdge = 1e-12;
/// Slopes beside the deepest place of a plane are looked at this far from it, as a share of the
/// cutter's radius: farther than golden sections may miss it.
constexpr double besideDeepest = 1e-6;
/// Against a ring and other hollow bodies edges are searched in parts.
constexpr int hollowParts = 8;
/// Golden sections of the length of a cutter: they end at 1e-12 of it.
constexpr int sections = 58;

/// True where p, a point of the triangle's plane, lies in the triangle.
bool isInside(const Facet& t, const Vec3& p) {
  return t.up.dot((t.b - t.a).cross(p - t.a)) >= 0.0 &&
         t.up.dot((t.c - t.b).cross(p - t.b)) >= 0.0 && t.up.dot((t.a - t.c).cross(p - t.c)) >= 0.0;
}

/// A ball's nearest point of the triangle is that of its center, if the ball touches with its lower
/// half.
std::optional<TriangleGap> ballGap(const PlacedBody& body, const Facet& t) {
  const Profile& cutter = body.cutter();
  if (!cutter.isBall() || cutter.r <= 0.0) {
    return std::nullopt;
  }
  const Vec3 center = body.te() + cutter.f * body.axis();
  const Vec3 w = center - geometry::nearestOn(t.a, t.b, t.c, center).point;
  const double distance = w.norm();
  const Vec3 normal = w / distance;
  if (!(distance > touching) || normal.dot(body.axis()) < cutter.sinBeta) {
    return std::nullopt;
  }
  const double gap = distance - cutter.r;
  return TriangleGap{gap, normal, center - cutter.r * normal, gap, normal};
}

/// The plane of a triangle, seen from the side from which the cutter is in it the least.
struct PlaneContact {
  double gap = 0.0;
  Vec3 normal = Vec3::Zero();
  double nz = 0.0;
  ProfilePoint on;
};

PlaneContact ofPlane(const PlacedBody& body, const Facet& t) {
  const double height = t.up.dot(body.te() - t.a);
  const double nz = t.up.dot(body.axis());
  const double steep = std::sqrt(std::max(0.0, 1.0 - nz * nz));
  const ProfilePoint above = reachPoint(body.cutter(), nz);
  const ProfilePoint below = reachPoint(body.cutter(), -nz);
  const double fromAbove = height - above.rho * steep + above.z * nz;
  const double fromBelow = -height - below.rho * steep - below.z * nz;
  return fromAbove >= fromBelow ? PlaneContact{fromAbove, t.up, nz, above}
                                : PlaneContact{fromBelow, -t.up, -nz, below};
}

/// Horizontal direction in which the plane falls, as a normal leans; any where it is level.
Vec3 lean(const PlacedBody& body, const PlaneContact& plane) {
  const Vec3 across = plane.normal - plane.nz * body.axis();
  const double length = across.norm();
  return length > 0.0 ? Vec3(across / length) : Vec3(body.axis().unitOrthogonal());
}

/// The place of a plane that is deepest inside the cutter, with the contact there.
struct Deepest {
  Vec3 place;
  TriangleGap contact;
};

/// A plane that cuts the sharp edge between bottom and side off: its deepest place is as far from
/// one as from the other. None where the deepest place is elsewhere.
std::optional<Deepest> cutEdge(const PlacedBody& body,
                               const Facet& t,
                               const PlaneContact& plane,
                               const Vec3& falls) {
  const Profile& p = body.cutter();
  if (!body.isPlain() || plane.nz <= 0.0) {
    return std::nullopt;
  }
  const double steep = std::sqrt(std::max(0.0, 1.0 - plane.nz * plane.nz));
  const double height = plane.normal.dot(body.te() - t.a);
  // A place of the plane: `up` along it from below the tool end, -rho = -(height * steep + up * nz)
  // in the direction in which it falls, z = up * steep - height * nz.
  const double rising = plane.nz * p.cosBeta + steep * (1.0 - p.sinBeta);
  const double outside = p.sideStart.rho * p.cosBeta - p.sideStart.z * p.sinBeta;
  const double up =
      (outside - height * steep * p.cosBeta + height * plane.nz * (1.0 - p.sinBeta)) / rising;
  const double rho = height * steep + up * plane.nz;
  const double z = up * steep - height * plane.nz;
  if (rho < 0.0 || z < 0.0 || steep * p.sinBeta >= plane.nz * p.cosBeta) {
    return std::nullopt;
  }
  const Vec3 place = body.te() - rho * falls + z * body.axis();
  if (std::abs(body.distance(place) + z) > touching) {
    return std::nullopt;
  }
  const double rate = 1.0 / (plane.nz + steep * (1.0 - p.sinBeta) / p.cosBeta);
  const Vec3 corner = body.te() - p.sideStart.rho * falls + p.sideStart.z * body.axis();
  const Vec3 bySide = p.cosBeta * falls + p.sinBeta * body.axis();
  const double byBottom = 1.0 - rate * steep / p.cosBeta;
  return Deepest{place, {-z, plane.normal, corner, -z, rate * plane.normal, bySide, byBottom}};
}

/// A plane below the signed distance: that of any place p is at least base + slope.p.
struct Support {
  double base = 0.0;
  Vec3 slope = Vec3::Zero();
  Vec3 other = Vec3::Zero();  ///< of a mixture: as TriangleGap has it
  double share = 1.0;

  static Support at(const Vec3& place, const Away& a) {
    return {a.distance - a.gradient.dot(place), a.gradient};
  }
};

/// A contact at a place of the triangle.
TriangleGap contactBy(const Away& a, const Support& below, const Facet& t) {
  return {a.distance,   -a.gradient,  a.onCutter, below.base + t.lowest(below.slope),
          -below.slope, -below.other, below.share};
}

/// A plane below the signed distance that is level along a line, from two whose slopes along it
/// have different signs.
Support levelled(const Support& a, const Support& b, const Vec3& along) {
  const double atA = a.slope.dot(along);
  const double atB = b.slope.dot(along);
  if (atA * atB >= 0.0) {
    return std::abs(atA) <= std::abs(atB) ? a : b;
  }
  const double share = atB / (atB - atA);
  return {share * a.base + (1.0 - share) * b.base, share * a.slope + (1.0 - share) * b.slope,
          b.slope, share};
}

/// The place of a plane that is deepest inside the cutter, where that is more than its corner is
/// round: by symmetry it lies in the plane of axis and normal. The least of a convex function by
/// golden sections. It may be a kink, where the bottom is as far as the side.
Deepest deepestOf(const PlacedBody& body, const Facet& t, const Vec3& normal) {
  const Vec3 start = body.te() - t.up.dot(body.te() - t.a) * t.up;
  const Vec3 across = body.axis() - t.up.dot(body.axis()) * t.up;
  const double steep = across.norm();
  // To a level plane all directions are alike: the slopes on two sides of the axis.
  const Vec3 along =
      steep > tolerance::rounding ? Vec3(across / steep) : Vec3(t.up.unitOrthogonal());
  const auto placeAt = [&](double s) -> Vec3 { return start + s * along; };
  const auto at = [&](double s) { return body.distance(placeAt(s)); };
  const double end = body.cutter().h + body.cutter().maxRadius();
  int left = sections;
  const double middle =
      geometry::narrowLeast(at, -end, end, [&left](double, double) { return left-- > 0; });
  const Vec3 place = placeAt(middle);
  // Their slopes have different signs there, whether it is a kink or smooth.
  const double beside = besideDeepest * body.cutter().maxRadius();
  const Vec3 before = placeAt(middle - beside);
  const Vec3 behind = placeAt(middle + beside);
  const Support below = levelled(Support::at(before, body.away(before)),
                                 Support::at(behind, body.away(behind)), along);
  Deepest deepest{place, contactBy(body.away(place), below, t)};
  deepest.contact.normal = normal;
  return deepest;
}

/// A place on an edge, as a share of it.
struct OnEdge {
  double share = 0.0;
  Away away;
  double slope = 0.0;  ///< of the distance by the share
  Support below;
};

/// The distance along an edge is convex: its least value between places where its slopes have
/// different signs, alternately by the zero of the slope, which is quick where it is smooth, and by
/// the tangents from both sides, which is quick where it has a kink.
class EdgeSearch {
 public:
  EdgeSearch(const PlacedBody& body, const Facet& t, const Vec3& from, const Vec3& to)
      : body_(body), triangle_(t), from_(from), edge_(to - from), length_(edge_.norm()) {}

  [[nodiscard]] OnEdge at(double share) const { return at(share, body_.away(place(share))); }
  [[nodiscard]] OnEdge at(double share, const Away& a) const {
    return {share, a, a.gradient.dot(edge_), Support::at(place(share), a)};
  }

  /// Lowers `best` where the edge is nearer. True where `best` shows that the whole triangle is
  /// farther off than `enough`.
  bool run(OnEdge low, OnEdge high, double enough, TriangleGap& best) const {
    if (low.slope >= 0.0 || high.slope <= 0.0) {
      return false;
    }
    int kept = 0;  // how often the same end stayed
    double atLow = low.slope;
    double atHigh = high.slope;
    const Away* least = low.away.distance <= high.away.distance ? &low.away : &high.away;
    Away nearest = *least;
    for (int i = 0; i < edgeSteps; ++i) {
      const double kink = meeting(low, high);
      const double bound = low.away.distance + low.slope * (kink - low.share);
      if (bound >= best.gap) {
        return false;
      }
      if (nearest.distance - bound <= leastOfEdge ||
          (high.share - low.share) * length_ <= placeOnEdge) {
        break;
      }
      if (bound > enough) {
        const TriangleGap found = between(low, high, nearest);
        if (found.low > enough) {
          best = found;
          return true;
        }
      }
      double share = i % 2 == 0   ? low.share - atLow * (high.share - low.share) / (atHigh - atLow)
                     : i % 8 == 7 ? 0.5 * (low.share + high.share)
                                  : kink;
      share = std::clamp(share, low.share, high.share);
      const OnEdge middle = at(share);
      if (middle.away.distance < nearest.distance) {
        nearest = middle.away;
      }
      if (std::abs(middle.slope) <= flatEdge * length_) {
        low = high = middle;
        break;
      }
      if (middle.slope > 0.0) {
        high = middle;
        atHigh = middle.slope;
        atLow = kept < 0 ? 0.5 * atLow : low.slope;
        kept = -1;
      } else {
        low = middle;
        atLow = middle.slope;
        atHigh = kept > 0 ? 0.5 * atHigh : high.slope;
        kept = 1;
      }
    }
    if (nearest.distance <= best.gap) {
      best = between(low, high, nearest);
    }
    return false;
  }

 private:
  [[nodiscard]] Vec3 place(double share) const {
    return share == 1.0 ? Vec3(from_ + edge_) : Vec3(from_ + share * edge_);
  }
  /// Where the tangents meet.
  static double meeting(const OnEdge& low, const OnEdge& high) {
    return low.share +
           (high.away.distance - low.away.distance - high.slope * (high.share - low.share)) /
               (low.slope - high.slope);
  }
  /// The mixture of both tangents that is level along the edge lies below the distance too.
  [[nodiscard]] TriangleGap between(const OnEdge& low,
                                    const OnEdge& high,
                                    const Away& nearest) const {
    const Support below = levelled(low.below, high.below, edge_);
    TriangleGap result = contactBy(nearest, below, triangle_);
    const double length = below.slope.norm();
    if (length > tolerance::nullDirection) {
      result.normal = -below.slope / length;
    }
    return result;
  }

  const PlacedBody& body_;
  const Facet& triangle_;
  const Vec3& from_;
  Vec3 edge_;
  double length_;
};

/// The nearest corner or place of an edge.
TriangleGap onBorder(const PlacedBody& body, const Facet& t, double enough) {
  const std::array<const Vec3*, 3> corners{&t.a, &t.b, &t.c};
  std::array<Away, 3> away;
  std::size_t nearest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    away[k] = body.away(*corners[k]);
    nearest = away[k].distance < away[nearest].distance ? k : nearest;
  }
  TriangleGap best = contactBy(away[nearest], Support::at(*corners[nearest], away[nearest]), t);
  const int parts = body.isConvex() ? 1 : hollowParts;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const EdgeSearch edge(body, t, *corners[k], *corners[next]);
    OnEdge low = edge.at(0.0, away[k]);
    for (int part = 1; part <= parts; ++part) {
      const OnEdge high =
          part == parts ? edge.at(1.0, away[next]) : edge.at(static_cast<double>(part) / parts);
      if (edge.run(low, high, enough, best)) {
        return best;
      }
      low = high;
    }
  }
  return best;
}
}  // namespace

TriangleGap gapOf(const PlacedBody& body, const Facet& triangle) {
  return gapOf(body, triangle, std::numeric_limits<double>::infinity());
}

TriangleGap gapOf(const PlacedBody& body, const Facet& t, double enough) {
  if (const auto ball = ballGap(body, t)) {
    return *ball;
  }
  const PlaneContact plane = ofPlane(body, t);
  const Vec3 falls = lean(body, plane);
  const Vec3 onCutter = body.te() + plane.on.z * body.axis() - plane.on.rho * falls;
  const Vec3 place = onCutter - plane.gap * plane.normal;
  // Outside the plane, and inside as far as the cutter is round, the place is the plane's nearest.
  // No triangle is nearer than its plane.
  if (plane.gap >= 0.0 || body.distance(place) <= plane.gap + touching) {
    if (plane.gap > enough || isInside(t, place)) {
      return {plane.gap, plane.normal, onCutter, plane.gap, plane.normal};
    }
  } else if (body.isConvex()) {
    const auto cut = cutEdge(body, t, plane, falls);
    const Deepest deepest = cut ? *cut : deepestOf(body, t, plane.normal);
    if (deepest.contact.gap > enough || isInside(t, deepest.place)) {
      return deepest.contact;
    }
  }
  return onBorder(body, t, enough);
}

GapTangent tangentBelow(const PlacedBody& body, const Facet& t) {
  const Vec3 center = (t.a + t.b + t.c) / 3.0;
  const Support below = Support::at(center, body.away(center));
  return {below.base + t.lowest(below.slope), -below.slope};
}

}  // namespace arelem::tool
