#include "backend/film/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

#include <fmt/format.h>

namespace arelem::backend {

namespace {
struct Stop {
  double relative;
  Color color;
};
constexpr std::array stops = {Stop{0.0, {40, 40, 110}},   Stop{0.5, {50, 110, 200}},
                              Stop{0.9, {110, 190, 170}}, Stop{1.0, {90, 170, 80}},
                              Stop{1.1, {190, 200, 90}},  Stop{1.5, {235, 140, 50}},
                              Stop{2.0, {180, 30, 30}}};
/// Borders of the bands of the picture, relative to the wanted film.
constexpr std::array levels = {0.05, 0.25, 0.5, 0.75, 0.9, 1.1, 1.25, 1.5, 2.0};
constexpr std::size_t mostSvgCells = 260;
constexpr double legendWidth = 130.0;

unsigned char mixed(unsigned char a, unsigned char b, double share) {
  return static_cast<unsigned char>(std::lround(a + share * (b - a)));
}

std::size_t bandOf(double relative) {
  return static_cast<std::size_t>(std::upper_bound(levels.begin(), levels.end(), relative) -
                                  levels.begin());
}

std::string bandColor(std::size_t band) {
  if (band == 0) {
    return "#ffffff";
  }
  const double low = levels[band - 1];
  const double middle = band < levels.size() ? (low + levels[band]) / 2.0 : low;
  const Color c = filmColor(middle);
  return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue);
}

/// Cells put together so that the picture stays small; their film is the mean.
struct Coarse {
  std::size_t columns = 0, rows = 0;
  double cell = 1.0;
  std::vector<double> relative;
};
Coarse coarse(const FilmPicture& p) {
  const std::size_t step = (std::max(p.columns, p.rows) + mostSvgCells - 1) / mostSvgCells;
  Coarse c;
  c.columns = (p.columns + step - 1) / step;
  c.rows = (p.rows + step - 1) / step;
  c.cell = p.cell * static_cast<double>(step);
  c.relative.assign(c.columns * c.rows, 0.0);
  std::vector<double> counts(c.relative.size(), 0.0);
  for (std::size_t r = 0; r < p.rows; ++r) {
    for (std::size_t k = 0; k < p.columns; ++k) {
      const std::size_t i = r / step * c.columns + k / step;
      c.relative[i] += (*p.film)[r * p.columns + k] / p.wanted;
      counts[i] += 1.0;
    }
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    c.relative[i] /= counts[i];
  }
  return c;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return result;
}

void bands(std::ostream& out, const FilmPicture& p, const Coarse& c, double top) {
  for (std::size_t r = 0; r < c.rows; ++r) {
    std::size_t from = 0;
    while (from < c.columns) {
      const std::size_t band = bandOf(c.relative[r * c.columns + from]);
      std::size_t to = from + 1;
      while (to < c.columns && bandOf(c.relative[r * c.columns + to]) == band) {
        ++to;
      }
      if (band > 0) {
        const double y = p.lowY + c.cell * static_cast<double>(r);
        out << fmt::format(
            "<rect x=\"{:.6g}\" y=\"{:.6g}\" width=\"{:.6g}\" height=\"{:.6g}\" "
            "fill=\"{}\"/>\n",
            p.lowX + c.cell * static_cast<double>(from), top - y - c.cell,
            c.cell * static_cast<double>(to - from) + 0.02 * c.cell, 1.02 * c.cell,
            bandColor(band));
      }
      from = to;
    }
  }
}

/// Contour lines of one level by marching squares between the middles of cells.
void contour(std::ostream& out, const FilmPicture& p, const Coarse& c, double level, double top) {
  std::string path;
  const auto value = [&](std::size_t k, std::size_t r) { return c.relative[r * c.columns + k]; };
  for (std::size_t r = 0; r + 1 < c.rows; ++r) {
    for (std::size_t k = 0; k + 1 < c.columns; ++k) {
      const std::array<double, 4> v = {value(k, r), value(k + 1, r), value(k + 1, r + 1),
                                       value(k, r + 1)};
      constexpr std::array<std::array<double, 2>, 4> corner = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
      std::vector<std::array<double, 2>> cuts;
      for (std::size_t e = 0; e < 4; ++e) {
        const std::size_t f = (e + 1) % 4;
        if ((v[e] < level) != (v[f] < level)) {
          const double t = (level - v[e]) / (v[f] - v[e]);
          cuts.push_back({corner[e][0] + t * (corner[f][0] - corner[e][0]),
                          corner[e][1] + t * (corner[f][1] - corner[e][1])});
        }
      }
      for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
        for (std::size_t end : {i, i + 1}) {
          path +=
              fmt::format("{}{:.5g} {:.5g}", end == i ? "M" : "L",
                          p.lowX + c.cell * (static_cast<double>(k) + 0.5 + cuts[end][0]),
                          top - p.lowY - c.cell * (static_cast<double>(r) + 0.5 + cuts[end][1]));
        }
      }
    }
  }
  if (!path.empty()) {
    out << fmt::format(
        "<path d=\"{}\" fill=\"none\" stroke=\"#333\" stroke-width=\"{:.4g}\" "
        "stroke-opacity=\"0.5\"/>\n",
        path, c.cell * 0.25);
  }
}

