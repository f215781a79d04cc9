#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/spray/surface/surface_lines.h"

namespace arelem::spray {

namespace {
constexpr double gunNormal = 0.02;  // rad
/// How far a point lies from the chord, as a share of what is allowed: its place, and its normal
/// from what lies between those of the ends.
double off(const LinePoint& from, const LinePoint& p, const LinePoint& to, double chord) {
  const Vec3 step = to.place - from.place;
  const Vec3 arm = p.place - from.place;
  const double square = step.squaredNorm();
  const double t = square > 0.0 ? std::clamp(arm.dot(step) / square, 0.0, 1.0) : 0.0;
  const Vec3 between = from.normal + t * (to.normal - from.normal);
  const double turned = std::atan2(between.cross(p.normal).norm(), between.dot(p.normal));
  return std::max((arm - t * step).norm() / chord, turned / gunNormal);
}
}  // namespace

SurfaceLine thinned(const SurfaceLine& line, double chord) {
  std::vector<bool> keep(line.size(), false);
  keep.front() = keep.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> pieces = {{0, line.size() - 1}};
  while (!pieces.empty()) {
    const auto [from, to] = pieces.back();
    pieces.pop_back();
    double farthest = 1.0;
    std::size_t at = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double distance = off(line[from], line[i], line[to], chord);
      if (distance > farthest) {
        farthest = distance;
        at = i;
      }
    }
    if (at != from) {
      keep[at] = true;
      pieces.emplace_back(from, at);
      pieces.emplace_back(at, to);
    }
  }
  SurfaceLine result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (keep[i]) {
      result.push_back(line[i]);
    }
  }
  return result;
}

void appendToAndFro(std::vector<SurfaceLine>& lines, SurfaceLine line) {
  if (!lines.empty()) {
    const Vec3& end = lines.back().back().place;
    if ((line.back().place - end).norm() < (line.front().place - end).norm()) {
      std::reverse(line.begin(), line.end());
    }
  }
  lines.push_back(std::move(line));
}

}  // namespace arelem::spray
