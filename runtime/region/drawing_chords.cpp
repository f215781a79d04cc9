#include "runtime/region/drawing_chords.h"

#include <algorithm>
#include <cmath>

#include "ir/space/spray_tolerance.h"

namespace arelem::region {

namespace {
/// Chords of an arc whose middle is at most `chord` off; of more than `most` one more.
int chordsOf(double radius, double sweep, double chord, std::size_t most) {
  const double half = std::acos(std::clamp(1.0 - chord / radius, -1.0, 1.0));
  return static_cast<int>(
      std::clamp(std::ceil(std::abs(sweep) / std::max(2.0 * half, tolerance::arcStep)),
                 std::abs(sweep) > 3.0 ? 4.0 : 1.0, static_cast<double>(most) + 1.0));
}

/// Appends f over (from, to] so finely that chords stay near the curve.
void refine(const std::function<Vec2(double)>& f,
            double from,
            double to,
            double chord,
            int depth,
            std::size_t mostPoints,
            std::vector<Vec2>& points) {
  if (points.size() > mostPoints) {
    return;
  }
  const Vec2 a = f(from);
  const Vec2 b = f(to);
  double off = 0.0;
  for (const double t : {0.25, 0.5, 0.75}) {
    const Vec2 p = f(from + t * (to - from)) - a;
    const Vec2 d = b - a;
    const double length = d.norm();
    off = std::max(off, length > 0.0 ? std::abs(p.x() * d.y() - p.y() * d.x()) / length : p.norm());
  }
  if (depth == 0 || off <= chord) {
    points.push_back(b);
    return;
  }
  const double middle = (from + to) / 2.0;
  refine(f, from, middle, chord, depth - 1, mostPoints, points);
  refine(f, middle, to, chord, depth - 1, mostPoints, points);
}
constexpr int deepest = 22;  // finer than any tolerance of a curve that has not too many points
}  // namespace

std::vector<Vec2> arcPoints(
    const Vec2& center, double radius, double start, double sweep, double chord, std::size_t most) {
  const int n = chordsOf(radius, sweep, chord, most);
  std::vector<Vec2> points;
  for (int i = 0; i <= n; ++i) {
    const double angle = start + sweep * i / n;
    points.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

void addChords(const std::function<Vec2(double)>& f,
               double from,
               double to,
               double chord,
               std::size_t mostPoints,
               std::vector<Vec2>& points) {
  refine(f, from, to, chord, deepest, mostPoints, points);
}

}  // namespace arelem::region
