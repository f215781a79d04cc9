#pragma once
#include <string>

#include "ir/diag/result.h"
#include "ir/geometry/entity.h"
#include "ir/space/vector.h"

namespace arelem::geometry {

/// How far two entities are apart.
struct Apart {
  double distance = 0.0;  ///< between the nearest places, part unit; 0 where they meet
  bool places = false;    ///< whether `from` and `to` are set
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  ///< nearest places of the first and of the second
  std::string remark;                           ///< "they cross at 30 degrees", "inside", or ""
};

/// Points, lines and planes, circles and cylinders, spheres against each other; a point or a sphere
/// against every surface, a point against a path spline. A LINE is the vertical plane that it
/// stands for and a CIRCLE the vertical cylinder. Fails with E0341 for other pairs.
[[nodiscard]] Result<Apart> apart(const Entity& first, const Entity& second);

}  // namespace arelem::geometry
