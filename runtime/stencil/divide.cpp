#include "runtime/stencil/divide.h"

#include <algorithm>
#include <cmath>

namespace arelem::stencil {

namespace {
std::vector<Vec2> divideEqually(const Edge& edge, int cells) {
  const Measured measured(edge);
  std::vector<Vec2> points;
  for (int i = 0; i <= cells; ++i) {
    points.push_back(measured.at(static_cast<double>(i) / cells));
  }
  return points;
}

/// The curve of the source's edge as a function of its own parameter: t of a spline, the height of
/// an arc.
struct SourceCurve {
  const Piece* piece = nullptr;
  std::vector<double> parameters;  // of the cells + 1 samples

  [[nodiscard]] Vec2 at(double parameter) const {
    if (const auto* arc = std::get_if<ArcPiece>(piece)) {
      const double h = parameter / arc->radii.y();
      return arc->center + Vec2(arc->radii.x() * std::sqrt(std::max(0.0, 1.0 - h * h)), parameter);
    }
    return pointOf(*piece, parameter);
  }
};

/// None where the source has no such edge.
std::vector<double> sourceParameters(const Piece& piece, int cells) {
  std::vector<double> list;
  const auto* arc = std::get_if<ArcPiece>(&piece);
  const bool quarter =
      arc != nullptr && arc->start == 90.0 && arc->end == 0.0 && arc->radii.x() != arc->radii.y();
  if (!quarter && !std::holds_alternative<SplinePiece>(piece)) {
    return list;
  }
  for (int i = 0; i <= cells; ++i) {
    const double share = static_cast<double>(i) / cells;
    list.push_back(quarter ? arc->radii.y() * std::sqrt(1.0 - share * share) : share);
  }
  return list;
}

/// Linear interpolation in a table of rising places.
double interpolate(const std::vector<double>& places,
                   const std::vector<double>& values,
                   double place) {
  const auto next = std::lower_bound(places.begin() + 1, places.end() - 1, place);
  const auto i = static_cast<std::size_t>(next - places.begin());
  const double step = places[i] - places[i - 1];
  return values[i - 1] + (values[i] - values[i - 1]) / step * (place - places[i - 1]);
}

std::vector<Vec2> divideAsSource(const Edge& edge, const SourceCurve& curve, int cells) {
  std::vector<double> along = {0.0};
  for (std::size_t i = 1; i < curve.parameters.size(); ++i) {
    const Vec2 step = curve.at(curve.parameters[i]) - curve.at(curve.parameters[i - 1]);
    along.push_back(along.back() + step.norm());
  }
  const auto* line = edge.pieces.size() == 2 ? std::get_if<LinePiece>(&edge.pieces[1]) : nullptr;
  const double straight = line != nullptr ? (line->to - line->from).norm() : 0.0;
  const double step = (along.back() + straight) / cells;
  const int onLine = static_cast<int>(straight / step);
  std::vector<Vec2> points;
  for (int i = 0; i < cells - onLine; ++i) {
    points.push_back(curve.at(interpolate(along, curve.parameters, i * step)));
  }
  for (int back = onLine; back >= 0; --back) {
    const Vec2 end = lastPoint(edge);
    points.push_back(line != nullptr ? Vec2(end + back * step / straight * (line->from - line->to))
                                     : end);
  }
  return points;
}

std::vector<Line> curvedLines(const Shape& shape, int cells, Division division) {
  std::vector<Vec2> first = divideEdge(shape.first, cells, division);
  std::vector<Vec2> second = divideEdge(shape.second, cells, division);
  if (shape.firstBack) {
    std::reverse(first.begin(), first.end());
  }
  if (shape.secondBack) {
    std::reverse(second.begin(), second.end());
  }
  std::vector<Line> lines;
  for (std::size_t i = 0; i < first.size(); ++i) {
    lines.push_back({first[i], second[i]});
  }
  return lines;
}

std::vector<Line> straightLines(const std::vector<Line>& given, int cells) {
  std::vector<Line> lines = {given.front()};
  for (std::size_t i = 1; i < given.size(); ++i) {
    for (int k = 1; k <= cells; ++k) {
      const double t = static_cast<double>(k) / cells;
      lines.push_back({given[i - 1].first + t * (given[i].first - given[i - 1].first),
                       given[i - 1].second + t * (given[i].second - given[i - 1].second)});
    }
  }
  return lines;
}
}  // namespace

std::vector<Vec2> divideEdge(const Edge& edge, int cells, Division division) {
  if (division == Division::asSource && edge.pieces.size() <= 2) {
    SourceCurve curve;
    curve.piece = &edge.pieces.front();
    curve.parameters = sourceParameters(*curve.piece, cells);
    if (!curve.parameters.empty()) {
      return divideAsSource(edge, curve, cells);
    }
  }
  return divideEqually(edge, cells);
}

std::vector<Line> linesOf(const Shape& shape, int cells, Division division) {
  return shape.isStraight() ? straightLines(shape.lines, cells)
                            : curvedLines(shape, cells, division);
}

std::vector<Line> placedLines(const Stroke& stroke,
                              std::vector<Line> lines,
                              double symbolWidth,
                              double gridHeight) {
  for (Line& line : lines) {
    line.first = placed(stroke.placing, symbolWidth, gridHeight, line.first);
    line.second = placed(stroke.placing, symbolWidth, gridHeight, line.second);
    if (stroke.swap) {
      std::swap(line.first, line.second);
    }
  }
  if (stroke.reverse) {
    std::reverse(lines.begin(), lines.end());
  }
  return lines;
}

std::vector<Line> linesOf(
    const Stroke& stroke, double symbolWidth, double gridHeight, int cells, Division division) {
  return placedLines(stroke, linesOf(*stroke.shape, cells, division), symbolWidth, gridHeight);
}

}  // namespace arelem::stencil
