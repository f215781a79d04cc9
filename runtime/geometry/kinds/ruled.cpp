#include "runtime/geometry/kinds/ruled.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Dense>

#include "ir/space/tolerance.h"
#include "runtime/geometry/kinds.h"

namespace arelem::surface {

namespace {
constexpr int newtonLimit = 50;
/// A Newton step of f and g at most this long is the last.
constexpr double smallStep = 1e-8;
/// Rulings kept for each curve distance.
constexpr int rulingsOfASpan = 64;
/// How far beyond its end points a curve is followed, in chords.
constexpr double reachOfACurve = 1.0;
/// The normal of a part of the sheet that is bounded turns by at most this sine, and ways along it
/// are at most this many times as long as straight ones.
constexpr double mostTurn = 0.2;
constexpr double sheetSlack = 1.5;
/// A curve that leaves its base line steeper than this (a section that turns back) ends there.
constexpr double steepest = 8.0;

/// A place of a curve with its derivatives by the fraction.
struct CurvePlace {
  Vec3 place = Vec3::Zero(), first = Vec3::Zero(), second = Vec3::Zero();
};

/// How the derivatives of a curve vary over a range of fractions.
struct CurveRange {
  double first = 0.0;            ///< longest derivative
  double low = 0.0, high = 0.0;  ///< of the second derivative along the heading
  [[nodiscard]] double second() const { return std::max(-low, high); }
};

/// One section curve on its carrier surface.
class Curve {
 public:
  explicit Curve(const geometry::SectionCurve& section) : section_(section) {
    if (section.isPoint()) {
      low_ = -reachOfACurve;
      high_ = 1.0 + reachOfACurve;
      return;
    }
    if (auto carrier = surfaceOf(section.surface)) {
      carrier_ = std::make_unique<AnySurface>(*std::move(carrier));
    }
    const int middle = rulingsOfASpan / 2;
    low_ = extent(middle, -1);
    high_ = extent(middle, 1);
  }

  /// Bounds over the fractions within `reach` of f. None where the carrier turns too much.
  [[nodiscard]] std::optional<CurveRange> range(double f, double reach) const {
    if (section_.isPoint()) {
      return CurveRange{};
    }
    const CurvePlace middle = at(std::clamp(f, low_, high_));
    for (double room = 1.5; room <= 6.0; room *= 2.0) {
      const auto range = rangeWithin(middle, room * middle.first.norm() * reach);
      if (range && range->first <= room * middle.first.norm()) {
        return range;
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] const Vec3& heading() const { return section_.heading; }

  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }

  /// Within [low, high].
  [[nodiscard]] CurvePlace at(double f) const {
    if (section_.isPoint()) {
      return {section_.start, Vec3::Zero(), Vec3::Zero()};
    }
    const auto place = section_.at(f);
    return place ? derived(*place) : CurvePlace{section_.base(f)};
  }

 private:
  /// From n . C' = 0 and C' . H C' + n . C'' = 0, with n and H gradient and Hessian of the distance
  /// to the carrier; C' = chord + s' heading, C'' = s'' heading.
  [[nodiscard]] CurvePlace derived(const Vec3& place) const {
    return std::visit(
        [&]<class S>(const S& s) {
          typename S::Hint hint{};
          const Foot foot = s.foot(place, hint);
          const Vec3 chord = section_.finish - section_.start;
          const double rise = foot.normal.dot(section_.heading);
          CurvePlace c{place, chord - foot.normal.dot(chord) / rise * section_.heading,
                       Vec3::Zero()};
          c.second = -s.bend(place, foot, c.first, hint) / rise * section_.heading;
          return c;
        },
        *carrier_);
  }

  /// The same formulas with all that the carrier may do within `radius` of the place: its normal
  /// turns by at most the bend times the way.
  [[nodiscard]] std::optional<CurveRange> rangeWithin(const CurvePlace& c, double radius) const {
    return std::visit(
        [&]<class S>(const S& s) -> std::optional<CurveRange> {
          typename S::Hint hint{};
          const Foot foot = s.foot(c.place, hint);
          const Bends bends = s.bends(c.place, foot, radius);
          const double turned = std::max(std::abs(bends.low), std::abs(bends.high)) * radius;
          const double rise = foot.normal.dot(section_.heading);
          const double leastRise = std::abs(rise) - turned;
          if (!(leastRise > 0.0)) {
            return std::nullopt;
          }
          const Vec3 chord = section_.finish - section_.start;
          const double aside =
              (std::abs(foot.normal.dot(chord)) + turned * chord.norm()) / leastRise;
          const double squared = chord.squaredNorm() + aside * aside;
          const double most = std::max(0.0, bends.high) * squared / leastRise;
          const double least = std::min(0.0, bends.low) * squared / leastRise;
          return rise > 0.0 ? CurveRange{std::sqrt(squared), -most, -least}
                            : CurveRange{std::sqrt(squared), least, most};
        },
        *carrier_);
  }

  /// The last fraction, walking from the middle of the base line, at which the curve goes on
  /// smoothly.
  [[nodiscard]] double extent(int middle, int way) const {
    const double length = (section_.finish - section_.start).norm();
    const int last = way < 0 ? -rulingsOfASpan : 2 * rulingsOfASpan;
    Vec3 before = section_.at(0.5).value_or(section_.base(0.5));
    double good = 0.5;
    for (int i = middle; i != last + way; i += way) {
      const double f = static_cast<double>(i) / rulingsOfASpan;
      const auto place = section_.at(f);
      if (!place || !(derived(*place).first.norm() <= steepest * length) ||
          (*place - before).norm() > 2.0 * steepest * length / rulingsOfASpan) {
        break;
      }
      before = *place;
      good = f;
    }
    return good;
  }

  geometry::SectionCurve section_;
  std::unique_ptr<AnySurface> carrier_;
  double low_ = 0.0, high_ = 1.0;
};

/// A place of the sheet with all derivatives that the search for a foot needs.
struct SheetPlace {
  Vec3 place, byF, byG, byFF, byFG;
};
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
  }

