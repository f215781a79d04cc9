#include "runtime/motion/facets/upright_bounds.h"

#include <algorithm>
#include <limits>

namespace arelem::motion {

namespace {
/// Normals that bound heights are not nearer to level than this, as a sine.
constexpr double mostLevel = 0.97;
/// Triangles within this share of the cutter's radius are covered by it.
constexpr double covered = 0.98;
constexpr double nowhere = -std::numeric_limits<double>::infinity();
}  // namespace

UprightBounds::UprightBounds(const tool::UprightProfile& profile, double radius)
    : profile_(profile),
      radius_(radius),
      flattest_(profile.r > 0.0         ? std::min(mostLevel, profile.cosBeta)
                : profile.sinBeta > 0.0 ? profile.cosBeta
                                        : 0.0) {}

UprightBounds::Normal UprightBounds::normalTowards(double x, double y) const {
  const double squared = x * x + y * y;
  if (squared <= profile_.e * profile_.e || flattest_ <= 0.0) {
    return {};
  }
  const double rho = std::sqrt(squared);
  const double beyond = rho - profile_.e;
  const double nxy = beyond < profile_.r * flattest_ ? beyond / profile_.r : flattest_;
  const double share = -nxy / rho;
  return {{share * x, share * y, std::sqrt(1.0 - nxy * nxy)}, nxy};
}

UprightBounds::Normal UprightBounds::normalTowards(double x, double y, const Vec3& up) const {
  if (flattest_ > 0.0 || up.z() < usefulRise) {
    return normalTowards(x, y);
  }
  const double fall = up.x() * x + up.y() * y;
  if (fall >= 0.0) {
    return {};
  }
  const double squared = x * x + y * y;
  const double rise = -fall / up.z();  // outwards, by the distance
  const double nz = 1.0 / std::sqrt(1.0 + rise * rise / squared);
  const double share = -rise / squared * nz;
  return Normal::of({share * x, share * y, nz});
}

bool UprightBounds::isBeside(const tool::UprightFacet& facet, double middle, double half) const {
  const auto& c = facet.corners;
  const double x = (c[0].x() + c[1].x() + c[2].x()) / 3.0 - middle;
  const double y = (c[0].y() + c[1].y() + c[2].y()) / 3.0;
  const double axis = std::clamp(x, -half, half);
  const double out = x - axis;
  const double squared = out * out + y * y;
  if (squared <= radius_ * radius_) {
    return false;
  }
  const double from = out * (middle + axis);
  const double nearest = std::min({out * c[0].x() + y * c[0].y(), out * c[1].x() + y * c[1].y(),
                                   out * c[2].x() + y * c[2].y()}) -
                         from;
  return nearest > 0.0 && nearest * nearest > radius_ * radius_ * squared;
}

bool UprightBounds::covers(const tool::UprightFacet& facet, double middle, double half) const {
  const double inside = covered * covered * radius_ * radius_;
  return std::all_of(facet.corners.begin(), facet.corners.end(), [&](const Vec3& corner) {
    const double x = std::abs(corner.x() - middle) + half;
    return x * x + corner.y() * corner.y() <= inside;
  });
}

/// Where the circle around the cutter, which moves along s, comes to the triangle and leaves it: at
/// corners, or as a tangent of edges.
UprightBounds::Range UprightBounds::rangeOf(const tool::UprightFacet& facet) const {
  Range range{-nowhere, nowhere};
  const auto& c = facet.corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& from = c[k];
    const double chord = radius_ * radius_ - from.y() * from.y();
    if (chord >= 0.0) {
      const double half = std::sqrt(chord);
      range.first = std::min(range.first, from.x() - half);
      range.last = std::max(range.last, from.x() + half);
    }
    const Vec3 edge = c[(k + 1) % 3] - from;
    const double reach = radius_ / std::sqrt(edge.x() * edge.x() + edge.y() * edge.y());
    const double beside = edge.y() < 0.0 ? reach * edge.x() : -reach * edge.x();
    const double ahead = (beside - from.y()) / edge.y();
    if (ahead >= 0.0 && ahead <= 1.0) {
      range.first = std::min(range.first, from.x() + ahead * edge.x() - reach * std::abs(edge.y()));
    }
    const double behind = (-beside - from.y()) / edge.y();
    if (behind >= 0.0 && behind <= 1.0) {
      range.last = std::max(range.last, from.x() + behind * edge.x() + reach * std::abs(edge.y()));
    }
  }
  return range;
}

}  // namespace arelem::motion
