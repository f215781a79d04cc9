#include "runtime/region/region.h"

#include <algorithm>
#include <cmath>

#include "ir/diag/spray.h"
#include "ir/space/spray_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/exact_polygon.h"
#include "runtime/geometry/nesting.h"
#include "runtime/spray/outline.h"

namespace arelem::region {

using spray::Loop;
using spray::Outline;
using spray::Vec2;

namespace {
/// Twice the area that a loop spans, as a vector along its normal (Newell).
Vec3 spanned(const Corners& corners) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
  }
  return sum;
}

Vec3 pointingUp(const Vec3& normal) {
  for (const int i : {2, 1, 0}) {
    if (std::abs(normal[i]) > tolerance::symmetric) {
      return normal[i] > 0.0 ? normal : Vec3(-normal);
    }
  }
  return normal;
}

/// A corner given twice in a row, or the first again at the end, is one corner.
void dropRepeats(Corners& corners) {
  const auto same = [](const Vec3& a, const Vec3& b) {
    return (a - b).norm() <= tolerance::coincidence;
  };
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  while (corners.size() > 1 && same(corners.front(), corners.back())) {
    corners.pop_back();
  }
}

std::string textOf(const Vec3& p) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", p.x(), p.y(), p.z());
}

std::optional<Failure> objectionToRole(Boundary::Role role, std::size_t number, std::size_t depth) {
  const bool even = depth % 2 == 0;
  if (role == Boundary::Role::hole && even) {
    return fail(diag::HoleOutside, "hole", number, depth == 0 ? "no outline" : "another hole");
  }
  if (role == Boundary::Role::island && !even) {
    return fail(diag::HoleOutside, "island", number, "no hole");
  }
  if (role == Boundary::Role::outline && depth > 0) {
    return fail(diag::HoleOutside, "outline", number, "the region itself");
  }
  return std::nullopt;
}

/// Normal of the widest triangle with the first corner and the one farthest from it: a bow tie
/// whose loops cancel spans no area, but has a plane.
Vec3 widestTriangle(const std::vector<Boundary>& boundaries) {
  const Vec3& first = boundaries[0].corners[0];
  Vec3 farthest = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
  for (const bool base : {true, false}) {
    for (const Boundary& b : boundaries) {
      for (const Vec3& p : b.corners) {
        const Vec3 arm = p - first;
        const Vec3 square = farthest.cross(arm);
        if (base && arm.norm() > farthest.norm()) {
          farthest = arm;
        } else if (!base && square.norm() > normal.norm()) {
          normal = square;
        }
      }
    }
  }
  return normal;
}

/// Names the corner that is to blame: the farthest from the plane of three corners in which most of
/// the others lie, an upright or level plane before others.
Failure notPlanar(const std::vector<Boundary>& boundaries, double allowed) {
  constexpr std::size_t planes = 64;  // that are tried
  std::vector<Vec3> all;
  for (const Boundary& b : boundaries) {
    all.insert(all.end(), b.corners.begin(), b.corners.end());
  }
  const std::size_t n = all.size();
  std::pair<std::size_t, double> most = {0, 0.0};
  std::pair<double, std::size_t> stray = {0.0, 0};
  for (std::size_t k = 0; k < std::min(planes, n); ++k) {
    const std::size_t first = k * n / std::min(planes, n);
    const Vec3& place = all[first];
    const Vec3 square = (all[(first + 1) % n] - place).cross(all[(first + 2) % n] - place);
    if (square.norm() == 0.0) {
      continue;
    }
    const Vec3 normal = square.normalized();
    std::size_t near = 0;
    std::pair<double, std::size_t> farthest = {0.0, 0};
    for (std::size_t i = 0; i < n; ++i) {
      const double off = std::abs(normal.dot(all[i] - place));
      near += off <= allowed ? 1 : 0;
      farthest = std::max(farthest, std::pair(off, i));
    }
    const std::pair score = {near, normal.cwiseAbs().maxCoeff()};
    if (score > most) {
      most = score;
      stray = farthest;
    }
  }
  return fail(diag::RegionNotPlanar, textOf(all[stray.second]), stray.first, allowed);
}

/// The common normal and the distance of every corner from the common plane.
Result<Vec3> planeOf(const std::vector<Boundary>& boundaries) {
  Vec3 normal = Vec3::Zero();
  double size = 0.0;
  for (const Boundary& b : boundaries) {
    const Vec3 own = spanned(b.corners);
    normal = own.norm() > normal.norm() ? own : normal;
    for (const Vec3& p : b.corners) {
      size = std::max(size, (p - boundaries[0].corners[0]).norm());
    }
  }
  if (!(normal.norm() > tolerance::similarity * size * size)) {
    normal = widestTriangle(boundaries);
  }
  if (!(normal.norm() > tolerance::singular * size * size)) {
    return fail(diag::RegionWithoutArea, normal.norm() / 2.0);
  }
  normal = pointingUp(normal.normalized());
  const Vec3& origin = boundaries[0].corners[0];
  for (const Boundary& b : boundaries) {
    for (const Vec3& p : b.corners) {
      const double off = normal.dot(p - origin);
      if (std::abs(off) > tolerance::regionPlane * std::max(size, 1.0)) {
        const double allowed = tolerance::regionPlane * std::max(size, 1.0);
        return notPlanar(boundaries, allowed);
      }
    }
  }
  return normal;
}

