#include "backend/joints/plot.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "backend/svg/canvas.h"
#include "backend/svg/scale.h"
#include "ir/space/robot_tolerance.h"

namespace arelem::joints {

namespace {
using backend::svg::Box;
using backend::svg::Canvas;
using backend::svg::Pixel;
using backend::svg::Scale;

constexpr double panelWidth = 520.0;
constexpr double panelHeight = 190.0;
constexpr double marginLeft = 64.0;
constexpr double marginTop = 34.0;
constexpr double marginBottom = 34.0;

double right(const Box& box) {
  return box.left + box.width;
}
double bottom(const Box& box) {
  return box.top + box.height;
}

/// A rectangle of the picture with axes in units of its own.
class Panel {
 public:
  Panel(Canvas& canvas, const Box& box, Scale x, Scale y)
      : canvas_(canvas), box_(box), x_(x), y_(y) {}

  [[nodiscard]] Pixel at(double x, double y) const {
    return {box_.left + (x - x_.low) / (x_.high - x_.low) * box_.width,
            bottom(box_) - (y - y_.low) / (y_.high - y_.low) * box_.height};
  }
  void axes(std::string_view title, std::string_view below) {
    canvas_.rectangle(box_, "fill=\"none\" stroke=\"#888\"");
    canvas_.text({box_.left, box_.top - 8.0}, title, "style=\"font-size:13px;font-weight:bold\"");
    for (double v = x_.firstTick(); v <= x_.high + tolerance::plotTick; v += x_.step) {
      const Pixel p = at(v, y_.low);
      canvas_.line({p.x, box_.top}, p, "stroke=\"#e4e4e4\"");
      canvas_.text({p.x, p.y + 14.0}, x_.text(v), "text-anchor=\"middle\"");
    }
    for (double v = y_.firstTick(); v <= y_.high + tolerance::plotTick; v += y_.step) {
      const Pixel p = at(x_.low, v);
      canvas_.line(p, {right(box_), p.y}, "stroke=\"#e4e4e4\"");
      canvas_.text({p.x - 5.0, p.y + 3.5}, y_.text(v), "text-anchor=\"end\"");
    }
    canvas_.text({right(box_), bottom(box_) + 27.0}, below, "text-anchor=\"end\"");
  }
  /// A dashed level, where it lies in the panel.
  void level(double value) {
    if (value > y_.low && value < y_.high) {
      canvas_.line(at(x_.low, value), at(x_.high, value),
                   "stroke=\"#c03030\" stroke-dasharray=\"6 4\"");
    }
  }

 private:
  Canvas& canvas_;
  Box box_;
  Scale x_, y_;
};

/// A curve of more points than pixels keeps the least and the largest of each group.
std::vector<std::size_t> shownRows(const std::vector<double>& values) {
  constexpr std::size_t mostPoints = 2000;
  std::vector<std::size_t> rows;
  const std::size_t group = values.size() / mostPoints + 1;
  for (std::size_t i = 0; i < values.size(); i += group) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(i);
    const auto end =
        values.begin() + static_cast<std::ptrdiff_t>(std::min(i + group, values.size()));
    const auto [least, most] = std::minmax_element(begin, end);
    rows.push_back(static_cast<std::size_t>(std::min(least, most) - values.begin()));
    if (least != most) {
      rows.push_back(static_cast<std::size_t>(std::max(least, most) - values.begin()));
    }
  }
  return rows;
}

void curve(Canvas& canvas,
           const Box& box,
           const Table& table,
           std::string_view title,
           double limit,
           const std::function<double(const Row&)>& value) {
  std::vector<double> values;
  for (const Row& row : table.rows) {
    values.push_back(value(row));
  }
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double seconds = table.rows.empty() ? 1.0 : table.rows.back().time;
  Scale y = values.empty() ? Scale(0.0, 1.0, 5.0) : Scale(*least, *most, 5.0);
  y.wide();
  Panel panel(canvas, box, Scale(0.0, seconds, 8.0), y);
  panel.axes(title, "s");
  if (limit > 0.0) {
    panel.level(limit);
    panel.level(-limit);
  }
  std::vector<Pixel> points;
  for (const std::size_t i : shownRows(values)) {
    points.push_back(panel.at(table.rows[i].time, values[i]));
  }
  if (points.size() > 1) {
    canvas.polyline(points, "fill=\"none\" stroke=\"#1f5fa8\" stroke-width=\"1.3\"");
  }
}

/// The smallest rectangle round the path of the tool.
struct Span {
  double lowX = 0.0, highX = 1.0, lowY = 0.0, highY = 1.0;
};
Span spanOf(const Table& table) {
  Span span;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Place& p = table.rows[i].tool.place;
    span.lowX = i == 0 ? p[0] : std::min(span.lowX, p[0]);
    span.highX = i == 0 ? p[0] : std::max(span.highX, p[0]);
    span.lowY = i == 0 ? p[1] : std::min(span.lowY, p[1]);
    span.highY = i == 0 ? p[1] : std::max(span.highY, p[1]);
  }
  return span;
}

