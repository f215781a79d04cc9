#include "runtime/stencil/cell.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arelem::stencil {

namespace {
constexpr double radian = std::numbers::pi / 180.0;

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

Vec2 onLine(const Line& line, double s) {
  return line.first + s * (line.second - line.first);
}

double worstWithBestTilt(const Line& from, const Line& to, double fan, double most) {
  return spreadOf(from, to, fan, bestTilt(from, to, fan, most)).worst();
}
}  // namespace

double Spread::worst() const {
  return std::max(most - 1.0, 1.0 - least);
}

void Spread::add(const Spread& other) {
  least = std::min(least, other.least);
  most = std::max(most, other.most);
}

double paintUpTo(double s, double fan, double tilt) {
  // A line of width 1; where the gun stands and how high does not depend on more than the tilt.
  const Tilted gun = placeTilted(1.0, fan, tilt);
  const double angle = std::atan2(s - 0.5 - gun.shift, gun.height) + tilt * radian;
  return 0.5 + 0.5 * std::tan(angle) / std::tan(0.5 * fan * radian);
}

double areaOf(const Line& from, const Line& to) {
  return 0.5 * std::abs(cross(from.second - from.first, to.second - from.first) +
                        cross(to.second - from.first, to.first - from.first));
}

std::array<double, stripsOfACell> filmOf(const Line& from,
                                         const Line& to,
                                         double fan,
                                         double tilt) {
  std::array<double, stripsOfACell> film{};
  const double area = areaOf(from, to);
  double before = 0.0;
  for (int k = 0; k < stripsOfACell; ++k) {
    const double low = static_cast<double>(k) / stripsOfACell;
    const double high = static_cast<double>(k + 1) / stripsOfACell;
    const double paint = k + 1 == stripsOfACell ? 1.0 : paintUpTo(high, fan, tilt);
    const double strip =
        areaOf({onLine(from, low), onLine(from, high)}, {onLine(to, low), onLine(to, high)});
    film[static_cast<std::size_t>(k)] = strip > 0.0 ? (paint - before) * area / strip : 1.0;
    before = paint;
  }
  return film;
}

Spread spreadOf(const Line& from, const Line& to, double fan, double tilt) {
  const auto film = filmOf(from, to, fan, tilt);
  const auto [least, most] = std::minmax_element(film.begin(), film.end());
  return {*least, *most};
}

double bestTilt(const Line& from, const Line& to, double fan, double most) {
  double center = std::clamp(tiltFor(quadrilateralShare(from, to), fan), -most, most);
  double best = spreadOf(from, to, fan, center).worst();
  // Pattern search round the tilt that halves the area: the worst film has one valley there.
  for (double step = 2.0; step > 0.05; step *= 0.5) {
    for (const double sign : {-1.0, 1.0}) {
      for (;;) {
        const double next = std::clamp(center + sign * step, -most, most);
        const double worst = spreadOf(from, to, fan, next).worst();
        if (!(worst < best) || next == center) {
          break;
        }
        best = worst;
        center = next;
      }
    }
  }
  return center;
}

std::vector<Line> bestDivision(const std::vector<Line>& lines,
                               const Measured& second,
                               double fan,
                               double most) {
  const std::size_t last = lines.size() - 1;
  std::vector<Line> moved = lines;
  std::vector<double> share(lines.size());
  std::vector<double> worst(last);
  for (std::size_t i = 0; i <= last; ++i) {
    share[i] = static_cast<double>(i) / static_cast<double>(last);
  }
  for (std::size_t i = 0; i < last; ++i) {
    worst[i] = worstWithBestTilt(moved[i], moved[i + 1], fan, most);
  }
  constexpr int rounds = 12;
  double step = 0.25 / static_cast<double>(last);
  for (int round = 0; round < rounds; ++round, step *= 0.75) {
    for (std::size_t i = 1; i < last; ++i) {
      for (const double sign : {-1.0, 1.0}) {
        const double next = share[i] + sign * step;
        if (next <= share[i - 1] || next >= share[i + 1]) {
          continue;
        }
        const Line tried{moved[i].first, second.at(next)};
        const double before = worstWithBestTilt(moved[i - 1], tried, fan, most);
        const double after = worstWithBestTilt(tried, moved[i + 1], fan, most);
        const auto weight = [](double a, double b) { return std::pow(a, 6) + std::pow(b, 6); };
        if (weight(before, after) < weight(worst[i - 1], worst[i])) {
          moved[i] = tried;
          share[i] = next;
          worst[i - 1] = before;
          worst[i] = after;
        }
      }
    }
  }
  return moved;
}

}  // namespace arelem::stencil
