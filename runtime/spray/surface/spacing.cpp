#include "runtime/spray/surface/spacing.h"

#include <algorithm>
#include <cmath>

namespace arelem::spray {

namespace {
constexpr double parallel = 0.995;  // shares above it are one: chords and arcs differ as much
constexpr double evenEnough = 0.1;
constexpr double stepOfShare = 0.02;
constexpr int mostHalvings = 6;

constexpr int patience = 8;  // pieces of a line that may lead away before it is near

double distanceTo(const LinePoint& from, const LinePoint& to, const Vec3& place) {
  const Vec3 step = to.place - from.place;
  const Vec3 arm = place - from.place;
  const double square = step.squaredNorm();
  const double t = square > 0.0 ? std::clamp(arm.dot(step) / square, 0.0, 1.0) : 0.0;
  return (arm - t * step).norm();
}

/// The piece of a line that lies over a parameter: from its beginning to `found` excluded.
std::ptrdiff_t pieceOver(const SurfaceLine& line, const Vec2& uv) {
  const Vec2 way = line.back().uv - line.front().uv;
  const Eigen::Index along = std::abs(way.x()) > std::abs(way.y()) ? 0 : 1;
  const bool rises = way[along] > 0.0;
  const auto above = std::partition_point(line.begin() + 1, line.end() - 1, [&](const auto& p) {
    return rises ? p.uv[along] < uv[along] : p.uv[along] > uv[along];
  });
  return above - line.begin();
}

double distanceTo(const SurfaceLine& line, const LinePoint& point) {
  if (line.size() < 2) {
    return (line.front().place - point.place).norm();
  }
  const std::ptrdiff_t start = pieceOver(line, point.uv);
  double least = HUGE_VAL;
  for (const int way : {1, -1}) {
    int farther = 0;
    for (std::ptrdiff_t i = start;
         i >= 1 && i < static_cast<std::ptrdiff_t>(line.size()) && farther < patience; i += way) {
      const auto end = static_cast<std::size_t>(i);
      const double distance = distanceTo(line[end - 1], line[end], point.place);
      farther = distance < least ? 0 : farther + 1;
      least = std::min(least, distance);
    }
  }
  return least;
}

void divide(const Spacing& spacing,
            std::size_t line,
            const LinePoint& from,
            const LinePoint& to,
            int halvings,
            SurfaceLine& into) {
  if (halvings > 0 && std::abs(spacing.share(line, from) - spacing.share(line, to)) > evenEnough) {
    const LinePoint half = middleOf(from, to);
    divide(spacing, line, from, half, halvings - 1, into);
    divide(spacing, line, half, to, halvings - 1, into);
    return;
  }
  into.push_back(to);
}
}  // namespace

LinePoint middleOf(const LinePoint& a, const LinePoint& b) {
  return {(a.place + b.place) / 2.0, (a.normal + b.normal).normalized(), (a.uv + b.uv) / 2.0};
}

LineSpacing::LineSpacing(const std::vector<SurfaceLine>& lines, double step) : lines_(lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const LinePoint& point : lines[i]) {
      widest_ = std::max(widest_, distance(i, point));
    }
  }
  widest_ = std::min(widest_, step);
}

double LineSpacing::distance(std::size_t line, const LinePoint& point) const {
  double sum = 0.0;
  int count = 0;
  if (line > 0) {
    sum += distanceTo(lines_[line - 1], point);
    ++count;
  }
  if (line + 1 < lines_.size()) {
    sum += distanceTo(lines_[line + 1], point);
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

double LineSpacing::share(std::size_t line, const LinePoint& point) const {
  const double share = widest_ > 0.0 ? distance(line, point) / widest_ : 1.0;
  return share >= parallel ? 1.0 : std::max(share, nearest);
}

double SectionSpacing::share(std::size_t line, const LinePoint& point) const {
  const double share = sections_.apartAt(line, point.place, point.normal) / sections_.step;
  // In steps, so that the triangles of a mesh do not make a feed each.
  const double even = std::round(share / stepOfShare) * stepOfShare;
  return std::clamp(even, nearest, 1.0);
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
