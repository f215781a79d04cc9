// The picture of a film: bands of color with contours, the work and the passes on them, axes, and a
// legend with the share of each band.
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "backend/film/grid.h"
#include "backend/film/png.h"
#include "backend/html/base64.h"
#include "backend/svg/canvas.h"
#include "backend/svg/scale.h"

namespace arelem::backend {

namespace {
using svg::Box;
using svg::Canvas;
using svg::Pixel;
using svg::Scale;

constexpr double longest = 900.0;  // pixels of the plot
constexpr double tallest = 700.0;
constexpr double shortest = 60.0;
constexpr double left = 64.0, head = 74.0, foot = 46.0, legendWidth = 230.0, gap = 24.0;
constexpr double rowHeight = 20.0;
constexpr double fineness = 2.0;  // pixels of the bands in one of the page
constexpr double pale = 0.4;      // how much of its color is left beside the work

struct Stop {
  double relative;
  Color color;
};
/// Thin is blue, right is green, thick is red; light where it is right, so that it prints in gray.
constexpr std::array stops = {Stop{0.0, {24, 42, 110}},    Stop{0.5, {58, 118, 196}},
                              Stop{0.8, {139, 190, 219}},  Stop{0.95, {198, 228, 204}},
                              Stop{1.05, {198, 228, 190}}, Stop{1.2, {250, 222, 140}},
                              Stop{1.5, {236, 140, 66}},   Stop{2.2, {168, 24, 32}}};

unsigned char mixed(unsigned char a, unsigned char b, double share) {
  return static_cast<unsigned char>(std::lround(a + share * (b - a)));
}

Color mixed(const Color& a, const Color& b, double share) {
  return {mixed(a.red, b.red, share), mixed(a.green, b.green, share), mixed(a.blue, b.blue, share)};
}

Color shade(double relative) {
  for (std::size_t i = 1; i < stops.size(); ++i) {
    if (relative <= stops[i].relative) {
      const Stop& a = stops[i - 1];
      const Stop& b = stops[i];
      return mixed(a.color, b.color,
                   std::max(0.0, (relative - a.relative) / (b.relative - a.relative)));
    }
  }
  return stops.back().color;
}

class Sheet {
 public:
  Sheet(std::ostream& out, const FilmPicture& picture)
      : picture_(picture),
        grid_(picture),
        width_(picture.cell * static_cast<double>(picture.columns)),
        height_(picture.cell * static_cast<double>(picture.rows)),
        scale_(std::min(longest / width_, tallest / height_)),
        plot_{left, head, std::max(width_ * scale_, shortest),
              std::max(height_ * scale_, shortest)},
        canvas_(out,
                std::max(left + plot_.width + gap + legendWidth, titleWidth()),
                std::max(head + plot_.height + foot, head + legendHeight())) {
    for (std::size_t band = 0; band <= picture.levels.size(); ++band) {
      colors_.push_back(colorOf(band));
    }
  }

  bool write() {
    canvas_.begin(picture_.title, picture_.details);
    canvas_.text({left, 26.0}, picture_.title, "class=\"title\"");
    canvas_.text({left, 46.0}, picture_.details, "class=\"soft\"");
    const std::string png = bands();
    if (png.empty()) {
      return false;
    }
    canvas_.image(plot_, png);
    canvas_.beginClip(plot_, 1);
    for (const double level : picture_.levels) {
      for (const FilmPicture::Line& line : grid_.contour(level)) {
        polyline(line, false,
                 "fill=\"none\" stroke=\"#20242a\" stroke-opacity=\"0.45\" stroke-width=\"0.6\"");
      }
    }
    work();
    canvas_.endGroup();
    axes();
    legend(left + plot_.width + gap);
    canvas_.end();
    return true;
  }

