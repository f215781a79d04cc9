#pragma once
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "backend/svg/view.h"

namespace arelem::backend::svg {

/// A part of a curve: straight, or with a radius along an arc of less than half a turn, clockwise
/// as it is seen or not. Of the first piece only the place counts: the curve begins there.
struct PathPiece {
  Pixel to;
  double radius = 0.0;
  bool clockwise = false;
};

/// Writes SVG elements. Coordinates have two decimals; text is escaped here and nowhere else.
class Canvas {
 public:
  Canvas(std::ostream& out, double width, double height)
      : out_(out), width_(width), height_(height) {}

  /// The head with title, description and styles, and the white background.
  void begin(std::string_view title, std::string_view description);
  void end();

  /// `attributes` is written as it is: our own text, never the user's.
  void line(Pixel a, Pixel b, std::string_view attributes);
  void circle(Pixel center, double radius, std::string_view attributes);
  void rectangle(const Box& box, std::string_view attributes);
  void polyline(const std::vector<Pixel>& points, std::string_view attributes);
  /// A polyline where no piece is an arc.
  void curve(const std::vector<PathPiece>& pieces, std::string_view attributes);
  void text(Pixel at, std::string_view words, std::string_view attributes);
  /// The bytes of a PNG file, stretched over a box.
  void image(const Box& box, std::string_view png);
  /// A group that shows nothing outside the box.
  void beginClip(const Box& box, int id);
  void endGroup();

 private:
  std::string number(double value) const;
  std::ostream& out_;
  double width_, height_;
};

}  // namespace arelem::backend::svg
