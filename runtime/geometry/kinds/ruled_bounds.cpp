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
}  // namespace

Ruled::Sheet::Part Ruled::Sheet::curvatures(double f, double g, double reach) const {
  Part part{curvaturesInCells(f, g, reach)};
  if (!part.curvatures) {
    part.curvatures = curvaturesAround(f, g, reach);
    return part;
  }
  const Surroundings* known = surroundings(f, g);
  if (known == nullptr || !(known->alone.load(std::memory_order_relaxed) >= reach)) {
    const Part all = partAbout(blockOf(f), at(f, g).place, reach);
    return all.alone ? part : all;
  }
  return part;
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

/// With S_gg = 0 the second form has the entries n . S_ff and n . S_fg; second derivatives of the
/// curves go along their headings. All is bounded over the box of f and g about a place, by its
/// values there and the largest change of each; `a` and `b` are the ranges of the curves.
std::optional<Ruled::Sheet::Bounded> Ruled::Sheet::curvaturesOf(const SheetPlace& s,
                                                                double g,
                                                                double halfF,
                                                                double halfG,
                                                                const CurveRange& a,
                                                                const CurveRange& b) const {
  const Vec3 across = s.byF.cross(s.byG);
  const double area = across.norm();
  const double longF = s.byF.norm();
  const double longG = s.byG.norm();
  const Seconds atLow = secondsAt(g - halfG, a, b);
  const Seconds atHigh = secondsAt(g + halfG, a, b);
  const double twistChange = secondsApart(a, b) * halfF;
  const double twist = s.byFG.norm() + twistChange;
  const double changeF = std::max(atLow.longest, atHigh.longest) * halfF + twist * halfG;
  const double changeG = twist * halfF;
  const double changeArea = changeF * (longG + changeG) + longF * changeG;
  if (!(changeArea <= mostTurn * area)) {
    return std::nullopt;
  }
  const Vec3 normal = across / area;
  const double turned = 2.0 * changeArea / (2.0 * area - changeArea);
  // The second derivative is linear in g.
  const double rise = normal.dot(first_.heading());
  const double besides = std::abs(normal.dot(aside_)) + turned * aside_.norm();
  Bends bent = nothing;
  for (const Seconds& at : {atLow, atHigh}) {
    for (const double n : {rise - turned, rise + turned}) {
      bent.low =
          std::min({bent.low, n * at.low - at.second * besides, n * at.high - at.second * besides});
      bent.high = std::max(
          {bent.high, n * at.low + at.second * besides, n * at.high + at.second * besides});
    }
  }
  const double twisted = std::abs(normal.dot(s.byFG)) + twistChange + turned * s.byFG.norm();
  const double byUnitF = (longG + changeG) / (area - changeArea);
  const double byUnitG = (longF + changeF) / (area - changeArea);
  // The most of 2 twisted x y - bending x^2 over the shares x of byF and y of byG in a unit vector:
  // along the ruling nothing bends, and a sheet that bends one way bends little the other way.
  const auto most = [&](double bending) {
    const double x = bending > 0.0 ? std::min(byUnitF, twisted * byUnitG / bending) : byUnitF;
    return std::max(0.0, x * (2.0 * twisted * byUnitG - bending * x));
  };
  return Bounded{{-most(-bent.high), most(bent.low)},
                 std::max(byUnitF / longG, byUnitG / longF) * area};
}

void Ruled::Sheet::makeRows() {
  if (!(low_ < high_)) {
    return;
  }
  addRows(low_ - reachOfACurve, low_, rowsBeside);
  addRows(low_, high_, std::max(rowsOfABlock, static_cast<int>((high_ - low_) * rowsOfASpan)));
  addRows(high_, high_ + reachOfACurve, rowsBeside);
  for (std::size_t i = 0; i < rows_.size(); i += rowsOfABlock) {
    blocks_.push_back(blockFrom(i));
  }
  strips_.assign(rows_.begin(), rows_.end());
  blockStrips_.assign(blocks_.begin(), blocks_.end());
  const auto byEights = [](const std::vector<Strip>& strips) {
    std::vector<Eight> eights((strips.size() + rowsOfABlock - 1) / rowsOfABlock);
    for (std::size_t i = 0; i < strips.size(); ++i) {
      eights[i / rowsOfABlock].set(i % rowsOfABlock, strips[i]);
    }
    return eights;
  };
  eights_ = byEights(strips_);
  blockEights_ = byEights(blockStrips_);
  around_ = std::make_unique<Surroundings[]>(blocks_.size() * cellsOfARow);
}

/// Whole blocks: where the curves end, rows of one block would know little of each other.
void Ruled::Sheet::addRows(double from, double to, int number) {
  std::vector<Row> rows;
  for (int i = 0; i < number; ++i) {
    rows.push_back(
        rowBetween(from + (to - from) * i / number, from + (to - from) * (i + 1) / number));
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
      if (row.isKnown() || halved >= mostRowsHalved) {
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
  Row row{rulingsBetween(low, high), {}};
  const double f = 0.5 * (low + high);
  const double half = 0.5 * (high - low);
  const auto a = range(first_, f, half);
  const auto b = range(second_, f, half);
  if (!a || !b) {
    return row;
  }
  CurvePlace first, second;
  curves(f, first, second);
  for (int k = 0; k < cellsOfARow; ++k) {
    const auto [g, halfG] = cellOf(k);
    if (const auto bounded = curvaturesOf(between(first, second, g), g, half, halfG, *a, *b)) {
      row.cells[static_cast<std::size_t>(k)] = bounded->curvatures;
    }
  }
  return row;
}

Ruled::Sheet::Row Ruled::Sheet::blockFrom(std::size_t row) const {
  const std::size_t end = row + rowsOfABlock;
  Row block{rulingsBetween(rows_[row].low, rows_[end - 1].high), rows_[row].cells};
  for (std::size_t i = row + 1; i < end; ++i) {
    for (std::size_t k = 0; k < cellsOfARow; ++k) {
      block.cells[k] = hull(block.cells[k], rows_[i].cells[k]);
    }
  }
  return block;
}

/// Widens `all` by the cells of a row within `reach` of a place, and empties it where they are not
/// known; false where none is within reach. A place at g is off the ruling in the middle by at most
/// the spread there, which grows with g by the twist at most.
bool Ruled::Sheet::widenBy(const Row& row,
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
    return true;
  }
  for (int k = from; all && k <= to; ++k) {
    all = hull(all, row.cells[static_cast<std::size_t>(k)]);
  }
  return true;
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
        if (widenBy(rows_[static_cast<std::size_t>(last)], place, reach, wider) &&
            widenBy(blocks_[static_cast<std::size_t>(block)], place, reach, wider) && wider) {
          all = wider;
          i = last + way;
          continue;
        }
      }
      if (!widenBy(rows_[static_cast<std::size_t>(i)], place, reach, all)) {
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
