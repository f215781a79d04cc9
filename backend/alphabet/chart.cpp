#include "backend/alphabet/chart.h"

#include <algorithm>
#include <cmath>

#include "backend/svg/canvas.h"

namespace arelem::backend {

namespace {
using svg::Canvas;
using svg::Pixel;

constexpr double margin = 24.0;
constexpr double gap = 2.0;           // grid units between symbols
constexpr double mostWidth = 1120.0;  // pixels
constexpr double caption = 26.0;
constexpr double head = 34.0;

/// The place of each symbol: left in grid units, and its row.
struct Slot {
  double left = 0.0;
  int row = 0;
};

std::vector<Slot> slotsOf(const Chart& chart) {
  std::vector<Slot> slots;
  double x = 0.0;
  int row = 0;
  for (const ChartSymbol& symbol : chart.symbols) {
    if (x > 0.0 && (x + symbol.width) * chart.unit > mostWidth) {
      x = 0.0;
      ++row;
    }
    slots.push_back({x, row});
    x += symbol.width + gap;
  }
  return slots;
}

class Sheet {
 public:
  Sheet(Canvas& canvas, const Chart& chart) : canvas_(canvas), chart_(chart) {}

  [[nodiscard]] double rowHeight() const { return chart_.unit * chart_.height + caption + margin; }

  void symbol(const ChartSymbol& symbol, const Slot& slot) {
    left_ = margin + chart_.unit * slot.left;
    foot_ = head + rowHeight() * slot.row + chart_.unit * chart_.height;
    if (chart_.lines) {
      grid(symbol.width);
    }
    for (const auto& stroke : symbol.strokes) {
      std::vector<Pixel> outline;
      for (const auto& line : stroke) {
        outline.push_back(at(line[0]));
      }
      for (std::size_t i = stroke.size(); i-- > 0;) {
        outline.push_back(at(stroke[i][1]));
      }
      outline.push_back(outline.front());
      canvas_.polyline(outline, chart_.lines ? "fill=\"#1f5fa8\" fill-opacity=\"0.35\" "
                                               "stroke=\"#1f5fa8\" stroke-width=\"1\""
                                             : "fill=\"#20242a\" stroke=\"#20242a\" "
                                               "stroke-width=\"0.4\"");
      if (chart_.lines) {
        fan(stroke);
      }
    }
    for (const auto& pen : symbol.pens) {
      std::vector<Pixel> line;
      for (const ChartPoint& point : pen) {
        line.push_back(at(point));
      }
      canvas_.polyline(line,
                       "fill=\"none\" stroke=\"#20242a\" stroke-width=\"2\" "
                       "stroke-linecap=\"round\" stroke-linejoin=\"round\"");
    }
    canvas_.text({left_ + 0.5 * chart_.unit * symbol.width, foot_ + 18.0}, symbol.name,
                 "text-anchor=\"middle\"");
  }

 private:
  [[nodiscard]] Pixel at(const ChartPoint& p) const {
    return {left_ + chart_.unit * p.first, foot_ - chart_.unit * p.second};
  }
  void grid(double width) {
    for (double x = 0.0; x <= width + 1e-9; x += 1.0) {
      canvas_.line(at({x, 0.0}), at({x, chart_.height}), "stroke=\"#dddddd\" stroke-width=\"0.6\"");
    }
    for (double y = 0.0; y <= chart_.height + 1e-9; y += 1.0) {
      canvas_.line(at({0.0, y}), at({width, y}), "stroke=\"#dddddd\" stroke-width=\"0.6\"");
    }
  }
  /// The lines of the fan and the way of their middles.
  void fan(const std::vector<std::array<ChartPoint, 2>>& stroke) {
    std::vector<Pixel> middles;
    for (const auto& [a, b] : stroke) {
      canvas_.line(at(a), at(b), "stroke=\"#1f5fa8\" stroke-width=\"0.5\"");
      middles.push_back(at({0.5 * (a.first + b.first), 0.5 * (a.second + b.second)}));
    }
    if (middles.size() > 1) {
      canvas_.polyline(middles, "fill=\"none\" stroke=\"#c03030\" stroke-width=\"1\"");
    }
  }

  Canvas& canvas_;
  const Chart& chart_;
  double left_ = 0.0;
  double foot_ = 0.0;
};
}  // namespace

void writeChart(std::ostream& out, const Chart& chart) {
  const std::vector<Slot> slots = slotsOf(chart);
  double widest = 1.0;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    widest = std::max(widest, slots[i].left + chart.symbols[i].width);
  }
  const int rows = slots.empty() ? 1 : slots.back().row + 1;
  const double rowHeight = chart.unit * chart.height + caption + margin;
  Canvas canvas(out, 2.0 * margin + chart.unit * widest, head + rows * rowHeight);
  canvas.begin(chart.title, std::to_string(chart.symbols.size()) + " symbols");
  canvas.text({margin, 22.0}, chart.title, "class=\"title\"");
  Sheet sheet(canvas, chart);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    sheet.symbol(chart.symbols[i], slots[i]);
  }
  canvas.end();
}

}  // namespace arelem::backend