  [[nodiscard]] SheetPlace at(double f, double g) const {
    CurvePlace a, b;
    curves(f, a, b);
    return {(1.0 - g) * a.place + g * b.place, (1.0 - g) * a.first + g * b.first, b.place - a.place,
            (1.0 - g) * a.second + g * b.second, b.first - a.first};
  }

  /// Bounds of the normal curvatures of the sheet, positive where it bends away from its normal,
  /// within `reach` of the place at f and g. None where it is not smooth or turns too much there.
  [[nodiscard]] std::optional<Bends> curvatures(double f, double g, double reach) const;

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

  Curve first_, second_;
  double low_, high_;
  std::array<CurvePlace, 2> atLow_, atHigh_;
  std::vector<Ruling> rulings_;
};

Ruled::Ruled(const geometry::RuledSurface& surface)
    : sheet_(std::make_shared<const Sheet>(surface)) {}

namespace {
/// Solution of the symmetric system (a b; b c) x = r.
Eigen::Vector2d solved(double a, double b, double c, const Eigen::Vector2d& r) {
  return Eigen::Vector2d(c * r.x() - b * r.y(), a * r.y() - b * r.x()) / (a * c - b * b);
}

struct Descent {
  Eigen::Vector2d step;
  bool newton = true;
};

/// One Newton step on half the squared distance, turned to Gauss-Newton where it is not convex.
Descent descent(const SheetPlace& s, const Vec3& rest) {
  const Eigen::Vector2d slope(rest.dot(s.byF), rest.dot(s.byG));
  const double ff = s.byF.squaredNorm();
  const double fg = s.byF.dot(s.byG);
  const double gg = s.byG.squaredNorm();
  const double a = ff - rest.dot(s.byFF);
  const double b = fg - rest.dot(s.byFG);
  if (a > 0.0 && a * gg - b * b > 0.0) {
    return {solved(a, b, gg, slope), true};
  }
  return {solved(ff, fg, gg, slope), false};
}
}  // namespace

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

double Ruled::bend(const Vec3&, const Foot& foot, const Vec3& t, Hint& hint) const {
  if (!hint.valid) {
    return 0.0;
  }
  const SheetPlace s = sheet_->at(hint.f, hint.g);
  // With first form I and second form L (towards the normal) the shape operator of the distance is
  // -I^-1 L, and that of the parallel surface at d is (I - d L)^-1 (-L), all in the basis byF, byG.
  Eigen::Matrix2d first, second;
  first << s.byF.squaredNorm(), s.byF.dot(s.byG), s.byF.dot(s.byG), s.byG.squaredNorm();
  second << foot.normal.dot(s.byFF), foot.normal.dot(s.byFG), foot.normal.dot(s.byFG), 0.0;
  const Eigen::Vector2d products(s.byF.dot(t), s.byG.dot(t));
  const Eigen::Vector2d components = solved(first(0, 0), first(0, 1), first(1, 1), products);
  const Eigen::Matrix2d parallel = first - foot.distance * second;
  const Eigen::Vector2d carried =
      solved(parallel(0, 0), parallel(0, 1), parallel(1, 1), -second * components);
  return products.dot(carried);
}

Vec3 Ruled::ruling(const Vec3& p) const {
  Hint hint;
  (void)foot(p, hint);
  return sheet_->at(hint.f, hint.g).byG;
}

/// With S_gg = 0 the second form has the entries n . S_ff and n . S_fg; second derivatives of the
/// curves go along their headings. All is bounded over a box of f and g that holds the places
/// within `reach`, by its values in the middle and the largest change of each.
std::optional<Bends> Ruled::Sheet::curvatures(double f, double g, double reach) const {
  const SheetPlace s = at(f, g);
  const Vec3 across = s.byF.cross(s.byG);
  const double area = across.norm();
  const double longF = s.byF.norm();
  const double longG = s.byG.norm();
  if (!(area > 0.0)) {
    return std::nullopt;
  }
  const double way = sheetSlack * reach / area;  // along the sheet, through the inverse of its form
  const double halfF = way * longG;
  const double halfG = way * longF;
  const auto a = first_.range(f, halfF);
  const auto b = second_.range(f, halfF);
  if (!a || !b) {
    return std::nullopt;
  }
  const double weightA = std::abs(1.0 - g) + halfG;
  const double weightB = std::abs(g) + halfG;
  const double twistChange = (a->second() + b->second()) * halfF;
  const double twist = s.byFG.norm() + twistChange;
  const double changeF = (weightA * a->second() + weightB * b->second()) * halfF + twist * halfG;
  const double changeG = twist * halfF;
  const double changeArea = changeF * (longG + changeG) + longF * changeG;
  if (!(changeArea <= mostTurn * area)) {
    return std::nullopt;
  }
  const Vec3 normal = across / area;
  const double turned = 2.0 * changeArea / (2.0 * area - changeArea);
  const auto along = [&](const Curve& curve, const CurveRange& range, double weight, Bends& sum) {
    const double middle = normal.dot(curve.heading());
    for (const double n : {middle - turned, middle + turned}) {
      sum.low = std::min({sum.low, weight * n * range.low, weight * n * range.high});
      sum.high = std::max({sum.high, weight * n * range.low, weight * n * range.high});
    }
  };
  Bends ofA{0.0, 0.0};
  Bends ofB{0.0, 0.0};
  for (const double side : {-halfG, halfG}) {
    along(first_, *a, 1.0 - g + side, ofA);
    along(second_, *b, g + side, ofB);
  }
  const double twisted = std::abs(normal.dot(s.byFG)) + twistChange + turned * s.byFG.norm();
  const double byUnitF = (longG + changeG) / (area - changeArea);
  const double byUnitG = (longF + changeF) / (area - changeArea);
  // Ways over a part whose normal turns so little are longer than straight ones by less than that.
  const double stretched = std::max(byUnitF / longG, byUnitG / longF) * area;
  if (!(stretched * (1.0 + mostTurn * mostTurn) <= sheetSlack)) {
    return std::nullopt;
  }
  const double mixed = 2.0 * twisted * byUnitF * byUnitG;
  return Bends{-(ofA.high + ofB.high) * byUnitF * byUnitF - mixed,
               -(ofA.low + ofB.low) * byUnitF * byUnitF + mixed};
}

Bends Ruled::bends(const Vec3& p, const Foot& foot, double radius) const {
  const Bends any = bendsOfAnySet(foot.distance, radius);
  const double away = std::abs(foot.distance);
  const Vec3 on = p - foot.distance * foot.normal;
  Hint hint = sheet_->seedOn(on);
  (void)this->foot(on, hint);
  if (!((sheet_->at(hint.f, hint.g).place - on).norm() <= tolerance::sameSide)) {
    hint = {};
    (void)this->foot(p, hint);
  }
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
