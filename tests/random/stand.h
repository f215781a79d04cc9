#pragma once
#include <string_view>

#include "tests/random/motion.h"
#include "tests/random/scene.h"

namespace arelem::scenes {

/// True where a tool can go from one stop straight to the other and keeps at the same gaps all the
/// way: those to the surfaces that guide it within their band, that to the check surface within
/// `share` of it. Then both are where the tolerance has the stop, however far they lie apart: where
/// a path meets its check surface flatly, or its two surfaces each other, that may be many bands.
/// `stop` is the end of a run of the scene as it was drawn, `other` is that of the scene moved,
/// moved back; names of check surfaces begin with `check`.
struct Stand {
  Vec3 place, axis;
};
[[nodiscard]] bool isOneStop(const Scene& scene,
                             const Work& work,
                             std::string_view check,
                             double share,
                             const Stand& stop,
                             const Stand& other);

}  // namespace arelem::scenes
