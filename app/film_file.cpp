#include "app/film_file.h"

#include <filesystem>
#include <sstream>

#include "app/view/raster.h"

namespace arelem::app {

bool writeFilm(std::ostream& out, const std::string& path, const backend::FilmPicture& picture) {
  const std::string suffix = std::filesystem::path(path).extension().string();
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
