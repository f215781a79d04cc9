#pragma once
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "backend/svg/path.h"
#include "backend/svg/writer.h"

namespace arelem::backend::svg {

/// A place on the page, in pixels from the upper left corner.
struct Pixel {
  double x = 0.0;
  double y = 0.0;
};

struct Box {
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
};

/// One orthographic view: coordinate `across` runs to the right, `up` upwards, and one looks
/// against `depth`.
struct View {
  std::string_view name;
  int across = 0, up = 1, depth = 2;
  Box box;                          ///< on the page
  double scale = 1;                 ///< pixels a unit
  double left = 0.0, bottom = 0.0;  ///< coordinates of the box's lower left corner

  [[nodiscard]] Pixel operator()(const Vec3& p) const { return place(p[across], p[up]); }
  [[nodiscard]] Pixel place(double a, double u) const {
    return {box.left + (a - left) * scale, box.top + box.height - (u - bottom) * scale};
  }
  [[nodiscard]] double right() const { return left + box.width / scale; }
  [[nodiscard]] double top() const { return bottom + box.height / scale; }
  /// The part of the line  a * across + b * up = d  in the box, in coordinates of the view.
  [[nodiscard]] std::optional<std::array<Eigen::Vector2d, 2>> clip(double a,
                                                                   double b,
                                                                   double d) const;
};

/// Where the views, the title and the legend stand on the page.
struct Layout {
  double width = 800.0;
  double height = 600.0;
  std::vector<View> views;  ///< the plan first
  Box legend;
  std::optional<Box> solid;  ///< where three views leave room for the path seen at an angle
};

/// One view for a path in a plane, else plan, front and side with one scale (third-angle order:
/// front below the plan, side to the right of the front; the corner between them shows the path at
/// an angle). `bounds` is what has to be seen.
/// `views` asks for one of them, or for all.
[[nodiscard]] Layout arrange(const Bounds& path,
                             const Bounds& bounds,
                             PictureViews views = PictureViews::automatic);

}  // namespace arelem::backend::svg
