#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "ir/diag/result.h"
#include "runtime/motion/course.h"

namespace arelem::motion {

/// Where the surfaces that guide a motion end.
class SurfaceEnds {
 public:
  /// `course` stays.
  explicit SurfaceEnds(const Course& course);

  /// Why the motion ends in a place of its path: behind it there is no surface to run along.
  [[nodiscard]] std::optional<Failure> passedAt(const PathPoint& last);

 private:
  /// A mesh with a border that guides the motion.
  struct Open {
    const NamedSurface* surface;
    std::size_t guide;
    double side;  ///< of the mesh, on which the motion begins
    /// Whether a contact with this normal on that side may be over the border: that is cheap.
    std::function<bool(const Vec3&, double)> mayBeOver;
    surface::Mesh::Hint hint{};
  };
  /// The cosine between the normal of a contact and that of the mesh there, and whether it may be
  /// over the border.
  struct Lean {
    double cosine = 0.0;
    bool mayBeOver = false;
  };
  static Lean leanOf(const tool::Contact& contact, Open& open);

  const Course& course_;
  std::vector<Open> open_;
};

}  // namespace arelem::motion
