#include "backend/svg/conic.h"

#include <algorithm>
#include <cmath>

#include "ir/space/picture_tolerance.h"

namespace arelem::backend::svg {

namespace {
constexpr double cell = 4.0;  // pixels
constexpr std::size_t mostSegments = 4000;
constexpr int samplesOfAnInterval = 16;

/// Where the edge between two corners crosses zero.
Pixel crossing(Pixel a, double fa, Pixel b, double fb) {
  const double t = fa / (fa - fb);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

/// The crossings of one cell, joined in pairs.
void addCell(const std::array<Pixel, 4>& corner,
             const std::array<double, 4>& f,
             std::vector<Segment>& segments) {
  std::array<Pixel, 4> found{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    if ((f[i] < 0.0) != (f[next] < 0.0)) {
      found[count++] = crossing(corner[i], f[i], corner[next], f[next]);
    }
  }
  for (std::size_t i = 0; i + 2 <= count; i += 2) {
    segments.push_back({found[i], found[i + 1]});
  }
}
}  // namespace

std::vector<Segment> conicInView(const std::vector<double>& canon, const View& view) {
  const double a = canon[0], b = canon[1], d = canon[3], h = canon[6], p = canon[7], q = canon[8];
  const auto value = [&](Pixel at) {
    const double x = view.left + (at.x - view.box.left) / view.scale;
    const double y = view.bottom + (view.box.top + view.box.height - at.y) / view.scale;
    return a * x * x + b * y * y + d + 2 * (h * x * y + p * x + q * y);
  };
  std::vector<Segment> segments;
  const int columns = static_cast<int>(view.box.width / cell) + 1;
  const int rows = static_cast<int>(view.box.height / cell) + 1;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns && segments.size() < mostSegments; ++column) {
      const double x = view.box.left + cell * column;
      const double y = view.box.top + cell * row;
      const std::array<Pixel, 4> corner = {
          {{x, y}, {x + cell, y}, {x + cell, y + cell}, {x, y + cell}}};
      const std::array<double, 4> f = {value(corner[0]), value(corner[1]), value(corner[2]),
                                       value(corner[3])};
      addCell(corner, f, segments);
    }
  }
  return segments;
}

std::vector<Vec3> tabulatedCurve(const std::vector<double>& canon, int depth) {
  constexpr std::size_t head = 11;     // n, k, m1..m9
  constexpr std::size_t interval = 7;  // u v a b len max min
  if (canon.size() < head + 3 * interval + 2 || (canon.size() - head - 2) % interval != 0) {
    return {};
  }
  Eigen::Matrix3d frame;
  frame << canon[2], canon[3], canon[4], canon[5], canon[6], canon[7], canon[8], canon[9],
      canon[10];
  if (std::abs(std::abs(frame(2, depth)) - frame.row(2).norm()) > tolerance::edgeOn) {
    return {};
  }
  const std::size_t count = (canon.size() - head - 2) / interval;
  const auto start = [&](std::size_t i) {
    return Eigen::Vector2d(canon[head + interval * i], canon[head + interval * i + 1]);
  };
  std::vector<Vec3> curve;
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const Eigen::Vector2d from = start(i);
    const Eigen::Vector2d chord = start(i + 1) - from;
    const double length = chord.norm();
    if (!(length > 0.0)) {
      continue;
    }
    const Eigen::Vector2d along = chord / length;
    const Eigen::Vector2d across(-along.y(), along.x());
    const double a = canon[head + interval * i + 2];
    const double b = canon[head + interval * i + 3];
    const double c = -length * (a * length + b);
    for (int k = 0; k <= samplesOfAnInterval; ++k) {
      const double t = length * k / samplesOfAnInterval;
      const Eigen::Vector2d place = from + t * along + t * ((a * t + b) * t + c) * across;
      curve.emplace_back(frame.transpose() * Vec3(place.x(), place.y(), 0.0));
    }
  }
  return curve;
}

}  // namespace arelem::backend::svg
