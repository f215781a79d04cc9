#pragma once
#include <ostream>
#include <string>
#include <vector>

#include "backend/film/picture.h"
#include "runtime/film/map.h"

namespace arelem::app {

/// Why films cannot be written to these files; "" where they can.
[[nodiscard]] std::string objectionToFilms(const std::vector<std::string>& paths);

/// The picture of a map, still without a title; the map must outlive it.
[[nodiscard]] backend::FilmPicture pictureOf(const film::Map& map, double wanted);

/// A film as the suffix of the path says: .png, .svg, .csv. False when the picture cannot be made.
[[nodiscard]] bool writeFilm(std::ostream& out,
                             const std::string& path,
                             const backend::FilmPicture& picture);

}  // namespace arelem::app
