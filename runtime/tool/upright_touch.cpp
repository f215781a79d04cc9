#include "runtime/tool/upright_touch.h"

#include <limits>

#include "runtime/tool/body.h"

namespace arelem::tool {

namespace {
/// Edges that rise less than this, and edges that are shorter than this share of their rise when
/// seen from above, count as level and as upright.
constexpr double levelRise = 1e-13;
constexpr int newtonLimit = 40;
/// Rest of a distance, and a step after which the next one would be as small, as a share of it.
constexpr double rest = 1e-15;
constexpr double lastStep = 1e-8;
}  // namespace

std::optional<UprightProfile> UprightProfile::of(const Profile& cutter, double gap) {
  const Body body(cutter);
  if (!body.isPlain() || !body.isConvex()) {
    return std::nullopt;
  }
  UprightProfile p{cutter.e, cutter.f, cutter.r + gap, cutter.sinBeta, cutter.cosBeta, 0.0};
  p.highest = cutter.sideEnd.z + std::min(gap, -gap * cutter.sinBeta);
  if (p.r < 0.0) {
    // The corner where the pared bottom meets the pared side.
    p.e += p.r * (1.0 - p.sinBeta) / p.cosBeta;
    p.f -= p.r;
    p.r = 0.0;
  }
  return p.e < 0.0 || p.e + p.r <= 0.0 ? std::nullopt : std::optional(p);
}

std::optional<double> UprightTouch::over(double beside) const {
  const double beyond = beside - p_.e;
  if (beyond <= 0.0) {
    return p_.r - p_.f;
  }
  if (beyond >= p_.r * p_.cosBeta) {
    return std::nullopt;
  }
  return std::sqrt(p_.r * p_.r - beyond * beyond) - p_.f;
}

std::optional<Touch> UprightTouch::onCorner(const Vec3& corner, double s) const {
  const double x = corner.x() - s;
  const double rho = std::sqrt(x * x + corner.y() * corner.y());
  const double beyond = rho - p_.e;
  if (beyond <= 0.0) {
    return Touch{corner.z() - p_.f + p_.r, Vec3::UnitZ()};
  }
  double nz = p_.sinBeta;
  double nxy = p_.cosBeta;
  double z = corner.z();
  if (beyond < p_.r * p_.cosBeta) {
    nxy = beyond / p_.r;
    nz = std::sqrt(1.0 - nxy * nxy);
    z += p_.r * nz - p_.f;
  } else if (p_.sinBeta > 0.0) {
    z += p_.r * nz - p_.f - (beyond - p_.r * nxy) * nxy / nz;
  } else {
    return std::nullopt;
  }
  return Touch{z, {-nxy * x / rho, -nxy * corner.y() / rho, nz}, corner.z() - z > p_.highest};
}

UprightTouch::PlaneTouch UprightTouch::onPlane(const UprightFacet& facet, double s) const {
  PlaneTouch result;
  const Vec3& n = facet.up;
  const double nxy = std::sqrt(n.x() * n.x() + n.y() * n.y());
  if (n.z() < p_.sinBeta || n.z() <= levelRise) {
    return result;
  }
  // The place of the cutter that looks against the normal.
  const double out = nxy > 0.0 ? p_.r + p_.e / nxy : 0.0;
  const double x = s - out * n.x();
  const double y = -out * n.y();
  // Corners run one way or the other when seen from above.
  const auto& c = facet.corners;
  const auto cross = [&](const Vec3& a, const Vec3& b) {
    return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
  };
  const double c0 = cross(c[0], c[1]);
  const double c1 = cross(c[1], c[2]);
  const double c2 = cross(c[2], c[0]);
  const double turn = c0 + c1 + c2 < 0.0 ? -1.0 : 1.0;
  result.outside =
      (turn * c0 < 0.0 ? 1U : 0U) | (turn * c1 < 0.0 ? 2U : 0U) | (turn * c2 < 0.0 ? 4U : 0U);
  if (result.outside == 0) {
    const double z = c[0].z() - ((x - c[0].x()) * n.x() + (y - c[0].y()) * n.y()) / n.z();
    result.touch = {z + p_.r * n.z() - p_.f, n};
  }
  return result;
}

/// The sine of the lean across an edge of the normal at which the corner arc has its place that far
/// beside the axis. `level`: how far from upright normals at right angles to the edge are at least.
///
/// With x for this sine that place is x (r + e / sqrt(level^2 + (1 - level^2) x^2)) beside the
/// axis, a concave function that rises: Newton steps from below stay below.
double UprightTouch::lean(double level, double beside) const {
  if (p_.e == 0.0) {
    return beside / p_.r;
  }
  const double l2 = level * level;
  const double k2 = 1.0 - l2;
  if (p_.r == 0.0) {
    return beside * level /
           std::sqrt(std::max(p_.e * p_.e - beside * beside * k2, l2 * p_.e * p_.e));
  }
  double x =
      std::max(beside * level / (p_.r * level + p_.e), (beside - p_.e / std::sqrt(k2)) / p_.r);
  for (int i = 0; i < newtonLimit; ++i) {
    const double squared = l2 + k2 * x * x;
    const double ring = p_.e / std::sqrt(squared);
    const double missing = beside - x * (p_.r + ring);
    const double step = missing / (p_.r + ring * l2 / squared);
    x += step;
    if (std::abs(missing) <= rest * beside || std::abs(step) <= lastStep * x) {
      break;
    }
  }
  return x;
}

std::optional<Touch> UprightTouch::onEdge(const Vec3& from, const Vec3& to, double s) const {
  const double dx = to.x() - from.x();
  const double dy = to.y() - from.y();
  const double dz = to.z() - from.z();
  const double length = std::sqrt(dx * dx + dy * dy);
  if (length <= levelRise * std::abs(dz)) {
    return onCorner(dz > 0.0 ? to : from, s);
  }
  // Along the edge as seen from above, and to its left; the axis lies `foot` along from its start.
  const double ux = dx / length;
  const double uy = dy / length;
  const double ax = from.x() - s;
  const double foot = -(ax * ux + from.y() * uy);
  const double side = from.y() * ux - ax * uy;  // of the edge, seen from the axis
  const double beside = std::abs(side);
  const double rise = dz / length;
  double along = 0.0;  // of the contact, from the foot
  Vec3 n;
  if (beside >= p_.e + p_.r && p_.sinBeta <= 0.0) {
    return std::nullopt;
  }
  if (std::abs(rise) <= levelRise && beside <= p_.e) {
    const double half = std::sqrt(p_.e * p_.e - beside * beside);
    if (foot + half < 0.0 || foot - half > length) {
      return onCorner(foot < 0.0 ? from : to, s);
    }
    return Touch{from.z() - p_.f + p_.r, Vec3::UnitZ()};
  }
  const double steep = 1.0 / std::sqrt(1.0 + rise * rise);
  const double level = std::abs(rise) * steep;
  const double x = lean(level, beside);
  const double upright = std::sqrt(std::max(0.0, 1.0 - x * x));
  if (x <= 1.0 && upright * steep >= p_.sinBeta) {
    const double n1 = -rise * upright * steep;  // along the edge
    const double n2 = side > 0.0 ? -x : x;      // to its left
    along = -(p_.r + p_.e / std::sqrt(n1 * n1 + n2 * n2)) * n1;
    n = {n1 * ux - n2 * uy, n1 * uy + n2 * ux, upright * steep};
  } else {
    const double steeper = p_.cosBeta * p_.cosBeta - rise * rise * p_.sinBeta * p_.sinBeta;
    if (p_.sinBeta <= 0.0) {
      return std::nullopt;
    }
    if (steeper <= 0.0) {
      return onCorner(dz > 0.0 ? to : from, s);
    }
    along = rise * beside * p_.sinBeta / std::sqrt(steeper);
    const double rho = std::sqrt(beside * beside + along * along);
    const double n1 = -p_.cosBeta * along / rho;
    const double n2 = -p_.cosBeta * side / rho;
    n = {n1 * ux - n2 * uy, n1 * uy + n2 * ux, p_.sinBeta};
  }
  const double at = foot + along;
  if (!(at >= 0.0 && at <= length)) {
    return onCorner(at < 0.0 ? from : to, s);
  }
  // On the plane through the edge with this normal.
  const double nxy = std::sqrt(std::max(0.0, 1.0 - n.z() * n.z()));
  const double z =
      (n.x() * ax + n.y() * from.y() + n.z() * from.z() + p_.support(n.z(), nxy)) / n.z();
  return Touch{z, n, from.z() + rise * at - z > p_.highest};
}

/// The height of the place that touches is a concave function over the triangle: where its greatest
/// value in the plane lies outside, that of the triangle is on an edge that this one looks at.
std::optional<Touch> UprightTouch::of(const UprightFacet& facet, double s) const {
  const PlaneTouch plane = onPlane(facet, s);
  if (plane.outside == 0) {
    return plane.touch;
  }
  std::optional<Touch> best;
  for (std::size_t k = 0; k < 3; ++k) {
    if ((plane.outside >> k & 1U) != 0) {
      const auto touch = onEdge(facet.corners[k], facet.corners[(k + 1) % 3], s);
      if (touch && (!best || touch->z > best->z)) {
        best = touch;
      }
    }
  }
  return best;
}

}  // namespace arelem::tool
