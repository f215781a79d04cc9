#pragma once
#include "backend/film/picture.h"

namespace arelem::backend {

/// The film of a picture relative to the wanted one, over cells that were put together so that the
/// picture stays small. Values belong to the middles of cells.
class FilmGrid {
 public:
  explicit FilmGrid(const FilmPicture& picture);

  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] double at(std::size_t column, std::size_t row) const {
    return film_[row * columns_ + column];
  }
  [[nodiscard]] bool onWork(std::size_t column, std::size_t row) const {
    return work_[row * columns_ + column];
  }
  [[nodiscard]] double x(double column) const { return lowX_ + cell_ * (column + 0.5); }
  [[nodiscard]] double y(double row) const { return lowY_ + cell_ * (row + 0.5); }

  /// The film at a place (mm), straight between the middles of cells that are on the work, or
  /// beside it, as the cell of the place is.
  struct Sample {
    double film = 0.0;
    bool onWork = false;
  };
  [[nodiscard]] Sample sample(double x, double y) const;

  /// Lines of one film over the work, joined end to end.
  [[nodiscard]] std::vector<FilmPicture::Line> contour(double level) const;

 private:
  double lowX_ = 0.0, lowY_ = 0.0, cell_ = 1.0;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<double> film_;
  std::vector<bool> work_;
};

}  // namespace arelem::backend
