#include "runtime/spray/surface/spacing.h"

#include <algorithm>
#include <cmath>

namespace arelem::spray {

namespace {
constexpr double parallel = 0.995;  // shares above it are one: chords and arcs differ as much
constexpr double evenEnough = 0.1;
constexpr int mostHalvings = 6;

double distanceTo(const SurfaceLine& line, const Vec3& place) {
  double least = (line.front().place - place).norm();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec3 step = line[i].place - line[i - 1].place;
    const Vec3 arm = place - line[i - 1].place;
    const double square = step.squaredNorm();
    const double t = square > 0.0 ? std::clamp(arm.dot(step) / square, 0.0, 1.0) : 0.0;
    least = std::min(least, (arm - t * step).norm());
  }
  return least;
}

LinePoint middle(const LinePoint& a, const LinePoint& b) {
  return {(a.place + b.place) / 2.0, (a.normal + b.normal).normalized(), (a.uv + b.uv) / 2.0};
}

void divide(const Spacing& spacing,
            std::size_t line,
            const LinePoint& from,
            const LinePoint& to,
            int halvings,
            SurfaceLine& into) {
  if (halvings > 0 &&
      std::abs(spacing.share(line, from.place) - spacing.share(line, to.place)) > evenEnough) {
    const LinePoint half = middle(from, to);
    divide(spacing, line, from, half, halvings - 1, into);
    divide(spacing, line, half, to, halvings - 1, into);
    return;
  }
  into.push_back(to);
}
}  // namespace

Spacing::Spacing(const std::vector<SurfaceLine>& lines) : lines_(lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const LinePoint& point : lines[i]) {
      widest_ = std::max(widest_, distance(i, point.place));
    }
  }
}

double Spacing::distance(std::size_t line, const Vec3& place) const {
  double sum = 0.0;
  int count = 0;
  if (line > 0) {
    sum += distanceTo(lines_[line - 1], place);
    ++count;
  }
  if (line + 1 < lines_.size()) {
    sum += distanceTo(lines_[line + 1], place);
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

double Spacing::share(std::size_t line, const Vec3& place) const {
  const double share = widest_ > 0.0 ? distance(line, place) / widest_ : 1.0;
  return share >= parallel ? 1.0 : std::max(share, nearest);
}

SurfaceLine divided(const Spacing& spacing,
                    std::size_t line,
                    const LinePoint& from,
                    const LinePoint& to) {
  SurfaceLine pieces = {from};
  divide(spacing, line, from, to, mostHalvings, pieces);
  return pieces;
}

}  // namespace arelem::spray
