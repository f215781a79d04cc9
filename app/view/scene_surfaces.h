#pragma once
#include "app/pipeline.h"

#include "backend/html/scene.h"

namespace arelem::app {

/// Adds meshes of the surfaces that motions run along or to, each once, within the box of the path.
void addMeshes(const Compilation& job, backend::Scene& scene, const InterruptFlag& interrupted);

/// Adds the films of the SPRAY statements and the gun.
void addFilms(const Compilation& job, backend::Scene& scene);

/// Adds the films of the stencils: over their mean, each stroke for itself.
void addStencilFilms(const Compilation& job, backend::Scene& scene);

/// A line below the title that no diagnostic tells.
void addNote(backend::Scene& scene, std::string text);

/// Millimeters of the unit of the scene.
[[nodiscard]] double millimetersOf(const backend::Scene& scene);

}  // namespace arelem::app
