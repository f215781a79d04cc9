#include "runtime/film/map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "ir/space/spray_tolerance.h"
#include "runtime/film/surface_map.h"
#include "runtime/spray/offset.h"

namespace arelem::film {

using spray::Sprayed;
using spray::Vec2;

namespace {
/// A painting stroke in the plane of the region.
struct Line {
  Vec2 from, along;
  double length = 0.0;
  double rate = 0.0;  ///< q eta / (v b), mm
};

class Gunwork {
 public:
  explicit Gunwork(const Sprayed& sprayed)
      : profile_(sprayed.gun.profile()),
        along_(sprayed.gun.footprint.along),
        across_(sprayed.gun.footprint.across) {
    const double angle = sprayed.chosen.degrees * std::numbers::pi / 180.0;
    // The gun is not turned from pass to pass: its left side stays where it is.
    left_ = Vec2(-std::sin(angle), std::cos(angle));
    const double flow = sprayed.chosen.operation.flow * sprayed.gun.efficiency;
    for (const spray::Stroke& stroke : sprayed.strokes) {
      const Vec2 from = inPlane(sprayed, stroke.from);
      const Vec2 step = inPlane(sprayed, stroke.to) - from;
      const double length = step.norm();
      if (stroke.painting && length > 0.0) {
        lines_.push_back({from, step / length, length, flow / (stroke.speed * across_)});
      }
    }
  }

  [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }
  [[nodiscard]] double across() const { return across_; }
  [[nodiscard]] double reach() const { return std::max(along_, across_); }

  [[nodiscard]] double filmOf(const Line& line, const Vec2& place) const {
    const Vec2 arm = place - line.from;
    const double u = arm.dot(left_) / across_;
    if (!(std::abs(u) <= 1.0)) {
      return 0.0;
    }
    const double t = arm.dot(line.along);
    const double half = along_ * std::sqrt(1.0 - u * u);
    double share = t >= 0.0 && t <= line.length ? 1.0 : 0.0;
    if (half > 0.0) {
      const double passed = std::min(line.length, t + half) - std::max(0.0, t - half);
      share = std::max(0.0, passed) / (2.0 * half);
    }
    return share > 0.0 ? line.rate * profile_.density(u) * share : 0.0;
  }

 private:
  static Vec2 inPlane(const Sprayed& s, const Vec3& place) {
    return {(place - s.origin3).dot(s.x), (place - s.origin3).dot(s.y)};
  }

