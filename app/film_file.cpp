#include "app/film_file.h"

#include <filesystem>
#include <sstream>

#include "app/view/raster.h"

namespace arelem::app {

namespace {
std::string suffixOf(const std::string& path) {
  return std::filesystem::path(path).extension().string();
}
}  // namespace

std::string objectionToFilms(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    const std::string suffix = suffixOf(path);
    if (suffix != ".png" && suffix != ".svg" && suffix != ".csv") {
      return "a film is written as .png, .svg or .csv, not as `" + path + "`";
    }
  }
  return "";
}

backend::FilmPicture pictureOf(const film::Map& map, double wanted) {
  backend::FilmPicture picture;
  picture.lowX = map.low.x();
  picture.lowY = map.low.y();
  picture.cell = map.cell;
  picture.columns = map.columns;
  picture.rows = map.rows;
  picture.film = &map.film;
  picture.onWork = &map.onWork;
  picture.wanted = wanted;
  return picture;
}

bool writeFilm(std::ostream& out, const std::string& path, const backend::FilmPicture& picture) {
  const std::string suffix = suffixOf(path);
  if (suffix == ".csv") {
    writeFilmCsv(out, picture);
    return true;
  }
  if (suffix == ".svg") {
    return writeFilmSvg(out, picture);
  }
  constexpr int width = 1400;  // pixels
  std::ostringstream svg;
  return writeFilmSvg(svg, picture) && writePng(out, svg.str(), width);
}

}  // namespace arelem::app
