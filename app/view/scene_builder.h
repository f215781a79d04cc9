#pragma once
#include "app/pipeline.h"

#include "backend/html/scene.h"

namespace arelem::app {

/// Carries a loaded and evaluated job through its motion and puts everything that the page shows
/// into the scene: path, times, proven deviations, surfaces, films, sources. What cannot be
/// computed is left out and named in the messages of the scene.
[[nodiscard]] backend::Scene buildScene(Compilation& job, const InterruptFlag& interrupted);

}  // namespace arelem::app
