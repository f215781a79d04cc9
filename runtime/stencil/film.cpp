#include "runtime/stencil/film.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::stencil {

namespace {
/// Film over the mean film at the share `s` of a cell's lines.
double filmAt(const PaintedCell& cell, double s, double fan, double rate) {
  const double paint = paintAt(s, steepnessOf(cell.tilt, fan)) * cell.seconds;
  const auto [a, b] = cell.lines();
  const Balance balance = balanceOf(a, b);
  const double area = balance.area * std::abs(1.0 + balance.lean * (2.0 * s - 1.0));
  return area > tolerance::rounding ? paint / area / rate : 1.0;
}
}  // namespace

std::vector<PaintedCell> cellsOf(std::span<const Track> tracks, const FanGun& gun) {
  std::vector<PaintedCell> cells;
  for (const Track& track : tracks) {
    for (std::size_t i = track.first; i + 1 < track.poses.size(); ++i) {
      const Pose& a = track.poses[i];
      const Pose& b = track.poses[i + 1];
      PaintedCell cell;
      cell.track = &track;
      cell.pose = i;
      cell.tilt = 0.5 * (a.tilt + b.tilt);
      cell.area = areaOf(a.line, b.line);
      const Vec3 way(b.place.x() - a.place.x(), b.place.y() - a.place.y(), b.height - a.height);
      cell.seconds = way.norm() / a.speed;
      cell.share = areaShare(a.line, b.line, shareOf(cell.tilt, gun.fan));
      cells.push_back(cell);
    }
  }
  return cells;
}

double meanRate(std::span<const PaintedCell> cells) {
  double area = 0.0;
  double seconds = 0.0;
  for (const PaintedCell& cell : cells) {
    if (cell.area > tolerance::rounding) {
      area += cell.area;
      seconds += cell.seconds;
    }
  }
  return area > 0.0 ? seconds / area : 0.0;
}

Evenness evennessOf(std::span<const Track> tracks, const FanGun& gun) {
  const std::vector<PaintedCell> cells = cellsOf(tracks, gun);
  const double rate = meanRate(cells);
  Evenness result;
  double within = 0.0;
  for (const PaintedCell& cell : cells) {
    if (cell.area <= tolerance::rounding) {
      continue;
    }
    ++result.cells;
    result.area += cell.area;
    result.leastShare = std::min({result.leastShare, cell.share, 100.0 - cell.share});
    result.mostShare = std::max({result.mostShare, cell.share, 100.0 - cell.share});
    const double mean = cell.seconds / cell.area / rate;
    const auto [a, b] = cell.lines();
    for (const double strip : filmOf(balanceOf(a, b).lean, steepnessOf(cell.tilt, gun.fan))) {
      const double film = mean * strip;
      result.film.add({film, film});
      constexpr double tenPercent = 0.1;
      within += std::abs(film - 1.0) <= tenPercent ? cell.area / stripsOfACell : 0.0;
    }
  }
  result.withinTenPercent = result.area > 0.0 ? within / result.area : 1.0;
  return result;
}

std::vector<FilmPatch> filmPatches(std::span<const Track> tracks, const FanGun& gun) {
  const std::vector<PaintedCell> cells = cellsOf(tracks, gun);
  const double rate = meanRate(cells);
  const auto joined = [&](std::size_t i, std::size_t k) {
    return k < cells.size() && cells[i].track == cells[k].track;
  };
  std::vector<FilmPatch> patches;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].area <= tolerance::rounding) {
      continue;
    }
    const auto [a, b] = cells[i].lines();
    // At a line the film is the mean of the cells beside it.
    const auto film = [&](std::size_t neighbor, double s) {
      const double own = filmAt(cells[i], s, gun.fan, rate);
      const bool mean = joined(i, neighbor) && cells[neighbor].area > tolerance::rounding;
      return mean ? 0.5 * (own + filmAt(cells[neighbor], s, gun.fan, rate)) : own;
    };
    for (int k = 0; k < stripsOfACell; ++k) {
      const double low = static_cast<double>(k) / stripsOfACell;
      const double high = static_cast<double>(k + 1) / stripsOfACell;
      const auto at = [](const Line& line, double s) -> Vec2 {
        return line.first + s * (line.second - line.first);
      };
      FilmPatch patch;
      patch.cell = i;
      patch.corner = {at(a, low), at(a, high), at(b, high), at(b, low)};
      patch.film = {film(i - 1, low), film(i - 1, high), film(i + 1, high), film(i + 1, low)};
      patches.push_back(patch);
    }
  }
  return patches;
}

}  // namespace arelem::stencil
