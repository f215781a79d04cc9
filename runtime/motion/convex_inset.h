#pragma once
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Dense>

namespace arelem::motion {

using Vec2 = Eigen::Vector2d;

/// A convex polygon whose sides all move inwards by the same distance. Sides that vanish are left
/// out.
class ConvexInset {
 public:
  /// `vertices` counterclockwise, at least three, without a straight angle.
  explicit ConvexInset(std::span<const Vec2> vertices);

  /// The vertices with all sides moved inwards by `distance`, in the order given; the first one is
  /// the image of the first vertex. None where nothing is left.
  [[nodiscard]] std::optional<std::vector<Vec2>> at(double distance) const;

  /// Largest distance at which something is left: the radius of the largest circle inside.
  [[nodiscard]] double depth() const { return depth_; }

 private:
  struct Side {
    Vec2 normal;  ///< inwards, of unit length
    double offset;
  };
  std::vector<Side> sides_;
  double depth_ = 0.0;
};

/// Distance of a point outside to a convex polygon, 0 inside.
[[nodiscard]] double distanceTo(std::span<const Vec2> polygon, const Vec2& p);

}  // namespace arelem::motion
