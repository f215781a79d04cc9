#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "runtime/geometry/kinds/ruled_sheet.h"

/// Which of the feet of a point on a ruled surface is the nearest.
namespace arelem::surface {

namespace {
constexpr double unbounded = std::numeric_limits<double>::infinity();
/// Parts of the sheet about a place that are looked at: the largest, in distances between the ends
/// of a curve, how much smaller each is than the one before, and how many.
constexpr double largestPart = 2.0;
constexpr double smallerPart = 0.8;
constexpr int mostParts = 20;
/// Feet nearer than the best by less than this share of its distance are as near.
constexpr double asNear = 1e-12;
/// Rulings cross where the area of the sheet by f and g falls to this share of that in the middle.
constexpr double crossing = 1e-3;
/// Rulings from which a foot is looked for.
constexpr std::size_t mostStarts = 16;
}  // namespace

/// The normal byF x byG changes linearly along a ruling. Where it all but vanishes the ruling meets
/// the next.
Ruled::Sheet::Range Ruled::Sheet::properPart(double f) const {
  const SheetPlace s = at(f, 0.0);
  const Vec3 start = s.byF.cross(s.byG);
  const Vec3 change = s.byFG.cross(s.byG);
  const Vec3 middle = start + 0.5 * change;
  Range range;
  const double squared = change.squaredNorm();
  if (start.cross(change).squaredNorm() <= crossing * crossing * squared * middle.squaredNorm() &&
      squared > 0.0) {
    const double g = -start.dot(change) / squared;
    (g < 0.5 ? range.low : range.high) = g;
  }
  return range;
}

Ruled::Sheet::Part Ruled::Sheet::partAbout(std::size_t block,
                                           const Vec3& place,
                                           double reach) const {
  Part part{Bends(nothing)};
  const auto count = static_cast<int>(blockStrips_.size());
  const auto middle = static_cast<int>(block);
  for (const int way : {-1, 1}) {
    bool together = true;
    for (int i = way < 0 ? middle : middle + 1; i >= 0 && i < count; i += way) {
      const auto number = static_cast<std::size_t>(i);
      const bool within = widenByBlock(number, place, reach, part.curvatures);
      if (within) {
        const Strip::Line line = blockStrips_[number].lineTo(place);
        part.joined = std::max(part.joined, line.away + blockStrips_[number].spreadAt(line.g));
      }
      part.alone = part.alone && (together || !within);
      together = together && within;
    }
    if (together) {
      part.curvatures.reset();  // beyond the last row nothing is known
    }
  }
  return part;
}

/// The same row by row: blocks beside the curves are wide, and what is near one may be near none of
/// its rows.
Ruled::Sheet::Part Ruled::Sheet::rowsAbout(const Vec3& place, double reach) const {
  Part part{Bends(nothing)};
  int parts = 0;
  bool within = false;
  for (std::size_t block = 0; block < blockStrips_.size(); ++block) {
    const bool near = blockStrips_[block].isWithin(place, reach);
    for (std::size_t i = block * rowsOfABlock; i < (block + 1) * rowsOfABlock; ++i) {
      const bool before = within;
      within = near && strips_[i].isWithin(place, reach);
      parts += within && !before ? 1 : 0;
      if (within) {
        widenByRow(i, place, reach, part.curvatures);
      }
      if (within && (i == 0 || i + 1 == strips_.size())) {
        part.curvatures.reset();  // beyond the last row nothing is known
      }
    }
  }
  part.alone = parts <= 1;
  return part;
}

/// A ball that touches the sheet and is not sharper than the sheet bends towards it holds no place
/// of the part about the place where it touches; and none at all if it is no larger than that part.
/// Flanks of a neck that is narrower than the ball join in a belly behind it that bends no more
/// sharply, and therefore reaches as far as the ball that is just as sharp is wide: a part that is
/// connected by nearer places has no such flanks.
void Ruled::Sheet::lookAround(std::size_t block, int cell, Surroundings& known) const {
  const Strip& row = blockStrips_[block];
  const auto [g, halfG] = cellOf(cell);
  const Vec3 place = row.from + g * row.along;
  const double spread = std::max(row.spreadAt(g - halfG), row.spreadAt(g + halfG));
  const double inCell = spread + halfG * row.along.norm();
  double above = 0.0;
  double below = 0.0;
  double reach = largestPart * (atHigh_[0].place - atLow_[0].place).cwiseAbs().maxCoeff();
  for (int i = 0; i < mostParts && 0.5 * reach > std::min(above, below); ++i) {
    const Part part = partAbout(block, place, reach + inCell);
    const auto ball = [&](double towards) {
      const double sharpest = 1.0 / std::max(0.0, towards);
      return part.joined + inCell < 2.0 * sharpest ? std::min(0.5 * reach, sharpest) : 0.0;
    };
    if (part.curvatures && part.alone) {
      above = std::max(above, ball(-part.curvatures->low));
      below = std::max(below, ball(part.curvatures->high));
    }
    reach *= smallerPart;
  }
  known.below.store(below, std::memory_order_relaxed);
  known.above.store(above, std::memory_order_release);
}

const Ruled::Sheet::Surroundings* Ruled::Sheet::surroundings(double f, double g) const {
  const int cell = cellAt(g);
  if (blockStrips_.empty() || !(cell >= 0 && cell < cellsOfARow && f >= blockStrips_.front().low &&
                                f <= blockStrips_.back().high)) {
    return nullptr;
  }
  const std::size_t block = blockOf(f);
  Surroundings& known = around_[block * cellsOfARow + static_cast<std::size_t>(cell)];
  if (known.above.load(std::memory_order_acquire) < 0.0) {
    lookAround(block, cell, known);
  }
  return &known;
}

bool Ruled::Sheet::isNearest(const Foot& foot, const Hint& hint) const {
  const Surroundings* known = surroundings(hint.f, hint.g);
  return known != nullptr &&
         std::abs(foot.distance) <=
             (foot.distance > 0.0 ? known->above : known->below).load(std::memory_order_relaxed);
}

/// Notes, of rulings one beside the other, those that are nearer than both beside them.
class Ruled::Sheet::Lows {
 public:
  struct Low {
    const Strip* row = nullptr;
    Strip::Line line{0.0, unbounded};
  };
  void take(const Low& next) {
    if (here_.row != nullptr && here_.line.away <= before_ && here_.line.away < next.line.away &&
        count_ < mostStarts) {
      list_[count_++] = here_;
    }
    before_ = here_.line.away;
    here_ = next;
  }
  /// The nearest first.
  [[nodiscard]] std::span<const Low> sorted() {
    take({});
    const auto end = list_.begin() + static_cast<std::ptrdiff_t>(count_);
    std::sort(list_.begin(), end,
              [](const Low& a, const Low& b) { return a.line.away < b.line.away; });
    return {list_.begin(), end};
  }

