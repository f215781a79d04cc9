#pragma once
#include "runtime/tool/placed_body.h"

namespace arelem::tool {

/// One triangle, its corners counter-clockwise about its unit normal.
struct Facet {
  const Vec3& a;
  const Vec3& b;
  const Vec3& c;
  Vec3 up;

  static Facet of(const Vec3& a, const Vec3& b, const Vec3& c) {
    return {a, b, c, (b - a).cross(c - a).normalized()};
  }
  [[nodiscard]] double lowest(const Vec3& direction) const {
    return std::min({direction.dot(a), direction.dot(b), direction.dot(c)});
  }
};

/// The least signed distance of any point of a triangle to the body of a cutter: negative by how
/// deep the triangle is inside. With a fixed axis and a convex cutter it is a convex function of
/// the tool end, as it is the least of a function that is convex in both.
struct TriangleGap {
  double gap = 0.0;
  Vec3 normal = Vec3::UnitZ();   ///< unit, from the triangle to the cutter; along the gradient
  Vec3 onCutter = Vec3::Zero();  ///< the contact
  /// Of a convex cutter: with its tool end moved by m the gap is at least low + slope.m (with the
  /// same axis). That touches the gap here but for rounding.
  double low = 0.0;
  Vec3 slope = Vec3::Zero();
  /// Where a sharp edge of the cutter is inside, `slope` is a mixture of two unit normals: `share`
  /// of one, the rest of `other`. Else it is a unit normal itself.
  Vec3 other = Vec3::Zero();
  double share = 1.0;
};

/// The contact is searched in the plane of the triangle (closed forms but for cutters that are
/// deeper inside than their corner is round), at its corners and along its edges.
[[nodiscard]] TriangleGap gapOf(const PlacedBody& body, const Facet& triangle);
/// The same, but a gap above `enough` is not told exactly: only that it is above, with a tangent
/// that is right.
[[nodiscard]] TriangleGap gapOf(const PlacedBody& body, const Facet& triangle, double enough);

/// A tangent of the gap below it (see TriangleGap) from one measured distance.
struct GapTangent {
  double low = 0.0;
  Vec3 slope = Vec3::Zero();
};
[[nodiscard]] GapTangent tangentBelow(const PlacedBody& body, const Facet& triangle);

}  // namespace arelem::tool
