#pragma once
#include <algorithm>
#include <cmath>

#include "runtime/geometry/kinds.h"
#include "runtime/tool/profile.h"

namespace arelem::motion {

/// How fast a tool that does not turn may come to a surface along a straight line: what steps along
/// it may not pass.
///
/// No distance rises faster than that of a point infinitely far along the line, where only the
/// directions in which the surface goes on for ever count: along the lines of a cylinder nothing
/// changes, and of a cone only the angle to it counts. Outside a convex solid the gap of a convex
/// cutter is a convex function of the way, and of any cutter inside it a concave one: the way to
/// zero is at least that at the present slope.
class CheckPace {
 public:
  /// `cutter` null: the tool end alone.
  CheckPace(const surface::AnySurface& surface, const tool::Profile* cutter);

  /// The most that a signed distance, or the gap on its side, changes per length.
  [[nodiscard]] double most(const Vec3& direction) const {
    const double rises = rising(direction);
    return kind_ == Kind::cone ? std::max(rises, rising(-direction)) : rises;
  }
  /// By how much a gap comes nearer to zero per length, from here to where it is zero. `side`: of
  /// the surface, where the gap is; `slope`: that of the gap in the direction.
  [[nodiscard]] double closing(double side, double gap, double slope, const Vec3& direction) const;

 private:
  /// Of the signed distance, per length in a unit direction.
  [[nodiscard]] double rising(const Vec3& direction) const;

  enum class Kind : unsigned char { any, plane, lines, cone };
  Kind kind_ = Kind::any;
  Vec3 along_ = Vec3::Zero();  ///< normal of the plane, direction of the lines, axis of the cone
  double cosHalf_ = 1.0, sinHalf_ = 0.0;  ///< of the cone
  bool convex_ = false;                   ///< the solid on the negative side
  bool convexCutter_ = true;
};

inline double CheckPace::rising(const Vec3& direction) const {
  const double cosine = along_.dot(direction);
  switch (kind_) {
    case Kind::plane:
      return std::abs(cosine);
    case Kind::lines:
      return std::min(1.0, (direction - cosine * along_).norm());
    case Kind::cone: {
      const double sine = (direction - cosine * along_).norm();
      const bool besides = cosine * cosHalf_ + sine * sinHalf_ >= 0.0;
      return besides ? std::max(0.0, sine * cosHalf_ - cosine * sinHalf_) : 1.0;
    }
    case Kind::any:
      break;
  }
  return 1.0;
}

}  // namespace arelem::motion
