#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/geometry/kinds/ruled_sheet.h"

/// Bounds of the curvatures of a ruled surface.
namespace arelem::surface {

namespace {
/// The normal of a part of the sheet that is bounded turns by at most this sine, and ways along it
/// are at most this many times as long as straight ones.
constexpr double mostTurn = 0.2;
constexpr double sheetSlack = 1.5;
/// Rows beside the curves grow from this share of their mean width: one much wider than its
/// neighbour seems to be near a place when rows between them are not, as if it were another flank.
constexpr double narrowestBeside = 0.05;
}  // namespace

/// Each reach is looked at by itself: what is one part within a larger one may be several within
/// it, as the flanks of an arch are, and a place next to one may have its foot on another.
Ruled::Sheet::Part Ruled::Sheet::curvatures(double f, double g, double reach) const {
  const Part rows = rowsAbout(at(f, g).place, reach);
  if (!rows.alone) {
    return rows;
  }
  const auto inCells = curvaturesInCells(f, g, reach);
  return {inCells ? inCells : curvaturesAround(f, g, reach)};
}

/// Over the places within `reach`, by way of the parameters there.
std::optional<Bends> Ruled::Sheet::curvaturesAround(double f, double g, double reach) const {
  const SheetPlace s = at(f, g);
  const double area = s.byF.cross(s.byG).norm();
  if (!(area > 0.0)) {
    return std::nullopt;
  }
  const double way = sheetSlack * reach / area;  // along the sheet, through the inverse of its form
  const double halfF = way * s.byG.norm();
  const double halfG = way * s.byF.norm();
  const auto a = range(first_, f, halfF);
  const auto b = range(second_, f, halfF);
  if (!a || !b) {
    return std::nullopt;
  }
  const auto result = curvaturesOf(s, g, halfF, halfG, *a, *b);
  // Ways over a part whose normal turns so little are longer than straight ones by less than that.
  return result && result->stretch * (1.0 + mostTurn * mostTurn) <= sheetSlack
             ? std::optional(result->curvatures)
             : std::nullopt;
}

/// Each is largest or least where both curves and g are at an end of their ranges.
Ruled::Sheet::Seconds Ruled::Sheet::secondsAt(double g,
                                              const CurveRange& a,
                                              const CurveRange& b) const {
  Seconds all{nothing.low, nothing.high, 0.0, std::abs(g) * b.second()};
  double squared = 0.0;
  for (const double x : {(1.0 - g) * a.low, (1.0 - g) * a.high}) {
    for (const double y : {g * b.low, g * b.high}) {
      const double along = x + parallel_ * y;
      all.low = std::min(all.low, along);
      all.high = std::max(all.high, along);
      squared = std::max(squared, along * along + y * y * aside_.squaredNorm());
    }
  }
  all.longest = std::sqrt(squared);
  return all;
}

std::optional<Ruled::Sheet::Change> Ruled::Sheet::changeOver(const SheetPlace& s,
                                                             double g,
                                                             double halfF,
                                                             double halfG,
                                                             const CurveRange& a,
                                                             const CurveRange& b) const {
  Change change;
  change.across = s.byF.cross(s.byG);
  change.area = change.across.norm();
  change.longF = s.byF.norm();
  change.longG = s.byG.norm();
  change.atLow = secondsAt(g - halfG, a, b);
  change.atHigh = secondsAt(g + halfG, a, b);
  change.twist = secondsApart(a, b) * halfF;
  const double twist = s.byFG.norm() + change.twist;
  change.byF = std::max(change.atLow.longest, change.atHigh.longest) * halfF + twist * halfG;
  change.byG = twist * halfF;
  change.ofArea = change.byF * (change.longG + change.byG) + change.longF * change.byG;
  return change.ofArea <= mostTurn * change.area ? std::optional(change) : std::nullopt;
}

/// With S_gg = 0 the second form has the entries n . S_ff and n . S_fg; second derivatives of the
/// curves go along their headings. All is bounded over the box of f and g about a place, by its
/// values there and the largest change of each; `a` and `b` are the ranges of the curves.
std::optional<Ruled::Sheet::Bounded> Ruled::Sheet::curvaturesOf(const SheetPlace& s,
                                                                double g,
                                                                double halfF,
                                                                double halfG,
                                                                const CurveRange& a,
                                                                const CurveRange& b) const {
  const std::optional<Change> change = changeOver(s, g, halfF, halfG, a, b);
  if (!change) {
    return std::nullopt;
  }
  const Vec3 normal = change->across / change->area;
  const double turned = 2.0 * change->ofArea / (2.0 * change->area - change->ofArea);
  // The second derivative is linear in g.
  const double rise = normal.dot(first_.heading());
  const double besides = std::abs(normal.dot(aside_)) + turned * aside_.norm();
  Bends bent = nothing;
  for (const Seconds& at : {change->atLow, change->atHigh}) {
    for (const double n : {rise - turned, rise + turned}) {
      bent.low =
          std::min({bent.low, n * at.low - at.second * besides, n * at.high - at.second * besides});
      bent.high = std::max(
          {bent.high, n * at.low + at.second * besides, n * at.high + at.second * besides});
    }
  }
  const double twisted = std::abs(normal.dot(s.byFG)) + change->twist + turned * s.byFG.norm();
  const double byUnitF = (change->longG + change->byG) / (change->area - change->ofArea);
  const double byUnitG = (change->longF + change->byF) / (change->area - change->ofArea);
  // The most of 2 twisted x y - bending x^2 over the shares x of byF and y of byG in a unit vector:
  // along the ruling nothing bends, and a sheet that bends one way bends little the other way.
  const auto most = [&](double bending) {
    const double x = bending > 0.0 ? std::min(byUnitF, twisted * byUnitG / bending) : byUnitF;
    return std::max(0.0, x * (2.0 * twisted * byUnitG - bending * x));
  };
  return Bounded{{-most(-bent.high), most(bent.low)},
                 std::max(byUnitF / change->longG, byUnitG / change->longF) * change->area};
}

void Ruled::Sheet::makeRows() {
  if (!(low_ < high_)) {
    return;
  }
  const auto add = [&](int number, const auto& edgeAt) {
    std::vector<double> edges;
    for (int i = 0; i <= number; ++i) {
      edges.push_back(edgeAt(static_cast<double>(i) / number));
    }
    addRows(edges);
  };
  const auto beside = [](double share) {
    return reachOfACurve * share * std::lerp(narrowestBeside, 1.0, share);
  };
  add(rowsBeside, [&](double share) { return low_ - beside(1.0 - share); });
  add(std::max(rowsOfABlock, static_cast<int>((high_ - low_) * rowsOfASpan)),
      [&](double share) { return std::lerp(low_, high_, share); });
  add(rowsBeside, [&](double share) { return high_ + beside(share); });
  for (std::size_t i = 0; i < rows_.size(); i += rowsOfABlock) {
    blockStrips_.push_back(rulingsBetween(rows_[i].low, rows_[i + rowsOfABlock - 1].high));
  }
  strips_.assign(rows_.begin(), rows_.end());
  const auto byEights = [](const std::vector<Strip>& strips) {
    std::vector<Eight> eights((strips.size() + rowsOfABlock - 1) / rowsOfABlock);
    for (std::size_t i = 0; i < strips.size(); ++i) {
      eights[i / rowsOfABlock].set(i % rowsOfABlock, strips[i]);
    }
    return eights;
  };
  eights_ = byEights(strips_);
  blockEights_ = byEights(blockStrips_);
  rowCells_ = std::make_unique<CellBends[]>(rows_.size() * cellsOfARow);
  blockCells_ = std::make_unique<CellBends[]>(blockStrips_.size() * cellsOfARow);
  around_ = std::make_unique<Surroundings[]>(blockStrips_.size() * cellsOfARow);
}

/// Whole blocks: where the curves end, rows of one block would know little of each other.
void Ruled::Sheet::addRows(const std::vector<double>& edges) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    rows.push_back(rowBetween(edges[i], edges[i + 1]));
  }
  const auto halve = [this](std::vector<Row>& all, const Row& row) {
    const double middle = 0.5 * (row.low + row.high);
    all.push_back(rowBetween(row.low, middle));
    all.push_back(rowBetween(middle, row.high));
  };
  int halved = 0;
  for (int depth = 0; depth < deepestRow; ++depth) {
    std::vector<Row> finer;
    for (const Row& row : rows) {
      if (row.known || halved >= mostRowsHalved) {
        finer.push_back(row);
      } else {
        ++halved;
        halve(finer, row);
      }
    }
    rows.swap(finer);
  }
  const std::size_t rest = rows.size() % rowsOfABlock;
  const std::size_t halves = rest == 0 ? 0 : rowsOfABlock - rest;
  std::vector<Row> whole;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i < halves) {
      halve(whole, rows[i]);
    } else {
      whole.push_back(rows[i]);
    }
  }
  rows_.insert(rows_.end(), whole.begin(), whole.end());
}

