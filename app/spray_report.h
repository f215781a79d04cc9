#pragma once
#include <vector>

#include "app/pipeline.h"

#include "backend/film/picture.h"
#include "backend/report/spray.h"
#include "runtime/film/map.h"
#include "runtime/spray/sprayed.h"

namespace arelem::app {

/// What a SPRAY statement of the job amounts to. `map` may be null.
[[nodiscard]] backend::ReportedSpray reported(const Compilation& job,
                                              const spray::Sprayed& sprayed,
                                              const film::Map* map);
/// A map as a picture; both must live as long as it.
[[nodiscard]] backend::FilmPicture pictureOf(const spray::Sprayed& sprayed, const film::Map& map);

}  // namespace arelem::app
