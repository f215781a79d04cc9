#include "backend/svg/legend.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace arelem::backend::svg {

namespace {
constexpr double rowHeight = 18.0;
constexpr double sampleWidth = 30.0;
constexpr double columnWidth = 250.0;
constexpr double longestBar = 140.0;
constexpr double negligible = 1e-9;  // part unit

/// Hands out places row by row, and column by column.
class Rows {
 public:
  explicit Rows(const Box& box) : box_(box) {}
  Pixel next() {
    const Pixel at{box_.left + columnWidth * column_, box_.top + rowHeight * (row_ + 1)};
    if (++row_ >= rowsOfAColumn()) {
      row_ = 0;
      ++column_;
    }
    return at;
  }

 private:
  static int rowsOfAColumn() { return 4; }
  Box box_;
  int row_ = 0;
  int column_ = 0;
};

/// The largest of 1, 2, 5 times a power of ten that is no longer than the bar may be.
double barUnits(double scale) {
  const double most = longestBar / scale;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= most) {
      return step * power;
    }
  }
  return power;
}

void sample(Canvas& canvas, Pixel at, std::string_view lineClass, std::string_view words) {
  canvas.line({at.x, at.y - 4}, {at.x + sampleWidth, at.y - 4}, lineClass);
  canvas.text({at.x + sampleWidth + 8, at.y}, words, "");
}

void dot(
    Canvas& canvas, Pixel at, double radius, std::string_view dotClass, std::string_view words) {
  canvas.circle({at.x + sampleWidth / 2, at.y - 4}, radius, dotClass);
  canvas.text({at.x + sampleWidth + 8, at.y}, words, "");
}

std::string_view unitWord(const std::string& unit, double count) {
  if (!unit.empty()) {
    return unit;
  }
  return count == 1.0 ? "unit" : "units";
}

void drawBar(Canvas& canvas, Pixel at, const Shown& shown) {
  const double units = barUnits(shown.scale);
  const double y = at.y - 4;
  const double end = at.x + units * shown.scale;
  canvas.line({at.x, y}, {end, y}, "class=\"scale\"");
  canvas.line({at.x, y - 4}, {at.x, y + 4}, "class=\"scale\"");
  canvas.line({end, y - 4}, {end, y + 4}, "class=\"scale\"");
  canvas.text({end + 8, at.y},
              fmt::format("{} {}", shortNumber(units), unitWord(shown.path.unit(), units)), "");
}
}  // namespace

std::string shortNumber(double value) {
  // Rounding of the computation is no coordinate: 4e-16 is 0, and -0 too.
  const double size = std::abs(value);
  return size >= 1e4 && size < 1e15 ? fmt::format("{:.0f}", value)
                                    : fmt::format("{:.4g}", size < negligible ? 0.0 : value);
}

std::string rangeText(double low, double high) {
  constexpr double told = 1e-3;  // of a number, by shortNumber
  constexpr int most = 9;
  constexpr double nothing = 1e-8;  // of the range: what a computation leaves of 0
  const double range = high - low;
  low = std::abs(low) < nothing * range ? 0.0 : low;
  high = std::abs(high) < nothing * range ? 0.0 : high;
  const double size = std::max(std::abs(low), std::abs(high));
  if (!(range > negligible) || range > 100.0 * told * size) {
    return fmt::format("{} to {}", shortNumber(low), shortNumber(high));
  }
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(range))), 0, most);
  const auto text = [&](double value) {
    std::string digits = fmt::format("{:.{}f}", value, decimals);
    if (decimals > 0) {
      digits.erase(digits.find_last_not_of('0') + 1);
      digits.erase(digits.find_last_not_of('.') + 1);
    }
    return digits;
  };
  return fmt::format("{} to {}", text(low), text(high));
}

void drawLegend(Canvas& canvas, const Box& box, const Shown& shown) {
  Rows rows(box);
  const PathCollector& path = shown.path;
  drawBar(canvas, rows.next(), shown);
  const auto kind = [&](MoveKind move, std::string_view lineClass, std::string_view words) {
    if (path.length(move) > 0.0) {
      sample(canvas, rows.next(), lineClass,
             fmt::format("{}, {} {}", words, shortNumber(path.length(move)),
                         path.unit().empty() ? "long" : path.unit()));
    }
  };
  kind(MoveKind::gun, "class=\"gun\"", "gun on");
  kind(MoveKind::feed, "class=\"feed\"", path.length(MoveKind::gun) > 0.0 ? "gun off" : "feed");
  kind(MoveKind::arc, "class=\"arc\"",
       !path.hasSplines()  ? "along a circle"
       : path.hasCircles() ? "along circles and splines"
                           : "along a spline");
  kind(MoveKind::rapid, "class=\"rapid\"", "rapid");
  if (path.locations() > 0) {
    dot(canvas, rows.next(), 4.0, "class=\"begin\"", "start");
    dot(canvas, rows.next(), 5.0, "class=\"finish\"", "end");
  }
  if (shown.toolOutlines > 0) {
    dot(canvas, rows.next(), 6.5, "class=\"tool\"",
        fmt::format("cutter {} at {} of {} stops", shortNumber(path.cutterDiameter()),
                    shown.toolOutlines, path.stopCount()));
  }
  if (shown.faults) {
    sample(canvas, rows.next(), "class=\"doubt\"", "behind a motion with an error");
  }
  if (shown.geometry) {
    sample(canvas, rows.next(), "class=\"geometry\"", "geometry");
  }
  if (!shown.notDrawn.empty()) {
    canvas.text(rows.next(), "not drawn: " + shown.notDrawn, "class=\"soft\"");
  }
  if (shown.namesLeft > 0) {
    canvas.text(rows.next(),
                shown.namesLeft == 1 ? "1 name finds no room"
                                     : fmt::format("{} names find no room", shown.namesLeft),
                "class=\"soft\"");
  }
  if (shown.vertices < path.locations()) {
    canvas.text(rows.next(), fmt::format("{} of {} locations,", shown.vertices, path.locations()),
                "class=\"soft\"");
    canvas.text(rows.next(), fmt::format("others within {}", shortNumber(path.deviation())),
                "class=\"soft\"");
  }
}

}  // namespace arelem::backend::svg
