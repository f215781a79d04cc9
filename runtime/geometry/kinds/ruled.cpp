#include "runtime/geometry/kinds/ruled.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ir/space/tolerance.h"
#include "runtime/geometry/kinds/ruled_curve.h"
#include "runtime/geometry/kinds/sheet.h"

namespace arelem::surface {

namespace {
constexpr int newtonLimit = 50;
/// A Newton step of f and g at most this long is the last.
constexpr double smallStep = 1e-8;
/// The normal of a part of the sheet that is bounded turns by at most this sine, and ways along it
/// are at most this many times as long as straight ones.
constexpr double mostTurn = 0.2;
constexpr double sheetSlack = 1.5;
/// Parts of the sheet with known curvatures: rows of rulings for each curve distance, and cells of
/// each for each distance of the curves, from one of those before the first to one behind the last.
constexpr int rowsOfASpan = 128;
constexpr int cellsOfARuling = 4;
constexpr int rulingsBeside = 1;
constexpr int cellsOfARow = cellsOfARuling * (1 + 2 * rulingsBeside);
}  // namespace

class Ruled::Sheet {
 public:
  explicit Sheet(const geometry::RuledSurface& s) : first_(s.first), second_(s.second) {
    low_ = std::max(first_.low(), second_.low());
    high_ = std::min(first_.high(), second_.high());
    atLow_ = {first_.at(low_), second_.at(low_)};
    atHigh_ = {first_.at(high_), second_.at(high_)};
    const int count = std::max(2, static_cast<int>((high_ - low_) * rulingsOfASpan) + 1);
    for (int i = 0; i < count; ++i) {
      const double f = low_ + (high_ - low_) * i / (count - 1);
      rulings_.push_back({f, first_.at(f).place, second_.at(f).place});
    }
    const int rows = std::max(1, static_cast<int>((high_ - low_) * rowsOfASpan));
    for (int i = 0; i < rows && low_ < high_; ++i) {
      rows_.push_back(
          rowAbout(low_ + (high_ - low_) * (i + 0.5) / rows, 0.5 * (high_ - low_) / rows));
    }
  }

  [[nodiscard]] SheetPlace at(double f, double g) const {
    CurvePlace a, b;
    curves(f, a, b);
    return {(1.0 - g) * a.place + g * b.place, (1.0 - g) * a.first + g * b.first, b.place - a.place,
            (1.0 - g) * a.second + g * b.second, b.first - a.first};
  }

  /// Bounds of the normal curvatures of the sheet, positive where it bends away from its normal,
  /// within `reach` of the place at f and g. None where it is not smooth or turns too much there.
  [[nodiscard]] std::optional<Bends> curvatures(double f, double g, double reach) const {
    const auto inCells = curvaturesInCells(f, g, reach);
    return inCells ? inCells : curvaturesAround(f, g, reach);
  }

  /// Fractions from which a search for the foot of p may start.
  [[nodiscard]] Hint seed(const Vec3& p) const { return seed(p, 1); }
  /// The same for a place of the sheet, where every eighth ruling is enough.
  [[nodiscard]] Hint seedOn(const Vec3& place) const { return seed(place, 8); }

 private:
  [[nodiscard]] Hint seed(const Vec3& p, std::size_t every) const {
    Hint best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < rulings_.size(); i += every) {
      const Ruling& r = rulings_[i];
      const Vec3 along = r.to - r.from;
      const double squared = along.squaredNorm();
      const double g = squared > 0.0 ? std::clamp((p - r.from).dot(along) / squared, -reachOfACurve,
                                                  1.0 + reachOfACurve)
                                     : 0.0;
      const double distance = (p - r.from - g * along).squaredNorm();
      if (distance < least) {
        least = distance;
        best = {true, r.f, g};
      }
    }
    return best;
  }

  struct Ruling {
    double f;
    Vec3 from, to;
  };
  /// The rulings within `half` of one, and what is known of them between those beside the curves.
  struct Row {
    double half = 0.0;
    Vec3 from = Vec3::Zero(), along = Vec3::Zero();  ///< of the ruling in the middle
    double first = 0.0, second = 0.0;  ///< how far the others are from it on the curves
    std::array<std::optional<Bends>, cellsOfARow> cells;
  };
  struct Bounded {
    Bends curvatures;
    double stretch = 1.0;  ///< ways along the sheet over straight ones
  };

  [[nodiscard]] Row rowAbout(double f, double half) const;
  [[nodiscard]] std::optional<Bends> curvaturesInCells(double f, double g, double reach) const;
  [[nodiscard]] std::optional<Bends> curvaturesAround(double f, double g, double reach) const;
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
  static bool widenBy(const Row& row, const Vec3& place, double reach, std::optional<Bends>& all);

