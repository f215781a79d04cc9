#include <algorithm>
#include <cmath>

#include "ir/space/stencil_tolerance.h"
#include "runtime/stencil/film.h"

namespace arelem::stencil {

namespace {
double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Where a place lies between the corners of a patch, 0 to 1 both ways; none outside.
std::optional<Vec2> insideOf(const FilmPatch& patch, const Vec2& place) {
  // Newton on the bilinear form; patches are nearly parallelograms, so that few steps suffice.
  const Vec2 u = patch.corner[1] - patch.corner[0];
  const Vec2 v = patch.corner[3] - patch.corner[0];
  const Vec2 w = patch.corner[2] - patch.corner[3] - u;
  Vec2 t(0.5, 0.5);
  constexpr int steps = 8;
  for (int i = 0; i < steps; ++i) {
    const Vec2 off = patch.corner[0] + t.x() * u + t.y() * v + t.x() * t.y() * w - place;
    const Vec2 alongX = u + t.y() * w;
    const Vec2 alongY = v + t.x() * w;
    const double determinant = cross(alongX, alongY);
    if (determinant == 0.0) {
      return std::nullopt;
    }
    t.x() -= cross(off, alongY) / determinant;
    t.y() -= cross(alongX, off) / determinant;
  }
  const bool inside = t.minCoeff() >= -tolerance::patchEdge &&
                      t.maxCoeff() < 1.0 - tolerance::patchEdge && std::isfinite(t.sum());
  return inside ? std::optional(t) : std::nullopt;
}

void paintPatch(film::Map& map, const FilmPatch& patch, double unit) {
  Vec2 low = patch.corner[0];
  Vec2 high = patch.corner[0];
  for (const Vec2& corner : patch.corner) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const auto first = [&](double place, double from) {
    return static_cast<std::size_t>(std::max(0.0, std::floor((place - from) / map.cell)));
  };
  const std::size_t lastRow = std::min(map.rows, first(high.y(), map.low.y()) + 1);
  const std::size_t lastColumn = std::min(map.columns, first(high.x(), map.low.x()) + 1);
  for (std::size_t row = first(low.y(), map.low.y()); row < lastRow; ++row) {
    for (std::size_t column = first(low.x(), map.low.x()); column < lastColumn; ++column) {
      if (const auto t = insideOf(patch, map.middle(column, row))) {
        const std::size_t i = row * map.columns + column;
        const auto& f = patch.film;
        map.film[i] += unit * ((1.0 - t->y()) * ((1.0 - t->x()) * f[0] + t->x() * f[1]) +
                               t->y() * ((1.0 - t->x()) * f[3] + t->x() * f[2]));
        map.onWork[i] = true;
      }
    }
  }
}
}  // namespace

film::Map filmMap(const std::vector<FilmPatch>& patches, double cell, double meanFilm) {
  film::Map map;
  if (patches.empty()) {
    return map;
  }
  Vec2 low = patches[0].corner[0];
  Vec2 high = low;
  for (const FilmPatch& patch : patches) {
    for (const Vec2& corner : patch.corner) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  }
  const Vec2 size = high - low;
  map.cell = cell > 0.0 ? cell : std::max(size.maxCoeff(), tolerance::mapExtent) / filmCells;
  const double cells = (size.x() / map.cell + 2.0) * (size.y() / map.cell + 2.0);
  if (cells > static_cast<double>(film::mostCells)) {
    map.cell *= std::sqrt(cells / static_cast<double>(film::mostCells));
  }
  map.low = low;
  map.columns = static_cast<std::size_t>(size.x() / map.cell) + 1;
  map.rows = static_cast<std::size_t>(size.y() / map.cell) + 1;
  map.film.assign(map.columns * map.rows, 0.0);
  map.onWork.assign(map.columns * map.rows, false);
  for (const FilmPatch& patch : patches) {
    paintPatch(map, patch, meanFilm);
  }
  film::measure(map, meanFilm);
  return map;
}

}  // namespace arelem::stencil