Ruled::Sheet::Strip Ruled::Sheet::rulingsBetween(double low, double high) const {
  const double f = 0.5 * (low + high);
  const double half = 0.5 * (high - low);
  const SheetPlace middle = at(f, 0.0);
  Strip row;
  row.low = low;
  row.high = high;
  row.from = middle.place;
  row.along = middle.byG;
  const auto a = range(first_, f, half);
  const auto b = range(second_, f, half);
  if (a && b) {
    row.first = a->first * half;
    row.second = b->first * half;
    row.twist =
        std::min(row.first + row.second, (middle.byFG.norm() + secondsApart(*a, *b) * half) * half);
  }
  row.length = row.along.norm();
  row.perSquared = row.length > 0.0 ? 1.0 / (row.length * row.length) : 0.0;
  row.kept = row.length > 0.0 ? 1.0 - row.twist / row.length : 0.0;
  row.proper = properPart(f);
  return row;
}

Ruled::Sheet::Row Ruled::Sheet::rowBetween(double low, double high) const {
  const double f = 0.5 * (low + high);
  const double half = 0.5 * (high - low);
  Row row{rulingsBetween(low, high), range(first_, f, half), range(second_, f, half), {}, {}};
  curves(f, row.atFirst, row.atSecond);
  row.known = isKnown(row);
  return row;
}

