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

  /// Why the motion ends in a place of its path: behind it there is no surface to run along, or the
  /// tool has come round the border of a mesh to its back, on the other side than it was to be.
  [[nodiscard]] std::optional<Failure> passedAt(const PathPoint& last);
  /// The cause of a failure: a tool that went over the border of an open mesh goes round it or down
  /// beside it. That it did so is no fault of a motion that meets its check surface.
  [[nodiscard]] Failure causeOf(Failure failure);

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
  [[nodiscard]] std::optional<Failure> overBorder(const PathPoint& last);

  const Course& course_;
  std::vector<Open> open_;
  std::optional<Failure> over_;
};

}  // namespace arelem::motion
