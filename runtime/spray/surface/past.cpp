#include "runtime/spray/surface/past.h"

#include <algorithm>
#include <cmath>

#include "ir/space/spray_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/spray/surface/walls.h"

namespace arelem::spray {

namespace {
/// The place where a line goes on beyond `end`; none where it may not.
std::optional<LinePoint> beyond(const LinePoint& before, const LinePoint& end, const Past& past) {
  // A chord lies under its arc: what is square to the normal runs along the surface.
  const Vec3 chord = end.place - before.place;
  const Vec3 along = chord - chord.dot(end.normal) * end.normal;
  if (!(along.norm() > tolerance::nullDirection * chord.norm())) {
    return std::nullopt;
  }
  LinePoint point = end;
  point.place += past.length * along.normalized();
  if (past.walls != nullptr) {
    const double low = tolerance::wallLift * past.standOff + past.walls->blur();
    for (const double height : {low, past.standOff}) {
      const Vec3 up = height * end.normal;
      if (past.walls->between(end.place + up, point.place + up)) {
        return std::nullopt;
      }
    }
  }
  return point;
}
}  // namespace

void goPast(SurfaceLine& line,
            const Past& past,
            const Ends& ends,
            const std::function<bool(const LinePoint&)>& onEdge) {
  if (line.size() < 2 ||
      (line.front().place - line.back().place).norm() <= tolerance::coincidence) {
    return;
  }
  const auto goesOn = [&](const LinePoint& end) {
    return onEdge(end) && std::none_of(ends.begin(), ends.end(), [&end](const HalfSpace& side) {
             return std::abs(side.over(end.place)) <= tolerance::coincidence;
           });
  };
  const auto first = goesOn(line.front()) ? beyond(line[1], line.front(), past) : std::nullopt;
  const auto last =
      goesOn(line.back()) ? beyond(line[line.size() - 2], line.back(), past) : std::nullopt;
  if (first) {
    line.insert(line.begin(), *first);
  }
  if (last) {
    line.push_back(*last);
  }
}

SurfaceLine beside(const SurfaceLine& line, double distance, const Vec3& outside) {
  const auto across = [&line](std::size_t i) -> Vec3 {
    const Vec3 along = line[std::min(i + 1, line.size() - 1)].place - line[i > 0 ? i - 1 : 0].place;
    return line[i].normal.cross(along).normalized();
  };
  const double way = across(line.size() / 2).dot(outside) < 0.0 ? -distance : distance;
  SurfaceLine copy = line;
  for (std::size_t i = 0; i < line.size(); ++i) {
    copy[i].place += way * across(i);
  }
  return copy;
}

double lengthOf(const SurfaceLine& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    length += (line[i].place - line[i - 1].place).norm();
  }
  return length;
}

}  // namespace arelem::spray
