#pragma once
#include <optional>
#include <vector>

#include "ir/diag/result.h"
#include "runtime/geometry/tabulated_cylinder.h"

/// Places of a TABCYL that satisfy a condition, for POINT, LINE and CIRCLE definitions. The
/// TABCYL's generatrix must be z: these constructions are of the xy plane.
namespace arelem::define {

struct CurvePlace {
  std::size_t interval = 0;
  double t = 0.0;
  geometry::CurvePoint at;  ///< in xy
};

/// A TABCYL seen in the xy plane.
class CurveInXy {
 public:
  [[nodiscard]] static Result<CurveInXy> of(const Entity& tabcyl);

  [[nodiscard]] const std::vector<geometry::TabulatedCylinder::Interval>& intervals() const {
    return surface_.intervals;
  }
  [[nodiscard]] CurvePlace place(std::size_t interval, double t) const;

  /// Places on the line normal . p = distance.
  [[nodiscard]] std::vector<CurvePlace> onLine(const geometry::Line& line) const;
  /// Places whose tangent passes through `from`.
  [[nodiscard]] std::vector<CurvePlace> tangentThrough(const geometry::Vec2& from) const;
  /// Places whose normal passes through `from`.
  [[nodiscard]] std::vector<CurvePlace> normalThrough(const geometry::Vec2& from) const;

  /// Which place is meant: the near point names the defining point just before it, so places of the
  /// interval that starts at the nearest defining point come first, then those of the intervals
  /// around; within one interval, the nearest.
  [[nodiscard]] std::optional<CurvePlace> select(const std::vector<CurvePlace>& places,
                                                 const geometry::Vec2& nearPoint) const;

 private:
  explicit CurveInXy(geometry::TabulatedCylinder surface) : surface_(std::move(surface)) {}

  geometry::TabulatedCylinder surface_;  ///< with the frame x, y, z
};

}  // namespace arelem::define
