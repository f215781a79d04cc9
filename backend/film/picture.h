#pragma once
#include <iosfwd>
#include <string>
#include <vector>

/// Pictures and tables of films: pure output, so the numbers come as they are.
namespace arelem::backend {

/// A film over square cells, row by row from the lowest y. Lengths mm.
struct FilmPicture {
  double lowX = 0.0, lowY = 0.0, cell = 1.0;
  std::size_t columns = 0, rows = 0;
  const std::vector<double>* film = nullptr;  ///< mm
  const std::vector<bool>* onWork = nullptr;
  double wanted = 0.0;  ///< mm
  std::string title;    ///< one line for people
  struct Stretch {
    double x1 = 0.0, y1 = 0.0, x2 = 0.0, y2 = 0.0;
    bool painting = true;
  };
  std::vector<Stretch> path;
  std::vector<std::vector<std::pair<double, double>>> outlines;
};

/// Color of a film relative to the wanted one, 0 to 255 each: blue is too thin, green right, red
/// too thick.
struct Color {
  unsigned char red = 0, green = 0, blue = 0;
};
[[nodiscard]] Color filmColor(double relative);

/// x,y,film,work of every cell, one a line, behind a heading.
void writeFilmCsv(std::ostream& out, const FilmPicture& picture);
/// One pixel a cell, with a scale below; false when the library fails.
[[nodiscard]] bool writeFilmPng(std::ostream& out, const FilmPicture& picture);
/// Bands of film with contour lines at the levels of the legend, outline and passes.
void writeFilmSvg(std::ostream& out, const FilmPicture& picture);

}  // namespace arelem::backend
