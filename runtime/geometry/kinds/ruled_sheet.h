#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "runtime/geometry/kinds/ruled.h"
#include "runtime/geometry/kinds/ruled_cells.h"
#include "runtime/geometry/kinds/ruled_curve.h"

/// What a ruled surface knows of itself. Private to runtime/geometry/kinds.
namespace arelem::surface {

/// Parts of the sheet with known curvatures: rows of rulings for each curve distance, in cells.
inline constexpr int rowsOfASpan = 128;
inline constexpr int rowsOfABlock = 8;
/// Rows of which not all cells are known are halved, so often and so many.
inline constexpr int deepestRow = 6;
inline constexpr int mostRowsHalved = 128;
/// Rows over the tangents of the curves on each side.
inline constexpr int rowsBeside = 24;
/// More blocks of rows than there can be.
inline constexpr int mostBlocks = 160;

class Ruled::Sheet {
 public:
  explicit Sheet(const geometry::RuledSurface& s)
      : first_(s.first),
        second_(s.second),
        parallel_(s.second.heading.dot(s.first.heading)),
        aside_(s.second.heading - parallel_ * s.first.heading) {
    low_ = std::max(first_.low(), second_.low());
    high_ = std::min(first_.high(), second_.high());
    atLow_ = {first_.at(low_), second_.at(low_)};
    atHigh_ = {first_.at(high_), second_.at(high_)};
    makeRows();
    findEnds();
  }

  [[nodiscard]] SheetPlace at(double f, double g) const {
    CurvePlace a, b;
    curves(f, a, b);
    return between(a, b, g);
  }
  [[nodiscard]] static SheetPlace between(const CurvePlace& a, const CurvePlace& b, double g) {
    return {(1.0 - g) * a.place + g * b.place, (1.0 - g) * a.first + g * b.first, b.place - a.place,
            (1.0 - g) * a.second + g * b.second, b.first - a.first};
  }

  /// True where one formula holds between two fractions.
  [[nodiscard]] bool isSmooth(double f1, double f2) const {
    return std::min(f1, f2) >= low_ && std::max(f1, f2) <= high_ && first_.isSmooth(f1, f2) &&
           second_.isSmooth(f1, f2);
  }

  /// The part of the sheet about a place.
  struct Part {
    /// Bounds of its normal curvatures, positive where it bends away from its normal. None where it
    /// is not smooth or turns too much.
    std::optional<Bends> curvatures;
    bool alone = true;    ///< no other part is as near; else its curvatures are among them
    double joined = 0.0;  ///< it is connected by way of places that are no farther than this
  };
  /// Within `reach` of the place at f and g.
  [[nodiscard]] Part curvatures(double f, double g, double reach) const;

  /// Goes down from the place of the hint to the nearest one about it; f and g are exact then, and
  /// `near` is next to them.
  [[nodiscard]] Foot settle(const Vec3& p, Hint& hint) const;
  /// True where the foot that was settled on is proven to be the nearest place of all.
  [[nodiscard]] bool isNearest(const Foot& foot, const Hint& hint) const;
  /// The foot of p. `known` is one that may not be the nearest place, with its hint; or none.
  [[nodiscard]] Foot nearest(const Vec3& p, const Foot* known, Hint& hint) const;
  /// See ruled_ends.h.
  [[nodiscard]] static double endBefore(const Ruled& surface, const Vec3& p);

 private:
  void findEnds();
  [[nodiscard]] double endBefore(double f, double g) const;
  struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    [[nodiscard]] bool holds(double x) const { return x >= low && x <= high; }
  };
  /// The rulings about one.
  struct Strip {
    double low = 0.0, high = 0.0;                    ///< fractions
    Vec3 from = Vec3::Zero(), along = Vec3::Zero();  ///< of the ruling in the middle
    /// How far the others are from it on the curves, and how much their ways from one curve to the
    /// other differ from its way.
    double first = std::numeric_limits<double>::infinity(), second = first, twist = first;
    double length = 0.0, perSquared = 0.0;  ///< of along, and 1 over its square
    double kept = 0.0;                      ///< 1 - twist / length
    Range proper;

