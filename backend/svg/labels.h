#pragma once
#include <string>
#include <vector>

#include "backend/svg/canvas.h"

namespace arelem::backend::svg {

/// Places names where no other name stands, and beside the path where there is room for that; those
/// that find no room are left out.
class Labels {
 public:
  explicit Labels(const Box& area);

  /// A line that names better do not cover.
  void avoid(Pixel a, Pixel b);

  /// Tries the places in order; the first one that is free of lines, else the first one.
  void place(const std::string& words, const std::vector<Pixel>& candidates);
  void draw(Canvas& canvas) const;

  static constexpr std::size_t most = 80;

 private:
  struct Label {
    std::string words;
    Pixel at;
    Box box;
  };
  [[nodiscard]] bool isCrossed(const Box& box) const;

  Box area_;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<bool> crossed_;  ///< cells of the area that a line passes
  std::vector<Label> labels_;
};

}  // namespace arelem::backend::svg
