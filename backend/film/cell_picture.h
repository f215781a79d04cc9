#pragma once
#include <array>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

/// Contour pictures of quantities that are known at the corners of cells of any shape. Pure output.
namespace arelem::backend {

struct ShadedQuad {
  std::array<std::pair<double, double>, 4> corner;  ///< one after another round it, mm
  std::array<double, 4> value{};
};

struct CellPicture {
  std::string title;
  std::string legend;          ///< what the values are: "film over the mean film"
  std::vector<double> levels;  ///< borders of the bands, rising
  double middle = 1.0;         ///< the value that is right: green; below blue, above red
  int decimals = 2;            ///< of the legend
  std::vector<ShadedQuad> quads;
  std::vector<std::vector<std::pair<double, double>>> path;  ///< of the gun, drawn thin
};

/// The quads cut into bands at the levels: contours are straight within a quad and meet between
/// quads that share their corners' values. SVG.
void writeCellsSvg(std::ostream& out, const CellPicture& picture);

}  // namespace arelem::backend
