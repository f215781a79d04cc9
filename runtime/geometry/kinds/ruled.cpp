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

double Ruled::bend(const Vec3&, const Foot& foot, const Vec3& t, Hint& hint) const {
  if (!hint.valid) {
    return 0.0;
  }
  return sheetBend(sheet_->at(hint.f, hint.g), foot.normal, foot.distance, t);
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
  const auto a = range(first_, f, halfF);
  const auto b = range(second_, f, halfF);
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
  const auto along = [&](const RuledCurve& curve, const CurveRange& range, double weight,
                         Bends& sum) {
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