bool Ruled::Sheet::isKnown(const Row& row) const {
  if (!row.a || !row.b) {
    return false;
  }
  const int begin = cellAt(-1.0);
  for (int k = begin; k < begin + 3 * cellsOfARuling; ++k) {
    const auto [g, halfG] = cellOf(k);
    if (!changeOver(between(row.atFirst, row.atSecond, g), g, 0.5 * (row.high - row.low), halfG,
                    *row.a, *row.b)) {
      return false;
    }
  }
  return true;
}

std::optional<Bends> Ruled::Sheet::curvaturesInCell(const Row& row, int cell) const {
  if (!row.a || !row.b) {
    return std::nullopt;
  }
  const auto [g, halfG] = cellOf(cell);
  const auto bounded = curvaturesOf(between(row.atFirst, row.atSecond, g), g,
                                    0.5 * (row.high - row.low), halfG, *row.a, *row.b);
  return bounded ? std::optional(bounded->curvatures) : std::nullopt;
}

/// Threads that note the same cell at once find the same.
std::optional<Bends> Ruled::Sheet::CellBends::noted(const std::optional<Bends>& bends) {
  high.store(bends ? bends->high : 0.0, std::memory_order_relaxed);
  low.store(bends ? bends->low : unknown, std::memory_order_release);
  return bends;
}

std::optional<Bends> Ruled::Sheet::cellOfRow(std::size_t row, int cell) const {
  CellBends& noted = rowCells_[row * cellsOfARow + static_cast<std::size_t>(cell)];
  return noted.isSeen() ? noted.known() : noted.noted(curvaturesInCell(rows_[row], cell));
}

std::optional<Bends> Ruled::Sheet::cellOfBlock(std::size_t block, int cell) const {
  CellBends& noted = blockCells_[block * cellsOfARow + static_cast<std::size_t>(cell)];
  if (noted.isSeen()) {
    return noted.known();
  }
  std::optional<Bends> all(nothing);
  for (std::size_t i = 0; all && i < rowsOfABlock; ++i) {
    all = hull(all, cellOfRow(block * rowsOfABlock + i, cell));
  }
  return noted.noted(all);
}

