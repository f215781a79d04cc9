#include "runtime/path/affine.h"

#include <array>
#include <cmath>

#include <Eigen/LU>

#include "runtime/geometry/angle.h"

namespace arelem::path {

namespace {

void moveMotion(cl::Motion& motion, const Affine& by) {
  using Way = cl::Motion::Way;
  if (motion.isArc() && by.linear.determinant() < 0.0) {  // a mirror turns it round
    motion.way = motion.way == Way::clockwise ? Way::counterclockwise : Way::clockwise;
  }
  const std::size_t stride = motion.stride();
  for (std::size_t i = 0; i + stride <= motion.coordinates.size(); i += stride) {
    Eigen::Map<Vec3> point(&motion.coordinates[i]);
    point = by.point(point);
    for (std::size_t k = 3; k < stride; k += 3) {
      Eigen::Map<Vec3> direction(&motion.coordinates[i + k]);
      direction = by.direction(direction);
    }
  }
}

/// CNTRL/x,y,z of a spline.
void moveControl(cl::Post& post, const Affine& by) {
  std::array<double*, 3> places{};
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = i < post.arguments.size() ? std::get_if<double>(&post.arguments[i]) : nullptr;
    if (places[i] == nullptr) {
      return;
    }
  }
  const Vec3 moved = by.point({*places[0], *places[1], *places[2]});
  for (int i = 0; i < 3; ++i) {
    *places[static_cast<std::size_t>(i)] = moved[i];
  }
}

void moveCircle(cl::Surface& circle, const Affine& by) {
  std::vector<double>& c = circle.surface.canon;
  const bool round =
      circle.surface.type == EntityType::circle || circle.surface.type == EntityType::cylinder;
  if (!round || c.size() != 7) {
    return;
  }
  Eigen::Map<Vec3> center(c.data());
  center = by.point(center);
  Eigen::Map<Vec3> axis(&c[3]);
  axis = by.direction(axis);
  c[6] *= std::cbrt(std::abs(by.linear.determinant()));
}

void moveSpline(cl::Surface& spline, const Affine& by) {
  std::vector<double>& c = spline.surface.canon;
  const auto points = static_cast<std::size_t>(c[1]);
  for (std::size_t i = c.size() - 3 * points; i + 2 < c.size(); i += 3) {
    Eigen::Map<Vec3> point(&c[i]);
    point = by.point(point);
  }
}

}  // namespace

Affine Affine::fromRows(std::span<const double> m) {
  Affine a;
  a.linear << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
  a.shift = {m[3], m[7], m[11]};
  return a;
}

Affine Affine::translation(const Vec3& by) {
  return {Eigen::Matrix3d::Identity(), by};
}

Affine Affine::rotation(double degrees) {
  const auto [s, c] = geometry::sinCosDegrees(degrees);
  Affine a;
  a.linear << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  return a;
}

Vec3 Affine::direction(const Vec3& v) const {
  const Vec3 moved = linear * v;
  const double length = moved.norm();
  return length > 0.0 ? Vec3(moved / length) : v;
}

void move(cl::Record& record, const Affine& by) {
  if (auto* motion = std::get_if<cl::Motion>(&record.body)) {
    moveMotion(*motion, by);
  } else if (auto* surface = std::get_if<cl::Surface>(&record.body)) {
    surface->surface.type == EntityType::pathSpline ? moveSpline(*surface, by)
                                                    : moveCircle(*surface, by);
  } else if (auto* post = std::get_if<cl::Post>(&record.body); post && post->foreign == "CNTRL") {
    moveControl(*post, by);
  }
}

}  // namespace arelem::path
