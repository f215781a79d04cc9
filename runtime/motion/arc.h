#pragma once
#include <cstdint>
#include <vector>

#include "runtime/geometry/kinds/cylinder.h"
#include "runtime/tool/contact.h"

namespace arelem::motion {

/// An arc of the tool end about a vertical axis, divided evenly (spec 4.8, rule of the plane
/// route): the vertices stand on the band's larger radius at the odd half steps, then the exact end
/// follows.
struct ArcPlan {
  double centerX = 0.0, centerY = 0.0, z = 0.0;
  double radius = 0.0;          ///< of the vertices
  double startAngle = 0.0;      ///< radians
  double halfStep = 0.0;        ///< radians, signed
  std::uint64_t halfSteps = 2;  ///< even

  [[nodiscard]] Vec3 vertex(std::uint64_t k) const;
  [[nodiscard]] Vec3 tangent(std::uint64_t k) const;
};

/// `walked` holds tool ends along the whole arc, from its start to its end, less than half a turn
/// apart. `start` is the contact with the circle at the start; inner and outer are its tolerances.
[[nodiscard]] ArcPlan planArc(const surface::Cylinder& circle,
                              const std::vector<Vec3>& walked,
                              const tool::Contact& start,
                              double inner,
                              double outer);

}  // namespace arelem::motion