void lines(std::ostream& out, const FilmPicture& p, double top) {
  for (const FilmPicture::Stretch& s : p.path) {
    out << fmt::format(
        "<line x1=\"{:.6g}\" y1=\"{:.6g}\" x2=\"{:.6g}\" y2=\"{:.6g}\" stroke=\"{}\" "
        "stroke-width=\"1\" vector-effect=\"non-scaling-stroke\"{}/>\n",
        s.x1, top - s.y1, s.x2, top - s.y2, s.painting ? "#111" : "#888",
        s.painting ? "" : " stroke-dasharray=\"4 3\"");
  }
  for (const auto& outline : p.outlines) {
    out << "<polygon fill=\"none\" stroke=\"#000\" stroke-width=\"2\" "
           "vector-effect=\"non-scaling-stroke\" points=\"";
    for (const auto& [x, y] : outline) {
      out << fmt::format("{:.6g},{:.6g} ", x, top - y);
    }
    out << "\"/>\n";
  }
}

void legend(std::ostream& out, const FilmPicture& p, double height) {
  double y = 30.0;
  out << fmt::format("<text x=\"8\" y=\"{}\">film, um</text>\n", y);
  for (std::size_t band = levels.size() + 1; band-- > 1;) {
    y += 22.0;
    const std::string text =
        band < levels.size() ? fmt::format("{:.4g} to {:.4g}", 1e3 * p.wanted * levels[band - 1],
                                           1e3 * p.wanted * levels[band])
                             : fmt::format("above {:.4g}", 1e3 * p.wanted * levels.back());
    out << fmt::format(
        "<rect x=\"8\" y=\"{}\" width=\"16\" height=\"16\" fill=\"{}\" stroke=\"#333\"/>"
        "<text x=\"30\" y=\"{}\">{}</text>\n",
        y - 13.0, bandColor(band), y, text);
  }
  static_cast<void>(height);
}
}  // namespace

Color filmColor(double relative) {
  for (std::size_t i = 1; i < stops.size(); ++i) {
    if (relative <= stops[i].relative) {
      const Stop& a = stops[i - 1];
      const Stop& b = stops[i];
      const double share = std::max(0.0, (relative - a.relative) / (b.relative - a.relative));
      return {mixed(a.color.red, b.color.red, share), mixed(a.color.green, b.color.green, share),
              mixed(a.color.blue, b.color.blue, share)};
    }
  }
  return stops.back().color;
}

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

void writeFilmSvg(std::ostream& out, const FilmPicture& p) {
  const double width = p.cell * static_cast<double>(p.columns);
  const double height = p.cell * static_cast<double>(p.rows);
  const double top = p.lowY + height;
  const double scale = 760.0 / std::max(width, height);
  const double tall = std::max(height * scale + 40.0, 260.0);
  out << fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.6g}\" height=\"{:.6g}\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n<title>{}</title>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<text x=\"8\" y=\"{:.6g}\">{}</text>\n"
      "<g transform=\"scale({:.8g}) translate({:.8g} 0)\">\n",
      width * scale + legendWidth, tall, escaped(p.title), tall - 10.0, escaped(p.title), scale,
      -p.lowX);
  const Coarse c = coarse(p);
  bands(out, p, c, top);
  for (const double level : levels) {
    contour(out, p, c, level, top);
  }
  lines(out, p, top);
  out << fmt::format("</g>\n<g transform=\"translate({:.6g} 0)\">\n", width * scale);
  legend(out, p, tall);
  out << "</g>\n</svg>\n";
}

}  // namespace arelem::backend
