#include "runtime/stencil/stroke_check.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "ir/space/stencil_tolerance.h"
#include "runtime/stencil/divide.h"

namespace arelem::stencil {

namespace {
double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

std::string shown(const Line& line) {
  return fmt::format("{:.6g},{:.6g} {:.6g},{:.6g}", line.first.x(), line.first.y(), line.second.x(),
                     line.second.y());
}

/// Lines at the stroke's place in the symbol, in the order in which it is painted: all of a
/// straight one, first and last of another.
std::vector<Line> linesOf(const Stroke& stroke, double symbolWidth, double gridHeight) {
  const Shape& shape = *stroke.shape;
  std::vector<Line> ends;
  if (shape.isStraight()) {
    ends = shape.lines;
  } else {
    ends = {{firstPoint(shape.first), firstPoint(shape.second)},
            {lastPoint(shape.first), lastPoint(shape.second)}};
    if (shape.firstBack) {
      std::swap(ends[0].first, ends[1].first);
    }
    if (shape.secondBack) {
      std::swap(ends[0].second, ends[1].second);
    }
  }
  return placedLines(stroke, std::move(ends), symbolWidth, gridHeight);
}
}  // namespace

std::string objectionToLines(const std::vector<Line>& lines) {
  double way = 0.0;  // sign of the area of the cells so far
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const Line& from = lines[i - 1];
    const Line& to = lines[i];
    // Between the lines lies a bilinear patch; it is folded where its Jacobian changes its sign at
    // the corners.
    std::array<double, 4> corners{};
    std::size_t corner = 0;
    for (const Line& line : {from, to}) {
      const Vec2 along = line.second - line.first;
      corners[corner++] = cross(along, to.first - from.first);
      corners[corner++] = cross(along, to.second - from.second);
    }
    const auto [low, high] = std::minmax_element(corners.begin(), corners.end());
    const double width = std::max(widthOf(from), widthOf(to));
    const double least = tolerance::cellArea * width * width;
    const std::string both = fmt::format("between the fan lines {} and {}", shown(from), shown(to));
    if (std::max(-*low, *high) <= least) {
      return both + " there is no area";
    }
    if (*low<-least&& * high> least) {
      return both + " the edges cross, or one of them runs back";
    }
    const double area = *low + *high;
    if (way * area < 0.0) {
      return both + " the stroke turns back over what it has painted";
    }
    way = area;
  }
  return {};
}

std::string objectionToJoin(const Stroke& before,
                            const Stroke& stroke,
                            double symbolWidth,
                            double gridHeight) {
  const std::vector<Line> past = linesOf(before, symbolWidth, gridHeight);
  const std::vector<Line> next = linesOf(stroke, symbolWidth, gridHeight);
  const Line& end = past.back();
  const Line& begin = next.front();
  const double gap = std::max((begin.first - end.first).norm(), (begin.second - end.second).norm());
  const std::string both = fmt::format(
      "the stroke before ends with the fan line {} and this one begins with {}: ", shown(end),
      shown(begin));
  if (gap > tolerance::joinedLines * std::max(widthOf(end), widthOf(begin))) {
    return both + fmt::format("the gun would spray {:.6g} between them", gap);
  }
  if ((end.second - end.first).dot(begin.second - begin.first) < 0.0) {
    return both + "the fan would turn round in place with the gun open";
  }
  if (!before.shape->isStraight() || !stroke.shape->isStraight()) {
    return {};
  }
  std::vector<Line> across = {past[past.size() - 2], end};
  if (gap > tolerance::sameLine * widthOf(end)) {
    across.push_back(begin);
  }
  across.push_back(next[1]);
  return objectionToLines(across);
}

}  // namespace arelem::stencil