 private:
  static constexpr std::string_view edgeStyle =
      "fill=\"none\" stroke=\"#111\" stroke-width=\"1.6\"";
  static constexpr std::string_view offsetStyle =
      "fill=\"none\" stroke=\"#7a3fb0\" stroke-width=\"1\" stroke-dasharray=\"6 4\"";
  static constexpr std::string_view onStyle =
      "fill=\"none\" stroke=\"#111\" stroke-width=\"0.9\" stroke-opacity=\"0.75\"";
  static constexpr std::string_view offStyle =
      "fill=\"none\" stroke=\"#555\" stroke-width=\"0.9\" stroke-dasharray=\"2 3\"";

  [[nodiscard]] double titleWidth() const {
    constexpr double letter = 6.4, titleLetter = 10.0;
    return left + std::max(titleLetter * static_cast<double>(picture_.title.size()),
                           letter * static_cast<double>(picture_.details.size()));
  }
  [[nodiscard]] double legendHeight() const {
    return rowHeight * (static_cast<double>(picture_.levels.size()) + 7.0);
  }
  [[nodiscard]] Pixel at(double x, double y) const {
    return {plot_.left + plot_.width * (x - picture_.lowX) / width_,
            plot_.top + plot_.height * (1.0 - (y - picture_.lowY) / height_)};
  }
  [[nodiscard]] std::size_t bandOf(double relative) const {
    const std::vector<double>& levels = picture_.levels;
    return static_cast<std::size_t>(std::upper_bound(levels.begin(), levels.end(), relative) -
                                    levels.begin());
  }
  [[nodiscard]] Color colorOf(std::size_t band) const {
    const std::vector<double>& levels = picture_.levels;
    if (band == 0) {
      return {255, 255, 255};
    }
    return shade(band < levels.size() ? (levels[band - 1] + levels[band]) / 2.0
                                      : 1.2 * levels.back());
  }

  /// The bands as an image, finer than the page.
  [[nodiscard]] std::string bands() const {
    const auto wide = static_cast<std::size_t>(std::ceil(plot_.width * fineness));
    const auto tall = static_cast<std::size_t>(std::ceil(plot_.height * fineness));
    std::vector<Color> pixels;
    pixels.reserve(wide * tall);
    for (std::size_t r = 0; r < tall; ++r) {
      const double y = picture_.lowY +
                       height_ * (1.0 - (static_cast<double>(r) + 0.5) / static_cast<double>(tall));
      for (std::size_t c = 0; c < wide; ++c) {
        const double x =
            picture_.lowX + width_ * (static_cast<double>(c) + 0.5) / static_cast<double>(wide);
        const FilmGrid::Sample sample = grid_.sample(x, y);
        const Color& color = colors_[bandOf(sample.film)];
        pixels.push_back(sample.onWork ? color : mixed({255, 255, 255}, color, pale));
      }
    }
    return pngOf(pixels, wide);
  }

  void polyline(const FilmPicture::Line& line, bool closed, std::string_view style) {
    std::vector<Pixel> points;
    for (const auto& [x, y] : line) {
      points.push_back(at(x, y));
    }
    if (closed && !points.empty()) {
      points.push_back(points.front());
    }
    canvas_.polyline(points, style);
  }

  void work() {
    for (const FilmPicture::Stretch& s : picture_.path) {
      canvas_.line(at(s.x1, s.y1), at(s.x2, s.y2), s.painting ? onStyle : offStyle);
    }
    for (const FilmPicture::Line& curve : picture_.offsets) {
      polyline(curve, true, offsetStyle);
    }
    for (const FilmPicture::Line& outline : picture_.outlines) {
      polyline(outline, true, edgeStyle);
    }
  }