  /// Bounds of one of the curves as the sheet follows it: beyond its ends the tangents are
  /// straight.
  [[nodiscard]] std::optional<CurveRange> range(const RuledCurve& curve,
                                                double f,
                                                double half) const {
    const double from = std::max(f - half, low_);
    const double to = std::min(f + half, high_);
    return from < to ? curve.range(0.5 * (from + to), 0.5 * (to - from)) : CurveRange{};
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
  double low_, high_;
  std::array<CurvePlace, 2> atLow_, atHigh_;
  std::vector<Ruling> rulings_;
  std::vector<Row> rows_;
};

Ruled::Ruled(const geometry::RuledSurface& surface)
    : sheet_(std::make_shared<const Sheet>(surface)) {}

Foot Ruled::foot(const Vec3& p, Hint& hint) const {
  Hint at = hint.valid ? hint : sheet_->seed(p);
  SheetPlace s = sheet_->at(at.f, at.g);
  for (int i = 0; i < newtonLimit; ++i) {
    const auto [step, newton] = descent(s, p - s.place);
    if (!step.allFinite()) {
      break;
    }
    // A stride of at most a quarter of the strip keeps to the part of the sheet that is meant.
    const double stride = std::max(1.0, 4.0 * std::abs(step.x()));
    at.f += step.x() / stride;
    at.g += step.y() / stride;
    s = sheet_->at(at.f, at.g);
    // Newton squares the error: what it leaves after a small step is rounding.
    const double size = step.cwiseAbs().maxCoeff();
    if (size <= 1e-15 || (newton && size <= smallStep)) {
      break;
    }
  }
  at.valid = true;
  hint = at;
  const Vec3 across = s.byF.cross(s.byG);
  const double length = across.norm();
  const Vec3 normal = length > 0.0 ? Vec3(across / length) : Vec3(s.byG.unitOrthogonal());
  return {(p - s.place).dot(normal), normal};
}

Vec3 Ruled::turn(const Vec3&, const Foot& foot, const Vec3& t, Hint& hint) const {
  return hint.valid ? sheetTurn(sheet_->at(hint.f, hint.g), foot.normal, foot.distance, t)
                    : Vec3(Vec3::Zero());
}

Vec3 Ruled::ruling(const Vec3& p) const {
  Hint hint;
  (void)foot(p, hint);
  return sheet_->at(hint.f, hint.g).byG;
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
  const double weightA = std::abs(1.0 - g) + halfG;
  const double weightB = std::abs(g) + halfG;
  const double twistChange = secondsApart(a, b) * halfF;
  const double twist = s.byFG.norm() + twistChange;
  const double changeF = (weightA * a.second() + weightB * b.second()) * halfF + twist * halfG;
  const double changeG = twist * halfF;
  const double changeArea = changeF * (longG + changeG) + longF * changeG;
  if (!(changeArea <= mostTurn * area)) {
    return std::nullopt;
  }
  const Vec3 normal = across / area;
  const double turned = 2.0 * changeArea / (2.0 * area - changeArea);
  constexpr double none = std::numeric_limits<double>::infinity();
  const auto along = [&](const RuledCurve& curve, const CurveRange& range, double weight) {
    const double middle = normal.dot(curve.heading());
    Bends part{none, -none};
    for (const double n : {weight * (middle - turned), weight * (middle + turned)}) {
      part.low = std::min({part.low, n * range.low, n * range.high});
      part.high = std::max({part.high, n * range.low, n * range.high});
    }
    return part;
  };
  // At each g the two curves count by their weights, which are linear. Along the ruling nothing
  // bends.
  Bends bent{0.0, 0.0};
  for (const double at : {g - halfG, g + halfG}) {
    const Bends ofA = along(first_, a, 1.0 - at);
    const Bends ofB = along(second_, b, at);
    bent = {std::min(bent.low, ofA.low + ofB.low), std::max(bent.high, ofA.high + ofB.high)};
  }
  const double twisted = std::abs(normal.dot(s.byFG)) + twistChange + turned * s.byFG.norm();
  const double byUnitF = (longG + changeG) / (area - changeArea);
  const double byUnitG = (longF + changeF) / (area - changeArea);
  const double mixed = 2.0 * twisted * byUnitF * byUnitG;
  return Bounded{{-bent.high * byUnitF * byUnitF - mixed, -bent.low * byUnitF * byUnitF + mixed},
                 std::max(byUnitF / longG, byUnitG / longF) * area};
}

Ruled::Sheet::Row Ruled::Sheet::rowAbout(double f, double half) const {
  const SheetPlace begin = at(f, 0.0);
  Row row{half, begin.place, begin.byG, 0.0, 0.0, {}};
  const auto a = range(first_, f, half);
  const auto b = range(second_, f, half);
  if (!a || !b) {
    return row;
  }
  row.first = a->first * half;
  row.second = b->first * half;
  const double halfG = 0.5 / cellsOfARuling;
  for (int k = 0; k < cellsOfARow; ++k) {
    const double g = (k + 0.5) / cellsOfARuling - rulingsBeside;
    if (const auto bounded = curvaturesOf(at(f, g), g, half, halfG, *a, *b)) {
      row.cells[static_cast<std::size_t>(k)] = bounded->curvatures;
    }
  }
  return row;
}

/// Widens `all` by the cells of a row within `reach` of a place, and empties it where they are not
/// known; false where none is within reach. A place at g is off the ruling in the middle by at most
/// the moves on both curves, each by its weight there.
bool Ruled::Sheet::widenBy(const Row& row,
                           const Vec3& place,
                           double reach,
                           std::optional<Bends>& all) {
  const double length = row.along.norm();
  const double spread = row.first + row.second;
  const Vec3 rest = place - row.from;
  if (!(length > spread)) {
    all.reset();
    return true;
  }
  const double g = rest.dot(row.along) / (length * length);
  const double here = reach + std::abs(1.0 - g) * row.first + std::abs(g) * row.second;
  const double most = here + here / (length - spread) * spread;
  const double squared = most * most - (rest - g * row.along).squaredNorm();
  if (squared < 0.0) {
    return false;
  }
  const double half = std::sqrt(squared) / length;
  const double from = (g - half + rulingsBeside) * cellsOfARuling;
  const double to = (g + half + rulingsBeside) * cellsOfARuling;
  if (!(from >= 0.0 && to < cellsOfARow)) {
    all.reset();
    return true;
  }
  for (auto k = static_cast<std::size_t>(from); all && k <= static_cast<std::size_t>(to); ++k) {
    const auto& cell = row.cells[k];
    all = cell
              ? std::optional(Bends{std::min(all->low, cell->low), std::max(all->high, cell->high)})
              : std::nullopt;
  }
  return true;
}

/// The part of the sheet about a place that is within reach ends, in both directions, at a row that
/// is not: beyond the last row nothing is known.
std::optional<Bends> Ruled::Sheet::curvaturesInCells(double f, double g, double reach) const {
  const auto count = static_cast<int>(rows_.size());
  if (count == 0 || !(f > low_ && f < high_)) {
    return std::nullopt;
  }
  constexpr double none = std::numeric_limits<double>::infinity();
  const Vec3 place = at(f, g).place;
  const int middle = std::min(static_cast<int>((f - low_) / (high_ - low_) * count), count - 1);
  std::optional<Bends> all(Bends{none, -none});
  for (const int way : {-1, 1}) {
    int i = way < 0 ? middle : middle + 1;
    while (i >= 0 && i < count && widenBy(rows_[static_cast<std::size_t>(i)], place, reach, all)) {
      if (!all) {
        return std::nullopt;
      }
      i += way;
    }
    if (i < 0 || i >= count) {
      return std::nullopt;
    }
  }
  return all->low <= all->high ? all : std::nullopt;
}

Bends Ruled::bends(const Vec3& p, const Foot& foot, double radius) const {
  const Vec3 on = p - foot.distance * foot.normal;
  Hint hint = sheet_->seedOn(on);
  (void)this->foot(on, hint);
  if (!((sheet_->at(hint.f, hint.g).place - on).norm() <= tolerance::sameSide)) {
    hint = {};
    (void)this->foot(p, hint);
  }
  return bends(p, foot, radius, hint);
}

Bends Ruled::bends(const Vec3&, const Foot& foot, double radius, const Hint& hint) const {
  const Bends any = bendsOfAnySet(foot.distance, radius);
  const double away = std::abs(foot.distance);
  // Feet of all places within the radius lie within 2 (away + radius) of the foot.
  const auto range = sheet_->curvatures(hint.f, hint.g, 2.0 * (away + radius));
  if (!range) {
    return any;
  }
  const double sharpest = std::max(std::abs(range->low), std::abs(range->high));
  return both(
      any, bendsOfCurvature(*range, foot.distance, radius, sharpest * (away + 3.0 * radius) < 1.0));
}

}  // namespace arelem::surface
