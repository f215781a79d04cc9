#pragma once
#include <string>

#include "tests/random/motion.h"
#include "tests/random/scene.h"

namespace arelem::scenes {

/// What an independent search says of a refusal.
struct Review {
  bool confirmed = false;  ///< it finds no such motion either
  std::string objection;   ///< it finds one: where
};

/// Looks whether a scene that was refused has a motion, by means of its own: for a startup every
/// place of a grid, for a motion short steps along the two gaps, without lengths, bands or proofs.
/// It tells nothing (neither confirmed nor objected) of scenes that it cannot judge: axes that
/// turn, rings, several check surfaces, tangencies, and where its own steps get stuck.
[[nodiscard]] Review review(const Scene& scene, const Work& work, const Motion& refused);

}  // namespace arelem::scenes
