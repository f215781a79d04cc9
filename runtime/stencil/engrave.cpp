#include "runtime/stencil/engrave.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/diag/stencil.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/angle.h"
#include "runtime/stencil/order.h"

namespace arelem::stencil {

namespace {
constexpr double radian = std::numbers::pi / 180.0;

/// How many chords of even parameter steps hold the tolerance on a piece stretched by `scale`.
struct Chords {
  Vec2 scale;
  double tolerance;

  double operator()(const LinePiece& /*line*/) const { return 1.0; }
  double operator()(const ArcPiece& arc) const {
    // A step of the parameter departs by at most r (1 - cos(step / 2)), r the larger radius.
    const double radius = arc.radii.cwiseProduct(scale).maxCoeff();
    const double half = std::acos(1.0 - std::min(1.0, tolerance / radius));
    return std::ceil(std::abs(arc.end - arc.start) * radian / (2.0 * half));
  }
  double operator()(const SplinePiece& spline) const {
    // A chord of a step h departs by at most h^2 / 8 times the largest second derivative, which is
    // straight in t: so it is at an end.
    const auto& p = spline.control;
    const Vec2 atZero = 4.0 * p[0] - 4.0 * p[1] + 2.0 * p[2] - 2.0 * p[3];
    const Vec2 atOne = -2.0 * p[0] + 2.0 * p[1] - 4.0 * p[2] + 4.0 * p[3];
    const double most =
        std::max(atZero.cwiseProduct(scale).norm(), atOne.cwiseProduct(scale).norm());
    return std::max(1.0, std::ceil(std::sqrt(most / (8.0 * tolerance))));
  }
};

/// A line of a symbol on its grid, in pieces; chorded when it is laid out.
std::vector<Edge> linesOf(const Symbol& symbol, const Alphabet& alphabet) {
  if (!symbol.pens.empty()) {
    return symbol.pens;
  }
  // The middles of the strokes, squeezed to the height of the pen grid.
  const double squeeze = alphabet.penHeight / alphabet.height;
  std::vector<Edge> lines;
  for (const Stroke& stroke : symbol.strokes) {
    Edge* line = stroke.join && !lines.empty() ? &lines.back() : &lines.emplace_back();
    Vec2 at = line->pieces.empty() ? Vec2::Zero() : lastPoint(*line);
    bool first = line->pieces.empty();
    for (const Line& fan :
         linesOf(stroke, symbol.width, alphabet.height, stroke.cells, Division::equal)) {
      const Vec2 middle = middleOf(fan).cwiseProduct(Vec2(1.0, squeeze));
      if (!first && middle != at) {
        line->pieces.emplace_back(LinePiece{at, middle});
      }
      first = false;
      at = middle;
    }
  }
  return lines;
}

/// The right end of a symbol's pen lines, on the grid.
double rightOf(const Symbol& symbol, const std::vector<Edge>& lines, const Alphabet& alphabet) {
  if (symbol.pens.empty()) {
    return symbol.width * alphabet.penWidth / alphabet.width;
  }
  double right = 0.0;
  for (const Edge& line : lines) {
    for (const Piece& piece : line.pieces) {
      constexpr int samples = 16;
      for (int i = 0; i <= samples; ++i) {
        right = std::max(right, pointOf(piece, static_cast<double>(i) / samples).x());
      }
    }
  }
  return right;
}

/// From the grid to the part.
struct Layout {
  Vec2 origin;
  Vec2 along, up;  // of one grid unit
  Vec2 scale;
  double tolerance;

  [[nodiscard]] Vec2 operator()(double x, const Vec2& p) const {
    return origin + (x + p.x()) * along + p.y() * up;
  }
};

std::vector<Vec2> chorded(const Edge& line, const Layout& layout, double x) {
  std::vector<Vec2> points = {layout(x, firstPoint(line))};
  for (const Piece& piece : line.pieces) {
    const double count = std::visit(Chords{layout.scale, layout.tolerance}, piece);
    for (double i = 1.0; i <= count; ++i) {
      points.push_back(layout(x, pointOf(piece, i / count)));
    }
  }
  return points;
}

double chordsOf(const Edge& line, const Layout& layout) {
  double count = 1.0;
  for (const Piece& piece : line.pieces) {
    count += std::visit(Chords{layout.scale, layout.tolerance}, piece);
  }
  return count;
}

/// A number of points as a message shows it.
std::size_t sizeOf(double points) {
  constexpr double most = 1e15;
  return static_cast<std::size_t>(std::min(points, most));
}

void order(std::vector<PenLine>& lines, const Vec2& start) {
  std::vector<Visit> given;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    given.push_back({i, lines[i].points.front(), lines[i].points.back(), false});
  }
  std::vector<PenLine> ordered;
  for (const Visit& visit : shortest(std::move(given), start)) {
    ordered.push_back(std::move(lines[visit.run]));
    if (visit.backwards) {
      std::reverse(ordered.back().points.begin(), ordered.back().points.end());
    }
  }
  lines = std::move(ordered);
}
}  // namespace

bool PenLine::isClosed() const {
  return points.size() > 2 && (points.front() - points.back()).norm() <= tolerance::coincidence;
}

Result<std::vector<PenLine>> penLines(const Engraving& engraving,
                                      const files::Files& files,
                                      const Limits& limits,
                                      const Vec2& start) {
  Result<std::string> text = files::read(files, engraving.alphabet);
  if (!text) {
    return text.takeFailure();
  }
  Result<Alphabet> alphabet = readAlphabet(*text, engraving.alphabet);
  return alphabet ? penLines(engraving, *alphabet, limits, start)
                  : Result<std::vector<PenLine>>(alphabet.takeFailure());
}

Result<std::vector<PenLine>> penLines(const Engraving& engraving,
                                      const Alphabet& alphabet,
                                      const Limits& limits,
                                      const Vec2& start) {
  Result<std::vector<const Symbol*>> symbols = symbolsOf(engraving.text, alphabet);
  if (!symbols) {
    return symbols.takeFailure();
  }
  const Placement& place = engraving.placement;
  const double tall = place.height / alphabet.penHeight;
  const double wide = engraving.width > 0.0 ? engraving.width / alphabet.penWidth : tall;
  const double gap = place.space ? *place.space / wide : alphabet.penSpacing;
  const auto [sine, cosine] = geometry::sinCosDegrees(place.angle);
  const Layout layout{place.origin, wide * Vec2(cosine, sine), tall * Vec2(-sine, cosine),
                      Vec2(wide, tall), engraving.chord};
  std::vector<PenLine> lines;
  double points = 0.0;
  double x = 0.0;
  for (const Symbol* symbol : *symbols) {
    if (symbol == nullptr) {
      x += alphabet.penWidth + gap;
      continue;
    }
    const std::vector<Edge> edges = linesOf(*symbol, alphabet);
    for (const Edge& edge : edges) {
      points += chordsOf(edge, layout);
      if (points > static_cast<double>(limits.points)) {
        return fail(diag::StencilSize, sizeOf(points), limits.points);
      }
      lines.push_back({symbol->name, chorded(edge, layout, x)});
    }
    x += rightOf(*symbol, edges, alphabet) + gap;
  }
  if (lines.empty()) {
    return fail(diag::StencilEmpty);
  }
  order(lines, start);
  return lines;
}

}  // namespace arelem::stencil
