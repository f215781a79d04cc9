#include "backend/svg/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "backend/html/base64.h"
#include "backend/text/clean.h"
#include "backend/text/number.h"

namespace arelem::backend::svg {

namespace {
constexpr std::string_view styles = R"(  <style>
    text { font-family: 'DejaVu Sans', Verdana, Arial, sans-serif; font-size: 11px; fill: #30363d; }
    .title { font-size: 16px; font-weight: bold; }
    .soft { fill: #6b7480; }
    .wrong { fill: #d1242f; }
    .frame { fill: none; stroke: #d5dae0; stroke-width: 1; }
    .geometry { fill: none; stroke: #9aa3ad; stroke-width: 0.9; }
    .name { font-size: 10px; fill: #6b7480; paint-order: stroke; stroke: #ffffff; stroke-width: 3px; }
    .rapid { fill: none; stroke: #d1242f; stroke-width: 1.1; stroke-dasharray: 5 3; stroke-linejoin: round; }
    .feed { fill: none; stroke: #0b57d0; stroke-width: 1.5; stroke-linejoin: round; }
    .arc { fill: none; stroke: #0a8f6c; stroke-width: 1.8; stroke-linejoin: round; }
    .gun { fill: none; stroke: #b5179e; stroke-width: 2.4; stroke-linejoin: round; }
    .thin { stroke-width: 0.7; }
    .arrow { fill: #0b57d0; stroke: none; }
    .arrow.on { fill: #b5179e; }
    .tool { fill: #0b57d0; fill-opacity: 0.05; stroke: #0b57d0; stroke-opacity: 0.35; stroke-width: 0.8; }
    .begin { fill: #1a7f37; stroke: #ffffff; stroke-width: 1; }
    .finish { fill: #8a1c7c; stroke: #ffffff; stroke-width: 1; }
    .name.wrong { fill: #d1242f; }
    .fault { stroke: #d1242f; stroke-width: 2; }
    .doubt { stroke: #ffd33d; stroke-width: 2.2; stroke-dasharray: 2 4; }
    .scale { stroke: #30363d; stroke-width: 1.5; }
  </style>
)";
/// Farther outside than this nothing is seen, and renderers lose precision.
constexpr double farthest = 1e5;
}  // namespace

std::string Canvas::number(double value) const {
  std::array<char, numberRoom> digits{};
  const double bounded = std::isfinite(value) ? std::clamp(value, -farthest, farthest) : 0.0;
  const char* end =
      writeParameter(digits.data(), std::nearbyint(bounded * 100.0) / 100.0, shortest);
  return {digits.data(), static_cast<std::size_t>(end - digits.data())};
}

void Canvas::begin(std::string_view title, std::string_view description) {
  out_ << fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" role=\"img\">\n"
      "  <title>{2}</title>\n  <desc>{3}</desc>\n",
      number(width_), number(std::ceil(height_)), xmlText(title), xmlText(description));
  out_ << styles;
  rectangle({0.0, 0.0, width_, std::ceil(height_)}, "fill=\"#ffffff\"");
}

void Canvas::end() {
  out_ << "</svg>\n";
}

void Canvas::line(Pixel a, Pixel b, std::string_view attributes) {
  out_ << fmt::format("  <line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", number(a.x),
                      number(a.y), number(b.x), number(b.y), attributes);
}

void Canvas::circle(Pixel center, double radius, std::string_view attributes) {
  out_ << fmt::format("  <circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", number(center.x),
                      number(center.y), number(radius), attributes);
}

void Canvas::rectangle(const Box& box, std::string_view attributes) {
  out_ << fmt::format("  <rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n",
                      number(box.left), number(box.top), number(box.width), number(box.height),
                      attributes);
}

void Canvas::polyline(const std::vector<Pixel>& points, std::string_view attributes) {
  out_ << "  <polyline points=\"";
  std::string_view separator;
  for (const Pixel& p : points) {
    out_ << separator << number(p.x) << ',' << number(p.y);
    separator = " ";
  }
  out_ << "\" " << attributes << "/>\n";
}

void Canvas::curve(const std::vector<PathPiece>& pieces, std::string_view attributes) {
  if (std::none_of(pieces.begin(), pieces.end(), [](const auto& p) { return p.radius > 0.0; })) {
    std::vector<Pixel> points;
    std::transform(pieces.begin(), pieces.end(), std::back_inserter(points),
                   [](const PathPiece& p) { return p.to; });
    return polyline(points, attributes);
  }
  out_ << "  <path d=\"M" << number(pieces.front().to.x) << ',' << number(pieces.front().to.y);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const PathPiece& p = pieces[i];
    if (p.radius > 0.0) {
      out_ << fmt::format(" A{0},{0} 0 0 {1} ", number(p.radius), p.clockwise ? 1 : 0);
    } else {
      out_ << " L";
    }
    out_ << number(p.to.x) << ',' << number(p.to.y);
  }
  out_ << "\" " << attributes << "/>\n";
}

void Canvas::text(Pixel at, std::string_view words, std::string_view attributes) {
  out_ << fmt::format("  <text x=\"{}\" y=\"{}\" {}>{}</text>\n", number(at.x), number(at.y),
                      attributes, xmlText(words));
}

void Canvas::image(const Box& box, std::string_view png) {
  out_ << fmt::format(
      "  <image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
      "href=\"data:image/png;base64,",
      number(box.left), number(box.top), number(box.width), number(box.height));
  writeBase64(out_, std::vector<char>(png.begin(), png.end()));
  out_ << "\"/>\n";
}

void Canvas::beginClip(const Box& box, int id) {
  out_ << fmt::format("  <clipPath id=\"view{}\">\n  ", id);
  rectangle(box, "");
  out_ << fmt::format("  </clipPath>\n  <g clip-path=\"url(#view{})\">\n", id);
}

void Canvas::endGroup() {
  out_ << "  </g>\n";
}

}  // namespace arelem::backend::svg
