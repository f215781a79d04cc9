#pragma once
#include <optional>
#include <string>
#include <vector>

#include "backend/svg/canvas.h"

namespace arelem::backend::svg {

/// Names beside what they name. All lines are told first; then each name goes where it covers the
/// least of them and no other name. Names that find no room where they can be read are left out,
/// and of an array only some elements are named.
class Labels {
 public:
  explicit Labels(const Box& area);

  /// What a name should not cover, the heavier the less.
  enum class Line : unsigned char { geometry = 1, path = 6 };
  void avoid(Pixel a, Pixel b, Line line);
  /// A name beside one of these places, the earlier the better.
  void add(const std::string& words, std::vector<Pixel> anchors);
  /// The same of an element of an array.
  void addElement(const std::string& array, const std::string& words, const Pixel& anchor);
  /// Words about a fault, which go before all names.
  void addFirst(const std::string& words, const Pixel& anchor);
  /// The same along a curve.
  void addAlong(const std::string& words, const std::vector<Pixel>& curve);
  /// The names that found no room.
  std::vector<std::string> draw(Canvas& canvas);
  [[nodiscard]] const std::vector<std::string>& drawn() const { return drawn_; }

  static constexpr std::size_t most = 400;

 private:
  struct Request {
    std::string words;
    std::vector<Pixel> anchors;
    bool wrong = false;
    std::string array;
  };
  struct Place {
    Pixel at;
    unsigned cost = 0;
  };
  /// The best place of a name that no box of `taken` covers.
  [[nodiscard]] std::optional<Place> placeOf(const Request& request,
                                             const std::vector<Box>& taken) const;
  [[nodiscard]] unsigned cost(const Box& box) const;

  Box area_;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<unsigned char> crossed_;  ///< cells of the area: the heaviest line that passes
  std::vector<Request> requests_;
  std::vector<std::string> drawn_;
};

}  // namespace arelem::backend::svg