    /// The place of the ruling in the middle next to p, and how far they are apart.
    struct Line {
      double g, away;
    };
    [[nodiscard]] Line lineTo(const Vec3& p) const {
      const Vec3 rest = p - from;
      const double g = rest.dot(along) * perSquared;
      return {g, (rest - g * along).norm()};
    }
    /// How far the places at g of the others may be from that of the ruling in the middle.
    [[nodiscard]] double spreadAt(double g) const {
      return std::min(first + std::abs(g) * twist, second + std::abs(1.0 - g) * twist);
    }
    /// No place of them is nearer to p than this.
    [[nodiscard]] double leastFrom(const Line& line) const {
      return kept > 0.0 ? line.away * kept - spreadAt(line.g)
                        : -std::numeric_limits<double>::infinity();
    }
    /// False where no place of them is within `reach` of p.
    [[nodiscard]] bool isWithin(const Vec3& p, double reach) const {
      return leastFrom(lineTo(p)) <= reach;
    }
  };
  /// Eight strips, number by number: several are looked at with one instruction.
  struct Eight {
    using Numbers = std::array<double, rowsOfABlock>;
    std::array<Numbers, 3> from{}, along{};
    Numbers first{}, second{}, twist{}, perSquared{}, kept{}, low{}, high{};

    void set(std::size_t i, const Strip& strip);
    /// Of each, Strip::lineTo on the proper part of the ruling.
    void properLinesTo(const Vec3& p, Numbers& g, Numbers& away) const;
    /// Of each, Strip::leastFrom of Strip::lineTo.
    void leastFrom(const Vec3& p, Numbers& least) const;
  };
  /// With the curves over them, where that is bounded.
  struct Row : Strip {
    std::optional<CurveRange> a, b;
    CurvePlace atFirst, atSecond;  ///< places of the curves, in the middle
    bool known = false;            ///< what is between the curves and as far beside them
  };
  /// Bounds of the curvatures of a cell.
  struct CellBends {
    /// What `low`, at most 0, is where it was not looked at yet, and where there is no bound.
    static constexpr double unseen = 2.0, unknown = 1.0;
    std::atomic<double> low{unseen}, high{0.0};

    [[nodiscard]] bool isSeen() const { return low.load(std::memory_order_acquire) != unseen; }
    [[nodiscard]] std::optional<Bends> known() const {
      const Bends bends{low.load(std::memory_order_relaxed), high.load(std::memory_order_relaxed)};
      return bends.low != unknown ? std::optional(bends) : std::nullopt;
    }
    std::optional<Bends> noted(const std::optional<Bends>& bends);
  };
  /// What is known about all places of a cell of a block. Part unit; negative where not looked at.
  struct Surroundings {
    /// The nearest place of all to a point at most so far above or below the sheet whose foot is in
    /// the cell is that foot.
    std::atomic<double> above{-1.0}, below{-1.0};
  };
  /// Second derivatives of the sheet by f at one g.
  struct Seconds {
    double low = 0.0, high = 0.0;  ///< along the heading of the first curve
    double longest = 0.0;
    double second = 0.0;  ///< share of the second curve, at most
  };
  /// How much derivatives change at most over a box of f and g.
  struct Change {
    Vec3 across;
    double area, longF, longG;  ///< of it and of byF and byG, in the middle
    Seconds atLow, atHigh;
    double byF, byG, twist, ofArea;
  };
  struct Bounded {
    Bends curvatures;
    double stretch = 1.0;  ///< ways along the sheet over straight ones
  };

  [[nodiscard]] Seconds secondsAt(double g, const CurveRange& a, const CurveRange& b) const;

