#pragma once
#include <string>
#include <vector>

#include "backend/svg/canvas.h"

namespace arelem::backend::svg {

/// Places names where no other name stands; those that find no room are left out.
class Labels {
 public:
  explicit Labels(const Box& area) : area_(area) {}

  /// Tries the places in order.
  void place(const std::string& words, const std::vector<Pixel>& candidates);
  void draw(Canvas& canvas) const;

  static constexpr std::size_t most = 80;

 private:
  struct Label {
    std::string words;
    Pixel at;
    Box box;
  };
  Box area_;
  std::vector<Label> labels_;
};

}  // namespace arelem::backend::svg