 private:
  double before_ = unbounded;
  Low here_;
  std::array<Low, mostStarts> list_;
  std::size_t count_ = 0;
};

/// Rows of which no place can be nearer than the best are left out; of the others those whose
/// ruling in the middle is nearer than that of the rows beside them are where feet may be.
Ruled::Sheet::Lows Ruled::Sheet::lows(const Vec3& p, double upper) const {
  static_assert(mostBlocks % rowsOfABlock == 0);
  std::array<Eight::Numbers, mostBlocks / rowsOfABlock> bounds;
  const std::size_t count = blockStrips_.size();
  for (std::size_t i = 0; i < blockEights_.size(); ++i) {
    blockEights_[i].leastFrom(p, bounds[i]);
  }
  const auto least = [&](std::size_t block) {
    return bounds[block / rowsOfABlock][block % rowsOfABlock];
  };
  Eight::Numbers g, away;
  if (upper == unbounded && count > 0) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < count; ++i) {
      first = least(i) < least(first) ? i : first;
    }
    eights_[first].properLinesTo(p, g, away);
    upper = *std::min_element(away.begin(), away.end());
  }
  Lows found;
  for (std::size_t block = 0; block < count; ++block) {
    if (least(block) > upper) {
      found.take({});
      continue;
    }
    eights_[block].properLinesTo(p, g, away);
    for (std::size_t i = 0; i < rowsOfABlock; ++i) {
      found.take({&strips_[block * rowsOfABlock + i], {g[i], away[i]}});
      upper = std::min(upper, away[i]);
    }
  }
  return found;
}

Foot Ruled::Sheet::nearest(const Vec3& p, const Foot* known, Hint& hint) const {
  const auto from = [&](double f, double g, Hint& other) {
    other = {true, f, g, f, g, at(f, g)};
    return settle(p, other);
  };
  if (blockStrips_.empty()) {
    return from(0.5 * (low_ + high_), 0.5, hint);
  }
  const bool isKnown = known != nullptr && std::isfinite(known->distance);
  double best = isKnown ? std::abs(known->distance) : unbounded;
  Foot result = known != nullptr ? *known : Foot{};
  const double old = hint.f;
  Lows found = lows(p, best);
  for (const Lows::Low& low : found.sorted()) {
    const double width = low.row->high - low.row->low;
    const bool again = isKnown && old > low.row->low - width && old < low.row->high + width;
    if (again || low.row->leastFrom(low.row->lineTo(p)) > best) {
      continue;
    }
    Hint other;
    const Foot foot = from(0.5 * (low.row->low + low.row->high), low.line.g, other);
    const double away = std::abs(foot.distance);
    if (away < best * (1.0 - asNear) && (properPart(other.f).holds(other.g) || best == unbounded)) {
      best = away;
      result = foot;
      hint = other;
    }
  }
  return result;
}

}  // namespace arelem::surface