  void makeRows();
  void addRows(const std::vector<double>& edges);
  [[nodiscard]] Strip rulingsBetween(double low, double high) const;
  [[nodiscard]] Row rowBetween(double low, double high) const;
  [[nodiscard]] bool isKnown(const Row& row) const;
  /// Worked out when they are asked for first: of a row, and of the rows of a block together.
  [[nodiscard]] std::optional<Bends> cellOfRow(std::size_t row, int cell) const;
  [[nodiscard]] std::optional<Bends> cellOfBlock(std::size_t block, int cell) const;
  [[nodiscard]] std::optional<Bends> curvaturesInCell(const Row& row, int cell) const;
  /// Of the rulings where the sheet is not turned over: one that crosses the next goes on behind
  /// the crossing with its sides exchanged.
  [[nodiscard]] Range properPart(double f) const;
  /// The block of the ruling at f, or that next to it.
  [[nodiscard]] std::size_t blockOf(double f) const {
    const auto here = std::partition_point(blockStrips_.begin(), blockStrips_.end(),
                                           [&](const Strip& strip) { return strip.high < f; });
    return std::min(static_cast<std::size_t>(here - blockStrips_.begin()), blockStrips_.size() - 1);
  }
  class Lows;
  /// Rulings next to p; `upper` is nearer than which a foot must be.
  [[nodiscard]] Lows lows(const Vec3& p, double upper) const;
  [[nodiscard]] const Surroundings* surroundings(double f, double g) const;
  void lookAround(std::size_t block, int cell, Surroundings& known) const;
  /// What is within reach of a place of a block.
  [[nodiscard]] Part partAbout(std::size_t block, const Vec3& place, double reach) const;
  [[nodiscard]] Part rowsAbout(const Vec3& place, double reach) const;
  void settleAlongRulings(const Vec3& p, Hint& hint) const;
  [[nodiscard]] std::optional<Bends> curvaturesInCells(double f, double g, double reach) const;
  [[nodiscard]] std::optional<Bends> curvaturesAround(double f, double g, double reach) const;
  /// None where the normal turns too much.
  [[nodiscard]] std::optional<Change> changeOver(const SheetPlace& s,
                                                 double g,
                                                 double halfF,
                                                 double halfG,
                                                 const CurveRange& a,
                                                 const CurveRange& b) const;
  [[nodiscard]] std::optional<Bounded> curvaturesOf(const SheetPlace& s,
                                                    double g,
                                                    double halfF,
                                                    double halfG,
                                                    const CurveRange& a,
                                                    const CurveRange& b) const;
  /// How far the second derivatives of the curves may be from each other.
  [[nodiscard]] double secondsApart(const CurveRange& a, const CurveRange& b) const {
    const Vec3 between =
        0.5 * ((b.low + b.high) * second_.heading() - (a.low + a.high) * first_.heading());
    return between.norm() + 0.5 * (a.high - a.low + b.high - b.low);
  }
  template <class CellOf>
  static bool widenBy(const Strip& row,
                      const CellBends* cells,
                      const CellOf& cellOf,
                      const Vec3& place,
                      double reach,
                      std::optional<Bends>& all);
  bool widenByRow(std::size_t row,
                  const Vec3& place,
                  double reach,
                  std::optional<Bends>& all) const;
  bool widenByBlock(std::size_t block,
                    const Vec3& place,
                    double reach,
                    std::optional<Bends>& all) const;

  /// Bounds of one of the curves as the sheet follows it: beyond its ends the tangents are
  /// straight.
  [[nodiscard]] std::optional<CurveRange> range(const RuledCurve& curve,
                                                double f,
                                                double half) const {
    const double from = std::max(f - half, low_);
    const double to = std::min(f + half, high_);
    if (!(from < to)) {
      const auto& ends = f < 0.5 * (low_ + high_) ? atLow_ : atHigh_;
      return CurveRange{ends[&curve == &first_ ? 0 : 1].first.norm(), 0.0, 0.0};
    }
    auto inside = curve.range(0.5 * (from + to), 0.5 * (to - from));
    if (inside && (from > f - half || to < f + half)) {
      inside->low = std::min(inside->low, 0.0);
      inside->high = std::max(inside->high, 0.0);
    }
    return inside;
  }
  static CurvePlace onTangent(const CurvePlace& end, double beyond) {
    return {end.place + beyond * end.first, end.first, Vec3::Zero()};
  }
  void curves(double f, CurvePlace& a, CurvePlace& b) const {
    if (f < low_ || f > high_) {
      const auto& end = f < low_ ? atLow_ : atHigh_;
      const double beyond = f - (f < low_ ? low_ : high_);
      a = onTangent(end[0], beyond);
      b = onTangent(end[1], beyond);
      return;
    }
    a = first_.at(f);
    b = second_.at(f);
  }

  RuledCurve first_, second_;
  double parallel_;  ///< heading of the second curve: so many times that of the first one,
  Vec3 aside_;       ///< and the rest, square to it
  double low_, high_;
  Vec3 middle_ = Vec3::Zero();
  double amidst_ = 0.0;  ///< no end is nearer to it than the root of this
  std::array<CurvePlace, 2> atLow_, atHigh_;
  std::vector<Row> rows_;
  std::vector<Strip> strips_, blockStrips_;  ///< of them, close together
  std::vector<Eight> eights_, blockEights_;  ///< of these
  std::unique_ptr<CellBends[]> rowCells_, blockCells_;
  std::unique_ptr<Surroundings[]> around_;  ///< of the cells of blocks, as they are asked for
};

}  // namespace arelem::surface
