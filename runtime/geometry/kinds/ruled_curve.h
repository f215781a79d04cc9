#pragma once
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "runtime/geometry/kinds.h"

/// The curves that carry a ruled surface. Private to runtime/geometry/kinds/ruled.cpp.
namespace arelem::surface {

/// Rulings kept for each curve distance.
inline constexpr int rulingsOfASpan = 64;
/// How far beyond its end points a curve is followed, in chords.
inline constexpr double reachOfACurve = 1.0;
/// A curve that leaves its base line steeper than this (a section that turns back) ends there.
inline constexpr double steepest = 8.0;
/// Newton's steps from a place between two of a curve's table, which are near, and how near to its
/// carrier it ends, as a share of the coordinates.
inline constexpr int stepsFromTable = 8;
inline constexpr double onCarrier = 2e-15;

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
class RuledCurve {
 public:
  explicit RuledCurve(const geometry::SectionCurve& section) : section_(section) {
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
    tabulate();
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
    if (const auto near = fromTable(f)) {
      return *near;
    }
    const auto place = section_.at(f);
    return place ? derived(*place) : CurvePlace{section_.base(f)};
  }

 private:
  [[nodiscard]] CurvePlace derived(const Vec3& place) const {
    return std::visit(
        [&]<class S>(const S& s) {
          typename S::Hint hint{};
          const Foot foot = s.foot(place, hint);
          return derivedOn(s, place, foot, hint);
        },
        *carrier_);
  }
  /// From n . C' = 0 and C' . H C' + n . C'' = 0, with n and H gradient and Hessian of the distance
  /// to the carrier; C' = chord + s' heading, C'' = s'' heading.
  template <Surface S>
  [[nodiscard]] CurvePlace derivedOn(const S& s,
                                     const Vec3& place,
                                     const Foot& foot,
                                     typename S::Hint& hint) const {
    const Vec3 chord = section_.finish - section_.start;
    const double rise = foot.normal.dot(section_.heading);
    CurvePlace c{place, chord - foot.normal.dot(chord) / rise * section_.heading, Vec3::Zero()};
    c.second = -s.bend(place, foot, c.first, hint) / rise * section_.heading;
    return c;
  }

  /// Heights of the curve over its base line at even fractions, with their slopes: a cubic between
  /// two is so near that Newton needs a step or two.
  void tabulate() {
    const int count = std::max(2, static_cast<int>((high_ - low_) * rulingsOfASpan) + 1);
    const Vec3 chord = section_.finish - section_.start;
    for (int i = 0; i < count; ++i) {
      const double f = low_ + (high_ - low_) * i / (count - 1);
      const auto place = section_.at(f);
      if (!place) {
        heights_.clear();
        return;
      }
      const double squared = section_.heading.squaredNorm();
      heights_.push_back({(*place - section_.base(f)).dot(section_.heading) / squared,
                          (derived(*place).first - chord).dot(section_.heading) / squared});
    }
  }
  /// The place between two of the table; none where Newton does not end there.
  [[nodiscard]] std::optional<CurvePlace> fromTable(double f) const {
    if (heights_.empty() || !(high_ > low_)) {
      return std::nullopt;
    }
    const auto last = static_cast<double>(heights_.size() - 2);
    const double x = (f - low_) / (high_ - low_) * (last + 1.0);
    const double floor = std::clamp(std::floor(x), 0.0, last);
    const auto i = static_cast<std::size_t>(floor);
    const Height& a = heights_[i];
    const Height& b = heights_[i + 1];
    const double t = x - floor;
    const double rest = 1.0 - t;
    const double width = (high_ - low_) / (last + 1.0);
    double height = a.value + t * t * (3.0 - 2.0 * t) * (b.value - a.value) +
                    width * t * rest * (rest * a.slope - t * b.slope);
    const Vec3 base = section_.base(f);
    return std::visit(
        [&]<class S>(const S& s) -> std::optional<CurvePlace> {
          typename S::Hint hint{};
          for (int step = 0; step < stepsFromTable; ++step) {
            const Vec3 place = base + height * section_.heading;
            const Foot foot = s.foot(place, hint);
            if (std::abs(foot.distance) <= onCarrier * (1.0 + place.cwiseAbs().maxCoeff())) {
              return derivedOn(s, place, foot, hint);
            }
            height -= foot.distance / foot.normal.dot(section_.heading);
          }
          return std::nullopt;
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
  struct Height {
    double value, slope;
  };
  std::vector<Height> heights_;
};

}  // namespace arelem::surface
