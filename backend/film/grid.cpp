#include "backend/film/grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace arelem::backend {

namespace {
constexpr std::size_t mostCells = 1000;  // in the longer way

/// A place on an edge between two middles: the column and row of its lower end, and whether the
/// edge goes up.
struct EdgeName {
  std::size_t row = 0, column = 0;
  bool up = false;
  auto operator<=>(const EdgeName&) const = default;
};

/// Pieces of a contour by the edges that they end on: at most two at each.
class Pieces {
 public:
  void add(const EdgeName& a, const EdgeName& b, const FilmPicture::Line& ends) {
    places_[a] = ends[0];
    places_[b] = ends[1];
    next_[a].push_back(b);
    next_[b].push_back(a);
  }

  /// Open lines first, then what is closed.
  std::vector<FilmPicture::Line> lines() {
    std::vector<FilmPicture::Line> all;
    for (const bool open : {true, false}) {
      for (auto& [edge, others] : next_) {
        if (others.size() == 1 || (!open && !others.empty())) {
          all.push_back(follow(edge));
        }
      }
    }
    return all;
  }

 private:
  FilmPicture::Line follow(EdgeName at) {
    FilmPicture::Line line = {places_[at]};
    while (!next_[at].empty()) {
      const EdgeName to = next_[at].back();
      next_[at].pop_back();
      std::vector<EdgeName>& back = next_[to];
      back.erase(std::find(back.begin(), back.end(), at));
      line.push_back(places_[to]);
      at = to;
    }
    return line;
  }

  std::map<EdgeName, std::pair<double, double>> places_;
  std::map<EdgeName, std::vector<EdgeName>> next_;
};
}  // namespace

FilmGrid::FilmGrid(const FilmPicture& p) : lowX_(p.lowX), lowY_(p.lowY) {
  const std::size_t step =
      std::max<std::size_t>(1, (std::max(p.columns, p.rows) + mostCells - 1) / mostCells);
  columns_ = (p.columns + step - 1) / step;
  rows_ = (p.rows + step - 1) / step;
  cell_ = p.cell * static_cast<double>(step);
  film_.assign(columns_ * rows_, 0.0);
  work_.assign(film_.size(), false);
  std::vector<std::array<double, 2>> sums(film_.size());
  std::vector<std::array<double, 2>> counts(film_.size());
  for (std::size_t r = 0; r < p.rows; ++r) {
    for (std::size_t c = 0; c < p.columns; ++c) {
      const std::size_t i = r / step * columns_ + c / step;
      const std::size_t from = r * p.columns + c;
      const std::size_t kind = (*p.onWork)[from] ? 1 : 0;
      sums[i][kind] += (*p.film)[from] / p.wanted;
      counts[i][kind] += 1.0;
    }
  }
  for (std::size_t i = 0; i < film_.size(); ++i) {
    const std::size_t kind = counts[i][1] >= counts[i][0] ? 1 : 0;
    work_[i] = kind == 1;
    film_[i] = sums[i][kind] / std::max(counts[i][kind], 1.0);
  }
}

FilmGrid::Sample FilmGrid::sample(double x, double y) const {
  const double c = std::clamp((x - lowX_) / cell_ - 0.5, 0.0, static_cast<double>(columns_ - 1));
  const double r = std::clamp((y - lowY_) / cell_ - 0.5, 0.0, static_cast<double>(rows_ - 1));
  const bool work =
      onWork(static_cast<std::size_t>(std::lround(c)), static_cast<std::size_t>(std::lround(r)));
  const auto c0 = static_cast<std::size_t>(c);
  const auto r0 = static_cast<std::size_t>(r);
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t row = r0; row <= std::min(r0 + 1, rows_ - 1); ++row) {
    for (std::size_t column = c0; column <= std::min(c0 + 1, columns_ - 1); ++column) {
      const double weight = (1.0 - std::abs(c - static_cast<double>(column))) *
                            (1.0 - std::abs(r - static_cast<double>(row)));
      if (onWork(column, row) == work) {
        sum += weight * at(column, row);
        weights += weight;
      }
    }
  }
  return {weights > 0.0 ? sum / weights : 0.0, work};
}

std::vector<FilmPicture::Line> FilmGrid::contour(double level) const {
  Pieces pieces;
  for (std::size_t r = 0; r + 1 < rows_; ++r) {
    for (std::size_t c = 0; c + 1 < columns_; ++c) {
      constexpr std::array<std::array<std::size_t, 2>, 4> corner = {
          {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
      const std::array<EdgeName, 4> names = {
          {{r, c, false}, {r, c + 1, true}, {r + 1, c, false}, {r, c, true}}};
      std::vector<EdgeName> cuts;
      FilmPicture::Line places;
      bool work = true;
      for (std::size_t e = 0; e < 4; ++e) {
        const std::size_t ca = c + corner[e][0];
        const std::size_t ra = r + corner[e][1];
        const std::size_t cb = c + corner[(e + 1) % 4][0];
        const std::size_t rb = r + corner[(e + 1) % 4][1];
        const double a = at(ca, ra);
        const double b = at(cb, rb);
        work = work && onWork(ca, ra);
        if ((a < level) != (b < level)) {
          const double t = (level - a) / (b - a);
          const auto between = [t](std::size_t from, std::size_t to) {
            return static_cast<double>(from) +
                   t * (static_cast<double>(to) - static_cast<double>(from));
          };
          cuts.push_back(names[e]);
          places.emplace_back(x(between(ca, cb)), y(between(ra, rb)));
        }
      }
      for (std::size_t i = 0; work && i + 1 < cuts.size(); i += 2) {
        pieces.add(cuts[i], cuts[i + 1], {places[i], places[i + 1]});
      }
    }
  }
  return pieces.lines();
}

}  // namespace arelem::backend
