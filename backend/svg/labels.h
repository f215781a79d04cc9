#pragma once
#include <string>
#include <vector>

#include "backend/svg/canvas.h"

namespace arelem::backend::svg {

/// Names beside what they name. All lines are told first; then each name goes where it covers the
/// least of them and no other name. Names that find no room are left out.
class Labels {
 public:
  explicit Labels(const Box& area);

  /// What a name should not cover, the heavier the less.
  enum class Line : unsigned char { geometry = 1, path = 6 };
  void avoid(Pixel a, Pixel b, Line line);
  /// A name beside one of these places, the earlier the better.
  void add(const std::string& words, std::vector<Pixel> anchors, bool wrong = false);
  /// The same along a curve.
  void addAlong(const std::string& words, const std::vector<Pixel>& curve);
  void draw(Canvas& canvas) const;

  static constexpr std::size_t most = 80;

 private:
  struct Request {
    std::string words;
    std::vector<Pixel> anchors;
    bool wrong = false;
  };
  [[nodiscard]] unsigned cost(const Box& box) const;

  Box area_;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<unsigned char> crossed_;  ///< cells of the area: the heaviest line that passes
  std::vector<Request> requests_;
};

}  // namespace arelem::backend::svg