/// As wide as the path needs at this height: half of the sheet or more.
double groundWidth(const Table& table, double height, double most) {
  const Span span = spanOf(table);
  const double tall = std::max(span.highY - span.lowY, tolerance::plotRange);
  return std::clamp(height * (span.highX - span.lowX) / tall, panelWidth, most);
}

/// The path on the ground, to one scale in x and y.
void ground(Canvas& canvas, const Box& box, const Table& table) {
  const auto [lowX, highX, lowY, highY] = spanOf(table);
  const double perPixel = 1.08 * std::max({(highX - lowX) / box.width, (highY - lowY) / box.height,
                                           tolerance::plotRange});
  const double halfX = 0.5 * perPixel * box.width;
  const double halfY = 0.5 * perPixel * box.height;
  const double x = 0.5 * (lowX + highX);
  const double y = 0.5 * (lowY + highY);
  Panel panel(canvas, box, Scale(x - halfX, x + halfX, 8.0), Scale(y - halfY, y + halfY, 6.0));
  panel.axes("path of the tool, mm (thick: the gun is open)", "x");
  std::vector<Pixel> points;
  bool open = false;
  const auto draw = [&] {
    if (points.size() > 1) {
      canvas.polyline(points, open ? "fill=\"none\" stroke=\"#1f5fa8\" stroke-width=\"3\""
                                   : "fill=\"none\" stroke=\"#888\" stroke-dasharray=\"4 3\"");
    }
    points.clear();
  };
  constexpr std::size_t mostPoints = 20000;
  const std::size_t step = table.rows.size() / mostPoints + 1;
  for (std::size_t i = 0; i < table.rows.size(); i += step) {
    const State& tool = table.rows[i].tool;
    points.push_back(panel.at(tool.place[0], tool.place[1]));
    if (tool.gun != open) {
      const Pixel last = points.back();
      draw();
      points.push_back(last);
      open = tool.gun;
    }
  }
  draw();
}
}  // namespace

void writePlot(std::ostream& out, const Arm& arm, const Table& table) {
  constexpr double cell = marginTop + panelHeight + marginBottom;
  constexpr double pathHeight = 360.0;
  constexpr double width = 2.0 * (marginLeft + panelWidth) + 30.0;
  constexpr double top = marginTop + pathHeight + marginBottom + 10.0;
  Canvas canvas(out, width, top + 3.0 * cell);
  const double seconds = table.rows.empty() ? 0.0 : table.rows.back().time;
  canvas.begin("Joints over time",
               fmt::format("{}: {:.3f} s, {} rows every {:.6g} s, gun open {:.3f} s", arm.name(),
                           seconds, table.rows.size(), table.interval, table.paintingTime));
  const double pathWidth = groundWidth(table, pathHeight, width - marginLeft - 30.0);
  ground(canvas, Box{marginLeft, marginTop, pathWidth, pathHeight}, table);
  for (std::size_t j = 0; j < 2; ++j) {
    const double left = marginLeft + static_cast<double>(j) * (marginLeft + panelWidth);
    const std::string name(arm.jointName(j));
    const std::string_view unit = arm.unit(j);
    const auto box = [&](int row) {
      return Box{left, top + row * cell + marginTop, panelWidth, panelHeight};
    };
    curve(canvas, box(0), table, fmt::format("{}, {}", name, unit), 0.0,
          [j](const Row& row) { return row.joints.place[j]; });
    curve(canvas, box(1), table, fmt::format("speed of the {}, {}/s", name, unit), arm.mostSpeed(j),
          [j](const Row& row) { return row.joints.speed[j]; });
    curve(canvas, box(2), table, fmt::format("acceleration of the {}, {}/s2", name, unit),
          arm.mostAcceleration(j), [j](const Row& row) { return row.joints.acceleration[j]; });
  }
  canvas.end();
}

}  // namespace arelem::joints
