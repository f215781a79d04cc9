#include "runtime/motion/convex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "ir/diag/pocket.h"
#include "ir/space/tolerance.h"
#include "runtime/spline/bezier.h"

namespace arelem::motion {

namespace {
/// Corners nearer than this are one, directions nearer than this are parallel: the old system's
/// test. Part unit, and dimensionless.
constexpr double same = 0.0005;
constexpr double degreesOfARadian = 180.0 / std::numbers::pi;

/// A corner, and which side of the first polygon leaves it.
struct Corner {
  Vec3 place;
  std::size_t side = 0;
};

/// What is left of a convex polygon on the inner side of a line; the cut is side `side`.
std::vector<Corner> clip(const std::vector<Corner>& polygon,
                         const Vec3& inward,
                         double least,
                         std::size_t side) {
  std::vector<Corner> left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner& a = polygon[i];
    const Corner& b = polygon[(i + 1) % polygon.size()];
    const double da = inward.dot(a.place) - least;
    const double db = inward.dot(b.place) - least;
    if (da >= 0.0) {
      left.push_back(a);
    }
    if ((da >= 0.0) != (db >= 0.0)) {
      const Vec3 cut = a.place + da / (da - db) * (b.place - a.place);
      left.push_back({cut, da >= 0.0 ? side : a.side});
    }
  }
  return left;
}

/// Without sides that have become points.
std::vector<Corner> withoutShort(const std::vector<Corner>& polygon, double size) {
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& next = polygon[(i + 1) % polygon.size()].place;
    if ((next - polygon[i].place).norm() > tolerance::symmetric * size) {
      kept.push_back(polygon[i]);
    }
  }
  return kept;
}
}  // namespace

Result<ConvexPolygon> ConvexPolygon::make(std::vector<Vec3> corners) {
  const std::size_t n = corners.size();
  std::vector<Vec3> along;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i + 1; k < n; ++k) {
      const double apart = (corners[k] - corners[i]).norm();
      if (apart <= same) {
        return fail(diag::PocketDuplicate, i + 1, k + 1, apart);
      }
    }
    along.push_back((corners[(i + 1) % n] - corners[i]).normalized());
  }
  ConvexPolygon polygon;
  polygon.normal_ = along[0].cross(along[1]).normalized();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const Vec3 turn = along[i].cross(along[next]);
    if (turn.norm() <= same) {
      return fail(diag::PocketInLine, i + 1, next + 1, (i + 2) % n + 1);
    }
    const double off = std::abs(polygon.normal_.dot(corners[i] - corners[1]));
    if (off > same) {
      return fail(diag::PocketNotPlane, i + 1, off);
    }
    if (turn.dot(polygon.normal_) < 0.0) {
      const double inside =
          180.0 + degreesOfARadian * std::atan2(turn.norm(), along[i].dot(along[next]));
      return fail(diag::PocketConcave, next + 1, inside);
    }
  }
  polygon.corners_ = std::move(corners);
  return polygon;
}

std::optional<std::vector<Vec3>> ConvexPolygon::inset(double distance) const {
  return clipped(distance, normal_);
}

std::optional<ConvexPolygon> ConvexPolygon::between(double distance, const Vec3& up) const {
  auto corners = clipped(distance, up);
  if (!corners) {
    return std::nullopt;
  }
  ConvexPolygon left;
  left.corners_ = *std::move(corners);
  left.normal_ = normal_;
  return left;
}

std::optional<std::vector<Vec3>> ConvexPolygon::clipped(double distance, const Vec3& up) const {
  if (distance == 0.0) {
    return corners_;  // a clip by its own sides would depend on rounding
  }
  const std::size_t n = corners_.size();
  std::vector<Corner> polygon;
  double size = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    polygon.push_back({corners_[i], i});
    size = std::max(size, (corners_[i] - corners_[0]).norm());
  }
  for (std::size_t i = 0; i < n && polygon.size() >= 3; ++i) {
    const Vec3 along = (corners_[(i + 1) % n] - corners_[i]).normalized();
    const Vec3 inward = up.cross(along).normalized();
    polygon = clip(polygon, inward, inward.dot(corners_[i]) + distance, i);
  }
  polygon = withoutShort(polygon, size);
  if (polygon.size() < 3) {
    return std::nullopt;
  }
  const auto first =
      std::min_element(polygon.begin(), polygon.end(),
                       [](const Corner& a, const Corner& b) { return a.side < b.side; });
  std::rotate(polygon.begin(), first, polygon.end());
  std::vector<Vec3> places;
  for (const Corner& corner : polygon) {
    places.push_back(corner.place);
  }
  return places;
}

double outside(const std::vector<Vec3>& corners, const Vec3& normal, const Vec3& place) {
  bool inside = true;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3& a = corners[i];
    const Vec3& b = corners[(i + 1) % corners.size()];
    inside = inside && (b - a).cross(place - a).dot(normal) >= 0.0;
    least = std::min(least, spline::distanceToSegment(place, a, b));
  }
  return inside ? 0.0 : least;
}

double sharpestSine(const std::vector<Vec3>& corners) {
  const std::size_t n = corners.size();
  double least = 1.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 in = (corners[(i + 1) % n] - corners[i]).normalized();
    const Vec3 out = (corners[(i + 2) % n] - corners[(i + 1) % n]).normalized();
    least = std::min(least, std::sqrt(std::max(0.0, (1.0 + in.dot(out)) / 2.0)));
  }
  return least;
}

bool isNarrow(const std::vector<Vec3>& corners, double distance) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 along = (corners[(i + 1) % n] - corners[i]).normalized();
    if (std::all_of(corners.begin(), corners.end(), [&](const Vec3& p) {
          return (p - corners[i]).cross(along).norm() <= distance;
        })) {
      return true;
    }
  }
  return false;
}

std::optional<std::size_t> coveringSide(const std::vector<Vec3>& corners, double distance) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (std::all_of(corners.begin(), corners.end(), [&](const Vec3& p) {
          return spline::distanceToSegment(p, corners[i], corners[(i + 1) % n]) <= distance;
        })) {
      return i;
    }
  }
  return std::nullopt;
}

}  // namespace arelem::motion
