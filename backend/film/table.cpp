#include <ostream>

#include <fmt/format.h>

#include "backend/film/picture.h"

namespace arelem::backend {

void writeFilmCsv(std::ostream& out, const FilmPicture& p) {
  out << "x_mm,y_mm,film_mm,work\n";
  for (std::size_t r = 0; r < p.rows; ++r) {
    for (std::size_t c = 0; c < p.columns; ++c) {
      const std::size_t i = r * p.columns + c;
      out << fmt::format("{},{},{},{}\n", p.lowX + p.cell * (static_cast<double>(c) + 0.5),
                         p.lowY + p.cell * (static_cast<double>(r) + 0.5), (*p.film)[i],
                         (*p.onWork)[i] ? 1 : 0);
    }
  }
}

}  // namespace arelem::backend