/// Widens `all` by the cells of a row within `reach` of a place, and empties it where they are not
/// known; false where none is within reach. A place at g is off the ruling in the middle by at most
/// the spread there, which grows with g by the twist at most.
template <class CellOf>
bool Ruled::Sheet::widenBy(const Strip& row,
                           const CellBends* cells,
                           const CellOf& cellOf,
                           const Vec3& place,
                           double reach,
                           std::optional<Bends>& all) {
  const double length = row.length;
  if (!(length > row.twist)) {
    all.reset();
    return true;
  }
  const auto [g, away] = row.lineTo(place);
  const double most = (reach + row.spreadAt(g)) * length / (length - row.twist);
  const double squared = most * most - away * away;
  if (squared < 0.0) {
    return false;
  }
  const double half = std::sqrt(squared) / length;
  const int from = cellAt(g - half);
  const int to = cellAt(g + half);
  if (from < 0 || to >= cellsOfARow) {
    all.reset();
  }
  if (!all) {
    return true;
  }
  Bends wider = *all;
  for (int k = from; k <= to; ++k) {
    double low = cells[k].low.load(std::memory_order_acquire);
    double high = cells[k].high.load(std::memory_order_relaxed);
    if (low > 0.0) {
      const std::optional<Bends> bends = cellOf(k);
      if (!bends) {
        all.reset();
        return true;
      }
      low = bends->low;
      high = bends->high;
    }
    wider.low = std::min(wider.low, low);
    wider.high = std::max(wider.high, high);
  }
  all = wider;
  return true;
}

bool Ruled::Sheet::widenByRow(std::size_t row,
                              const Vec3& place,
                              double reach,
                              std::optional<Bends>& all) const {
  const auto cellOf = [&](int cell) { return cellOfRow(row, cell); };
  return widenBy(strips_[row], &rowCells_[row * cellsOfARow], cellOf, place, reach, all);
}

bool Ruled::Sheet::widenByBlock(std::size_t block,
                                const Vec3& place,
                                double reach,
                                std::optional<Bends>& all) const {
  const auto cellOf = [&](int cell) { return cellOfBlock(block, cell); };
  return widenBy(blockStrips_[block], &blockCells_[block * cellsOfARow], cellOf, place, reach, all);
}

/// The part of the sheet about a place that is within reach ends, in both directions, at a row that
/// is not: beyond the last row nothing is known.
std::optional<Bends> Ruled::Sheet::curvaturesInCells(double f, double g, double reach) const {
  const auto count = static_cast<int>(rows_.size());
  if (count == 0 || !(f > rows_.front().low && f < rows_.back().high)) {
    return std::nullopt;
  }
  const Vec3 place = at(f, g).place;
  const auto here = std::partition_point(rows_.begin(), rows_.end(),
                                         [&](const Row& row) { return row.high < f; });
  const int middle = std::min(static_cast<int>(here - rows_.begin()), count - 1);
  std::optional<Bends> all(nothing);
  for (const int way : {-1, 1}) {
    int i = way < 0 ? middle : middle + 1;
    for (;;) {
      if (i < 0 || i >= count) {
        return std::nullopt;
      }
      // A block is taken as one where its last row is within reach too.
      const int last = i + way * (rowsOfABlock - 1);
      const int block = i / rowsOfABlock;
      if (last >= 0 && last < count && last / rowsOfABlock == block) {
        std::optional<Bends> wider = all;
        if (widenByRow(static_cast<std::size_t>(last), place, reach, wider) &&
            widenByBlock(static_cast<std::size_t>(block), place, reach, wider) && wider) {
          all = wider;
          i = last + way;
          continue;
        }
      }
      if (!widenByRow(static_cast<std::size_t>(i), place, reach, all)) {
        break;
      }
      if (!all) {
        return std::nullopt;
      }
      i += way;
    }
  }
  return all->low <= all->high ? all : std::nullopt;
}

}  // namespace arelem::surface