/// The same boundary twice, wherever it begins and however it runs.
bool sameCorners(Corners a, Corners b) {
  const auto before = [](const Vec3& p, const Vec3& q) {
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  };
  std::sort(a.begin(), a.end(), before);
  std::sort(b.begin(), b.end(), before);
  return a == b;
}

Failure crossing(const Region& region, const Frame& frame, const geometry::Meeting& m) {
  if (m.polygon != m.otherPolygon &&
      sameCorners(region.loops[m.polygon], region.loops[m.otherPolygon])) {
    return fail(diag::RegionTwice, m.polygon + 1, m.otherPolygon + 1,
                textOf(region.loops[m.polygon].front()));
  }
  Failure failure = fail(diag::RegionCrosses, m.edge + 1, m.polygon + 1, m.otherEdge + 1,
                         m.otherPolygon + 1, textOf(frame.inSpace(m.place)));
  if (region.loops.size() == 1) {
    return failure;
  }
  return std::move(failure).note(fmt::format(
      "the region has {} boundaries, counted in the order of the text", region.loops.size()));
}
}  // namespace

std::vector<double> Region::canon() const {
  std::vector<double> values = {normal.x(), normal.y(), normal.z(),
                                static_cast<double>(loops.size())};
  for (const Corners& loop : loops) {
    values.push_back(static_cast<double>(loop.size()));
    for (const Vec3& p : loop) {
      values.insert(values.end(), p.begin(), p.end());
    }
  }
  return values;
}

bool Region::readable(std::span<const double> canon) {
  if (canon.size() < 4 ||
      std::abs(Vec3(canon[0], canon[1], canon[2]).norm() - 1.0) > tolerance::similarity) {
    return false;
  }
  std::size_t at = 4;
  double loops = 0.0;
  while (at < canon.size()) {
    const double corners = canon[at];
    if (!(corners >= 3.0) || corners != std::floor(corners) ||
        corners * 3.0 > static_cast<double>(canon.size() - at - 1)) {
      return false;
    }
    at += 1 + 3 * static_cast<std::size_t>(corners);
    ++loops;
  }
  return loops > 0.0 && canon[3] == loops;
}

Region Region::of(std::span<const double> canon) {
  Region region;
  region.normal = {canon[0], canon[1], canon[2]};
  std::size_t at = 4;
  while (at < canon.size()) {
    const auto count = static_cast<std::size_t>(canon[at++]);
    Corners& loop = region.loops.emplace_back();
    for (std::size_t i = 0; i < count; ++i, at += 3) {
      loop.emplace_back(canon[at], canon[at + 1], canon[at + 2]);
    }
  }
  return region;
}

Result<Region> regionOf(std::vector<Boundary> boundaries) {
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    for (const Vec3& corner : boundaries[i].corners) {
      if (!(corner.cwiseAbs().maxCoeff() <= tolerance::farthestCorner)) {
        return fail(diag::RegionFar, textOf(corner), tolerance::farthestCorner);
      }
    }
    dropRepeats(boundaries[i].corners);
    if (boundaries[i].corners.size() < 3) {
      return fail(diag::RegionCorners, i + 1, boundaries[i].corners.size());
    }
  }
  Result<Vec3> normal = planeOf(boundaries);
  if (!normal) {
    return normal.takeFailure();
  }
  Region region;
  region.normal = *normal;
  for (Boundary& b : boundaries) {
    region.loops.push_back(b.corners);
  }
  const Flat flat = flattened(region, 1.0);
  const spray::Extent extent = spray::extentOf(flat.outline);
  const double touch = tolerance::similarity * (extent.high - extent.low).norm();
  if (const auto meeting = geometry::firstMeeting(flat.outline.loops, touch)) {
    return crossing(region, flat.frame, *meeting);
  }
  const std::vector<std::size_t> depths = geometry::nestingDepths(flat.outline.loops);
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    const std::size_t depth = depths[i];
    if (auto failure = objectionToRole(boundaries[i].role, i + 1, depth)) {
      return *std::move(failure);
    }
    const bool counterclockwise = spray::areaOf({{flat.outline.loops[i]}}) > 0.0;
    if (counterclockwise != (depth % 2 == 0)) {
      std::reverse(region.loops[i].begin(), region.loops[i].end());
    }
  }
  return region;
}

Frame frameOf(const Vec3& normal, const Vec3& somePlace) {
  Frame frame;
  frame.normal = normal;
  const Vec3 inPlane = Vec3::UnitX() - normal.x() * normal;
  frame.x = inPlane.norm() > tolerance::nullDirection
                ? inPlane.normalized()
                : (Vec3::UnitY() - normal.y() * normal).normalized().eval();
  frame.y = normal.cross(frame.x);
  frame.origin = normal.dot(somePlace) * normal;
  return frame;
}

Flat flattened(const Region& region, double scale) {
  Flat flat;
  flat.frame = frameOf(region.normal, region.loops.front().front());
  for (const Corners& corners : region.loops) {
    Loop& loop = flat.outline.loops.emplace_back();
    for (const Vec3& p : corners) {
      loop.push_back(flat.frame.inPlane(p) * scale);
    }
  }
  return flat;
}

}  // namespace arelem::region