  void axes() {
    canvas_.rectangle(plot_, "fill=\"none\" stroke=\"#888\"");
    const double bottom = plot_.top + plot_.height;
    const Scale x(picture_.lowX, picture_.lowX + width_, std::max(plot_.width / 90.0, 2.0));
    for (double v = x.firstTick(); v <= x.high; v += x.step) {
      const Pixel p = at(v, picture_.lowY);
      canvas_.line({p.x, bottom}, {p.x, bottom + 5.0}, "stroke=\"#888\"");
      canvas_.text({p.x, bottom + 18.0}, x.text(v), "text-anchor=\"middle\"");
    }
    const Scale y(picture_.lowY, picture_.lowY + height_, std::max(plot_.height / 60.0, 2.0));
    for (double v = y.firstTick(); v <= y.high; v += y.step) {
      const Pixel p = at(picture_.lowX, v);
      canvas_.line({plot_.left - 5.0, p.y}, {plot_.left, p.y}, "stroke=\"#888\"");
      canvas_.text({plot_.left - 8.0, p.y + 3.5}, y.text(v), "text-anchor=\"end\"");
    }
    canvas_.text({plot_.left + plot_.width, bottom + 36.0}, picture_.xName,
                 "text-anchor=\"end\" class=\"soft\"");
    canvas_.text({plot_.left, plot_.top - 8.0}, picture_.yName, "class=\"soft\"");
  }

  /// Shares of the work in the bands.
  [[nodiscard]] std::vector<double> shares() const {
    std::vector<double> sums(picture_.levels.size() + 1, 0.0);
    double whole = 0.0;
    for (std::size_t i = 0; i < picture_.film->size(); ++i) {
      if ((*picture_.onWork)[i]) {
        const double area = picture_.areas != nullptr ? (*picture_.areas)[i] : 1.0;
        sums[bandOf((*picture_.film)[i] / picture_.wanted)] += area;
        whole += area;
      }
    }
    for (double& sum : sums) {
      sum = whole > 0.0 ? 100.0 * sum / whole : 0.0;
    }
    return sums;
  }

  void legend(double x) {
    double y = head + 8.0;
    canvas_.text({x, y}, picture_.relative ? "film over its mean" : "film, um", "");
    canvas_.text({x + legendWidth - 30.0, y}, "of the work", "text-anchor=\"end\"");
    const std::vector<double>& levels = picture_.levels;
    const std::vector<double> parts = shares();
    const double um = picture_.relative ? 1.0 : 1e3 * picture_.wanted;
    for (std::size_t band = levels.size() + 1; band-- > 0;) {
      y += rowHeight;
      const Color& c = colors_[band];
      canvas_.rectangle({x, y - 11.0, 16.0, 14.0},
                        fmt::format("fill=\"#{:02x}{:02x}{:02x}\" stroke=\"#777\" "
                                    "stroke-width=\"0.6\"",
                                    c.red, c.green, c.blue));
      const std::string text =
          band == 0 ? fmt::format("below {:.3g}", um * levels[0])
          : band == levels.size()
              ? fmt::format("above {:.3g}", um * levels.back())
              : fmt::format("{:.3g} to {:.3g}", um * levels[band - 1], um * levels[band]);
      canvas_.text({x + 24.0, y}, text, "");
      canvas_.text({x + legendWidth - 30.0, y}, fmt::format("{:.1f} %", parts[band]),
                   "text-anchor=\"end\"");
    }
    y += 0.5 * rowHeight;
    const bool offs = std::any_of(picture_.path.begin(), picture_.path.end(),
                                  [](const auto& s) { return !s.painting; });
    entry(x, y, !picture_.outlines.empty(), edgeStyle, "edge of the work");
    entry(x, y, !picture_.path.empty(), onStyle, "passes, gun on");
    entry(x, y, offs, offStyle, "gun off");
    entry(x, y, !picture_.offsets.empty(), offsetStyle, "where the gun is switched");
  }
  void entry(double x, double& y, bool there, std::string_view style, std::string_view text) {
    if (there) {
      y += rowHeight;
      canvas_.line({x, y - 4.0}, {x + 26.0, y - 4.0}, style);
      canvas_.text({x + 34.0, y}, text, "");
    }
  }

  const FilmPicture& picture_;
  FilmGrid grid_;
  double width_, height_, scale_;
  Box plot_;
  Canvas canvas_;
  std::vector<Color> colors_;
};
}  // namespace

bool writeFilmSvg(std::ostream& out, const FilmPicture& picture) {
  return Sheet(out, picture).write();
}

}  // namespace arelem::backend
