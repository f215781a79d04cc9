#include "backend/film/cell_picture.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "backend/svg/canvas.h"
#include "ir/space/spray_tolerance.h"

namespace arelem::backend {

namespace {
using svg::Box;
using svg::Canvas;
using svg::Pixel;

struct Corner {
  double x = 0.0, y = 0.0, value = 0.0;
};
using Polygon = std::vector<Corner>;

/// The part of a polygon whose values lie above (sign 1) or below (-1) a level.
Polygon cut(const Polygon& polygon, double level, double sign) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner& a = polygon[i];
    const Corner& b = polygon[(i + 1) % polygon.size()];
    const double from = sign * (a.value - level);
    const double to = sign * (b.value - level);
    if (from >= 0.0) {
      kept.push_back(a);
    }
    if ((from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0)) {
      const double t = from / (from - to);
      kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), level});
    }
  }
  return kept;
}

class Sheet {
 public:
  explicit Sheet(const CellPicture& picture) : picture_(picture) {
    for (const ShadedQuad& quad : picture.quads) {
      for (const auto& [x, y] : quad.corner) {
        lowX_ = std::min(lowX_, x);
        highX_ = std::max(highX_, x);
        lowY_ = std::min(lowY_, y);
        highY_ = std::max(highY_, y);
      }
    }
    if (picture.quads.empty()) {
      lowX_ = lowY_ = 0.0;
      highX_ = highY_ = 1.0;
    }
    scale_ = std::min(longest / std::max(highX_ - lowX_, tolerance::pictureExtent),
                      tallest / std::max(highY_ - lowY_, tolerance::pictureExtent));
  }

  void write(std::ostream& out) const {
    const double wide = std::max(scale_ * (highX_ - lowX_), 120.0);
    const double bands = rowHeight * (static_cast<double>(picture_.levels.size()) + 2.0);
    const double tall = std::max(scale_ * (highY_ - lowY_), bands);
    constexpr double letter = 6.6;  // pixels of the title's letters
    const double titleWidth = letter * static_cast<double>(picture_.title.size());
    Canvas canvas(out, 2.0 * margin + std::max(wide + legendWidth, titleWidth),
                  head + tall + margin);
    canvas.begin(picture_.title, picture_.legend);
    canvas.text({margin, 22.0}, picture_.title, "class=\"soft\"");
    for (std::size_t band = 0; band <= picture_.levels.size(); ++band) {
      shade(canvas, band);
    }
    for (const auto& way : picture_.path) {
      std::vector<Pixel> points;
      for (const auto& [x, y] : way) {
        points.push_back(at(x, y));
      }
      if (points.size() > 1) {
        canvas.polyline(points,
                        "fill=\"none\" stroke=\"#20242a\" stroke-width=\"0.5\" "
                        "stroke-dasharray=\"3 2\"");
      }
    }
    legend(canvas, 2.0 * margin + wide);
    canvas.end();
  }

 private:
  static constexpr double longest = 900.0;  // pixels
  static constexpr double tallest = 700.0;
  static constexpr double margin = 20.0;
  static constexpr double head = 36.0;
  static constexpr double legendWidth = 190.0;
  static constexpr double rowHeight = 20.0;

  [[nodiscard]] Pixel at(double x, double y) const {
    return {margin + scale_ * (x - lowX_), head + scale_ * (highY_ - y)};
  }
  [[nodiscard]] std::size_t bandOf(double value) const {
    return static_cast<std::size_t>(
        std::upper_bound(picture_.levels.begin(), picture_.levels.end(), value) -
        picture_.levels.begin());
  }
  /// Blue below the right value, red above it, the stronger the farther.
  [[nodiscard]] std::string color(std::size_t band) const {
    const std::vector<double>& levels = picture_.levels;
    const double low = band == 0 ? levels.front() : levels[band - 1];
    const double high = band == levels.size() ? levels.back() : levels[band];
    const double beyond = band == 0 ? -1.0 : band == levels.size() ? 1.0 : 0.0;
    const double span = std::max(levels.back() - picture_.middle, picture_.middle - levels.front());
    const double off = beyond != 0.0
                           ? beyond
                           : std::clamp((0.5 * (low + high) - picture_.middle) / span, -1.0, 1.0);
    const double strength = std::pow(std::abs(off), 0.7);
    const auto mixed = [&](double right, double wrong) {
      return static_cast<int>(std::lround(right + strength * (wrong - right)));
    };
    return off < 0.0
               ? fmt::format("#{:02x}{:02x}{:02x}", mixed(206, 30), mixed(232, 64), mixed(196, 160))
               : fmt::format("#{:02x}{:02x}{:02x}", mixed(206, 178), mixed(232, 32),
                             mixed(196, 38));
  }
  void shade(Canvas& canvas, std::size_t band) const {
    const std::string fill = color(band);
    // The stroke hides the seams between neighbors.
    const std::string attributes =
        fmt::format("fill=\"{0}\" stroke=\"{0}\" stroke-width=\"0.4\"", fill);
    for (const ShadedQuad& quad : picture_.quads) {
      const auto [least, most] = std::minmax_element(quad.value.begin(), quad.value.end());
      if (bandOf(*least) > band || bandOf(*most) < band) {
        continue;
      }
      Polygon polygon;
      for (std::size_t i = 0; i < quad.corner.size(); ++i) {
        polygon.push_back({quad.corner[i].first, quad.corner[i].second, quad.value[i]});
      }
      if (band > 0) {
        polygon = cut(polygon, picture_.levels[band - 1], 1.0);
      }
      if (band < picture_.levels.size()) {
        polygon = cut(polygon, picture_.levels[band], -1.0);
      }
      std::vector<Pixel> points;
      for (const Corner& corner : polygon) {
        points.push_back(at(corner.x, corner.y));
      }
      if (points.size() > 2) {
        points.push_back(points.front());
        canvas.polyline(points, attributes);
      }
    }
  }
  void legend(Canvas& canvas, double left) const {
    double y = head;
    canvas.text({left, y + 10.0}, picture_.legend, "");
    const std::vector<double>& levels = picture_.levels;
    for (std::size_t band = levels.size() + 1; band-- > 0;) {
      y += rowHeight;
      canvas.rectangle(
          Box{left, y, 16.0, 14.0},
          fmt::format("fill=\"{}\" stroke=\"#888\" stroke-width=\"0.5\"", color(band)));
      const int d = picture_.decimals;
      const std::string text =
          band == 0 ? fmt::format("below {:.{}f}", levels.front(), d)
          : band == levels.size()
              ? fmt::format("above {:.{}f}", levels.back(), d)
              : fmt::format("{:.{}f} to {:.{}f}", levels[band - 1], d, levels[band], d);
      canvas.text({left + 22.0, y + 11.0}, text, "");
    }
  }

  const CellPicture& picture_;
  double lowX_ = 1e300, highX_ = -1e300, lowY_ = 1e300, highY_ = -1e300;
  double scale_ = 1.0;
};
}  // namespace

void writeCellsSvg(std::ostream& out, const CellPicture& picture) {
  Sheet(picture).write(out);
}

}  // namespace arelem::backend