  spray::Profile profile_;
  double along_, across_;
  Vec2 left_ = Vec2::UnitY();
  std::vector<Line> lines_;
};

/// The columns of a row whose middles may lie under a line's spray.
std::pair<long, long> columnsUnder(const Map& map, const Line& line, double reach, double y) {
  // Where |distance from the line| <= reach, and not beyond its ends by more than the reach.
  const Vec2 left(-line.along.y(), line.along.x());
  double low = map.low.x();
  double high = map.low.x() + map.cell * static_cast<double>(map.columns);
  const auto clip = [&](const Vec2& direction, double from, double to) {
    const double offset = direction.y() * (y - line.from.y()) - direction.x() * line.from.x();
    if (std::abs(direction.x()) < tolerance::filmRow) {
      if (offset < from || offset > to) {
        high = low - 1.0;
      }
      return;
    }
    const double a = (from - offset) / direction.x();
    const double b = (to - offset) / direction.x();
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  };
  clip(left, -reach, reach);
  clip(line.along, -reach, line.length + reach);
  const auto column = [&map](double x) {
    return static_cast<long>(std::floor((x - map.low.x()) / map.cell));
  };
  return high < low ? std::pair{1L, 0L}
                    : std::pair{std::max(0L, column(low) - 1),
                                std::min(static_cast<long>(map.columns) - 1, column(high) + 1)};
}

void addLine(Map& map, const Gunwork& gun, const Line& line) {
  const double reach = gun.reach();
  const double yFrom = std::min(line.from.y(), line.from.y() + line.length * line.along.y());
  const double yTo = std::max(line.from.y(), line.from.y() + line.length * line.along.y());
  const auto row = [&map](double y) {
    return static_cast<long>(std::floor((y - map.low.y()) / map.cell));
  };
  const long last = std::min(static_cast<long>(map.rows) - 1, row(yTo + reach) + 1);
  for (long r = std::max(0L, row(yFrom - reach) - 1); r <= last; ++r) {
    const double y = map.low.y() + map.cell * (static_cast<double>(r) + 0.5);
    const auto [from, to] = columnsUnder(map, line, reach, y);
    for (long c = from; c <= to; ++c) {
      const auto column = static_cast<std::size_t>(c);
      map.film[static_cast<std::size_t>(r) * map.columns + column] +=
          gun.filmOf(line, map.middle(column, static_cast<std::size_t>(r)));
    }
  }
}

/// The work, what is sprayed beside it and where the gun is switched; of a gun that is much larger
/// than the work not all of that, or the work would be lost between two cells.
struct Window {
  spray::Extent extent;
  bool whole = true;
};
Window windowOf(const Sprayed& s, const Gunwork& gun) {
  constexpr double most = 8.0;  // lengths of the work to each side
  const spray::Extent work = extentOf(s.outline);
  spray::Extent window = work;
  const auto include = [&window](const Vec2& p, double about) {
    window.low = window.low.cwiseMin(p - Vec2::Constant(about)).eval();
    window.high = window.high.cwiseMax(p + Vec2::Constant(about)).eval();
  };
  include(work.low, gun.reach());
  include(work.high, gun.reach());
  for (const Line& line : gun.lines()) {
    include(line.from, gun.reach());
    include(line.from + line.length * line.along, gun.reach());
  }
  const double angle = s.chosen.degrees * std::numbers::pi / 180.0;
  const Eigen::Rotation2Dd back(angle);
  const spray::SprayedArea switched(turned(s.outline, -angle), s.gun.footprint, s.sharpest);
  for (const spray::SprayedArea::Band& band : switched.bands()) {
    for (const Vec2& corner : band.corners) {
      include(back * corner, gun.reach() / cellsOfPass);
    }
  }
  const Vec2 margin = Vec2::Constant(most * (work.high - work.low).maxCoeff());
  const spray::Extent cut = {window.low.cwiseMax(work.low - margin),
                             window.high.cwiseMin(work.high + margin)};
  return {cut, cut.low == window.low && cut.high == window.high};
}

void markWork(Map& map, const spray::Outline& outline) {
  for (std::size_t r = 0; r < map.rows; ++r) {
    const double y = map.middle(0, r).y();
    std::vector<double> crossings;
    for (const spray::Loop& loop : outline.loops) {
      const std::vector<double> own = spray::hits(loop, y);
      crossings.insert(crossings.end(), own.begin(), own.end());
    }
    std::sort(crossings.begin(), crossings.end());
    std::size_t next = 0;
    for (std::size_t c = 0; c < map.columns; ++c) {
      while (next < crossings.size() && crossings[next] < map.middle(c, r).x()) {
        ++next;
      }
      map.onWork[r * map.columns + c] = next % 2 == 1;
    }
  }
}

}  // namespace

void measure(Map& map, double wanted) {
  Statistics& s = map.statistics;
  s.wanted = wanted;
  s.smallest = HUGE_VAL;
  double near = 0.0;
  double far = 0.0;
  for (std::size_t i = 0; i < map.film.size(); ++i) {
    const double film = map.film[i];
    const double area = map.areas.empty() ? map.cell * map.cell : map.areas[i];
    if (!map.onWork[i]) {
      s.outside += film * area;
      continue;
    }
    const double off = std::abs(film / wanted - 1.0);
    s.smallest = std::min(s.smallest, film);
    s.largest = std::max(s.largest, film);
    s.deposited += film * area;
    s.spread.average += off * area;
    s.spread.rms += off * off * area;
    s.spread.largest = std::max(s.spread.largest, off);
    near += off <= 0.1 ? area : 0.0;
    far += film < 0.5 * wanted || film > 2.0 * wanted ? area : 0.0;
    s.area += area;
  }
  if (s.area == 0.0) {
    s.smallest = 0.0;
    return;
  }
  s.mean = s.deposited / s.area;
  s.spread.average /= s.area;
  s.spread.rms = std::sqrt(s.spread.rms / s.area);
  s.within10 = near / s.area;
  s.astray = far / s.area;
}

double filmAt(const Sprayed& sprayed, const Vec2& place) {
  const Gunwork gun(sprayed);
  double film = 0.0;
  for (const Line& line : gun.lines()) {
    film += gun.filmOf(line, place);
  }
  return film;
}

Map mapOf(const Sprayed& sprayed, double cell) {
  if (!sprayed.planar) {
    return surfaceMapOf(sprayed, cell);
  }
  const Gunwork gun(sprayed);
  const Window window = windowOf(sprayed, gun);
  const spray::Extent& extent = window.extent;
  const Vec2 size = extent.high - extent.low;
  Map map;
  map.low = extent.low;
  // A pass is some cells wide, or passes and cells would make a pattern of their own.
  const double fine = std::min(size.maxCoeff() / usualCells, gun.across() / cellsOfPass);
  map.cell = cell > 0.0 ? cell : std::max(fine, size.maxCoeff() / mostUsualCells);
  map.cell = std::max(map.cell, std::sqrt(size.x() * size.y() / static_cast<double>(mostCells)));
  map.columns = static_cast<std::size_t>(std::max(1.0, std::ceil(size.x() / map.cell)));
  map.rows = static_cast<std::size_t>(std::max(1.0, std::ceil(size.y() / map.cell)));
  map.film.assign(map.columns * map.rows, 0.0);
  map.onWork.assign(map.columns * map.rows, false);
  double paint = 0.0;
  for (const Line& line : gun.lines()) {
    addLine(map, gun, line);
    paint += line.rate * gun.across() * line.length;
  }
  markWork(map, sprayed.outline);
  measure(map, sprayed.film);
  if (!window.whole) {  // what flies out of the window falls beside the work too
    map.statistics.outside = paint - map.statistics.deposited;
  }
  return map;
}

}  // namespace arelem::film
