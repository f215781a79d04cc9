#pragma once
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

/// Pictures and tables of films: pure output, so the numbers come as they are.
namespace arelem::backend {

/// A film over square cells, row by row from the lowest y. Lengths mm.
struct FilmPicture {
  double lowX = 0.0, lowY = 0.0, cell = 1.0;
  std::size_t columns = 0, rows = 0;
  const std::vector<double>* film = nullptr;  ///< mm
  const std::vector<bool>* onWork = nullptr;
  const std::vector<double>* areas = nullptr;  ///< of the work in each cell, mm2; null: all alike
  double wanted = 0.0;                         ///< mm
  bool relative = false;                       ///< films are shares of `wanted`, not thicknesses
  std::string title;                           ///< one line for people
  std::string details;                         ///< a second one
  std::string xName = "x, mm", yName = "y, mm";
  /// Borders of the bands, relative to the wanted film, rising; below the first there is none.
  std::vector<double> levels = {0.05, 0.25, 0.5, 0.75, 0.9, 1.1, 1.25, 1.5, 2.0};

  using Line = std::vector<std::pair<double, double>>;
  struct Stretch {
    double x1 = 0.0, y1 = 0.0, x2 = 0.0, y2 = 0.0;
    bool painting = true;
  };
  std::vector<Stretch> path;
  std::vector<Line> outlines;  ///< of the work, closed by themselves
  std::vector<Line> offsets;   ///< where the gun is switched, closed by themselves
};

/// x, y, film, work of every cell, one a line, behind a heading.
void writeFilmCsv(std::ostream& out, const FilmPicture& picture);

/// Bands of film with contour lines between them, the outline, the passes, axes in mm, and a legend
/// that tells the share of the work in each band. Cells are put together to at most 1000 in the
/// longer way. SVG with the bands as an embedded PNG; false when the library of that fails.
[[nodiscard]] bool writeFilmSvg(std::ostream& out, const FilmPicture& picture);

}  // namespace arelem::backend
