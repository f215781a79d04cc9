#pragma once
#include "runtime/motion/field.h"

namespace arelem::motion {

/// How the tool axis follows from the tool position: fixed, or normal to the part or drive surface.
struct AxisRule {
  Vec3 fixed = Vec3::UnitZ();
  Field* normalTo = nullptr;  ///< an ON field of the surface, null for a fixed axis

  [[nodiscard]] Vec3 at(const Vec3& toolEnd) const {
    return normalTo == nullptr ? fixed : normalTo->at(toolEnd, fixed).normal;
  }
};

}  // namespace arelem::motion
