#pragma once
#include <ostream>
#include <string>

#include "backend/film/picture.h"

namespace arelem::app {

/// A film as the suffix of the path says: .png, .svg, .csv. False when the picture cannot be made.
[[nodiscard]] bool writeFilm(std::ostream& out,
                             const std::string& path,
                             const backend::FilmPicture& picture);

}  // namespace arelem::app
