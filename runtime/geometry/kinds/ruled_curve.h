#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include <Eigen/LU>

#include "runtime/geometry/kinds.h"

/// The curves that carry a ruled surface. Private to runtime/geometry/kinds/ruled.cpp.
namespace arelem::surface {

/// Rulings kept for each curve distance.
inline constexpr int rulingsOfASpan = 64;
/// How far beyond its end points a curve is followed, in chords.
inline constexpr double reachOfACurve = 1.0;
/// A curve that leaves its base line steeper than this (a section that turns back) ends there, and
/// beyond its end points sooner: near the turn it bends ever more by its fraction, and the rulings
/// between two such curves turn over.
inline constexpr double steepest = 8.0;
inline constexpr double steepestBeyond = 3.0;
/// Coefficients of the polynomial that stands for a curve's height over a span of its fractions.
inline constexpr int curveTerms = 8;
/// Polynomials for each curve distance.
inline constexpr int spansOfACurve = 64;
/// A polynomial stands for the curve where it is this near to it, as a share of the coordinates.
inline constexpr double onCurve = 4e-15;

/// The largest second derivative of a polynomial of so many terms that is at most 1 in [-1, 1]
/// (Markov): n^2 (n^2 - 1) / 3 for degree n.
inline constexpr double secondOfUnit = 784.0;
/// Bounds over more polynomials than this are made of those of the carrier.
inline constexpr double mostSpans = 8.0;
/// How often a span may be halved, and how many may be.
inline constexpr int deepestSpan = 6;
inline constexpr std::size_t mostHalvings = 128;
/// Share of a polynomial's range of fractions by which a range may leave the last.
inline constexpr double sameFraction = 1e-9;

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

/// The range of no values.
inline constexpr Bends nothing{std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity()};
/// Both ranges; none where one of them is not known.
[[nodiscard]] inline std::optional<Bends> hull(const std::optional<Bends>& a,
                                               const std::optional<Bends>& b) {
  return a && b ? std::optional(Bends{std::min(a->low, b->low), std::max(a->high, b->high)})
                : std::nullopt;
}

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
    if (const auto seconds = secondsFromTable(f - reach, f + reach)) {
      CurveRange range{0.0, seconds->low, seconds->high};
      range.first = middle.first.norm() + range.second() * reach;
      return range;
    }
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

  /// True where one polynomial holds at both fractions.
  [[nodiscard]] bool isSmooth(double f1, double f2) const {
    if (spans_.empty()) {
      return section_.isPoint();
    }
    const Span* span = partAt(f1).span;
    return span->good && span == partAt(f2).span;
  }

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

  /// The height over the base line between two fractions, by powers of t in [-1, 1].
  struct Span {
    std::array<double, curveTerms> terms{};
    double off = 0.0;  ///< largest difference from the curve
    bool good = false;
    std::size_t halves = 0;  ///< the first of the two spans over its halves, if it was halved
  };

  /// Heights over even fractions; spans over which no polynomial stands for the curve are halved.
  void tabulate() {
    if (!(high_ > low_)) {
      return;
    }
    even_ = static_cast<std::size_t>(std::max(1.0, (high_ - low_) * spansOfACurve));
    lastEven_ = static_cast<double>(even_ - 1);
    perFraction_ = static_cast<double>(even_) / (high_ - low_);
    struct Bad {
      std::size_t span;
      double from, to;
      int depth;
    };
    std::vector<Bad> bad;
    const auto add = [&](double from, double to, int depth) {
      spans_.push_back(spanOver(from, to));
      if (!spans_.back().good && depth < deepestSpan) {
        bad.push_back({spans_.size() - 1, from, to, depth});
      }
    };
    const double width = (high_ - low_) / static_cast<double>(even_);
    for (std::size_t i = 0; i < even_; ++i) {
      add(low_ + width * static_cast<double>(i), low_ + width * static_cast<double>(i + 1), 0);
    }
    for (std::size_t i = 0; i < std::min(bad.size(), mostHalvings); ++i) {
      const Bad b = bad[i];
      spans_[b.span].halves = spans_.size();
      add(b.from, 0.5 * (b.from + b.to), b.depth + 1);
      add(0.5 * (b.from + b.to), b.to, b.depth + 1);
    }
  }
  [[nodiscard]] std::optional<double> heightAt(double f) const {
    const auto place = section_.at(f);
    return place ? std::optional((*place - section_.base(f)).dot(section_.heading) /
                                 section_.heading.squaredNorm())
                 : std::nullopt;
  }
  /// The polynomial through the heights at the Chebyshev places, ends included: what is left of
  /// them over the straight line between the ends is small, and so is the rounding of its terms.
  [[nodiscard]] Span spanOver(double from, double to) const {
    using Row = Eigen::Matrix<double, curveTerms, 1>;
    using Table = Eigen::Matrix<double, curveTerms, curveTerms>;
    const auto nodeAt = [](int k) { return -std::cos(std::numbers::pi * k / (curveTerms - 1)); };
    static const Table inverse = [&] {
      Table powers;
      for (int k = 0; k < curveTerms; ++k) {
        for (int j = 0; j < curveTerms; ++j) {
          powers(k, j) = std::pow(nodeAt(k), j);
        }
      }
      return Table(powers.inverse());
    }();
    const double middle = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    const auto first = heightAt(from);
    const auto last = heightAt(to);
    if (!first || !last) {
      return {};
    }
    const double mean = 0.5 * (*first + *last);
    const double rise = 0.5 * (*last - *first);
    Row rest = Row::Zero();
    for (int k = 1; k + 1 < curveTerms; ++k) {
      const auto height = heightAt(middle + nodeAt(k) * half);
      if (!height) {
        return {};
      }
      rest[k] = *height - mean - rise * nodeAt(k);
    }
    const Row terms = inverse * rest;
    Span span;
    std::copy(terms.begin(), terms.end(), span.terms.begin());
    span.terms[0] += mean;
    span.terms[1] += rise;
    span.off = onCurve * (1.0 + section_.base(middle).cwiseAbs().maxCoeff() +
                          std::abs(mean) * section_.heading.norm());
    span.good = true;
    for (const double t : {-0.97, -0.6, 0.1, 0.75, 0.97}) {
      const auto height = heightAt(middle + t * half);
      span.good = span.good && height && std::abs(valueOf(span, t)[0] - *height) <= span.off;
    }
    return span;
  }
  /// The height and its first two derivatives by t.
  [[nodiscard]] static std::array<double, 3> valueOf(const Span& span, double t) {
    double value = 0.0;
    double slope = 0.0;
    double half = 0.0;
    for (int k = curveTerms - 1; k >= 0; --k) {
      half = half * t + slope;
      slope = slope * t + value;
      value = value * t + span.terms[static_cast<std::size_t>(k)];
    }
    return {value, slope, 2.0 * half};
  }
  /// The span that holds at a fraction, with the place in it and how t grows with the fraction.
  struct Part {
    const Span* span;
    double t, byF;
  };
  [[nodiscard]] Part partAt(double f) const {
    const double x = (f - low_) * perFraction_;
    const auto number = static_cast<std::size_t>(std::clamp(x, 0.0, lastEven_));
    Part part{&spans_[number], 2.0 * (x - static_cast<double>(number)) - 1.0, 2.0 * perFraction_};
    while (!part.span->good && part.span->halves != 0) {
      const bool upper = part.t > 0.0;
      part = {&spans_[part.span->halves + (upper ? 1 : 0)], 2.0 * part.t + (upper ? -1.0 : 1.0),
              2.0 * part.byF};
    }
    return part;
  }
  [[nodiscard]] std::optional<CurvePlace> fromTable(double f) const {
    if (spans_.empty()) {
      return std::nullopt;
    }
    const Part part = partAt(f);
    if (!part.span->good) {
      return std::nullopt;
    }
    const std::array<double, 3> v = valueOf(*part.span, part.t);
    return CurvePlace{section_.base(f) + v[0] * section_.heading,
                      section_.finish - section_.start + part.byF * v[1] * section_.heading,
                      part.byF * part.byF * v[2] * section_.heading};
  }

  /// The range of the second derivative along the heading between two fractions, all of them where
  /// polynomials stand for the curve. None elsewhere, or where there are many.
  [[nodiscard]] std::optional<Bends> secondsFromTable(double from, double to) const {
    const auto count = static_cast<double>(even_);
    const double byF = 2.0 * count / (high_ - low_);
    const double first = (from - low_) * 0.5 * byF;
    const double last = (to - low_) * 0.5 * byF;
    if (!(first >= -sameFraction && last <= count + sameFraction && last - first <= mostSpans)) {
      return std::nullopt;
    }
    std::optional<Bends> all(nothing);
    for (double i = std::max(0.0, std::floor(first)); i < std::min(last, count); ++i) {
      all = hull(all, secondsOver(spans_[static_cast<std::size_t>(i)], 2.0 * (first - i) - 1.0,
                                  2.0 * (last - i) - 1.0));
    }
    return all ? std::optional(Bends{byF * byF * all->low, byF * byF * all->high}) : std::nullopt;
  }
  /// The same for the part of a span with t in [from, to], by its t. None where the curve is not
  /// known there.
  [[nodiscard]] std::optional<Bends> secondsOver(const Span& span, double from, double to) const {
    from = std::max(from, -1.0);
    to = std::min(to, 1.0);
    if (from > to) {
      return nothing;
    }
    if (span.good || span.halves == 0) {
      return span.good ? std::optional(secondsOf(span, from, to)) : std::nullopt;
    }
    const auto all = hull(secondsOver(spans_[span.halves], 2.0 * from + 1.0, 2.0 * to + 1.0),
                          secondsOver(spans_[span.halves + 1], 2.0 * from - 1.0, 2.0 * to - 1.0));
    return all ? std::optional(Bends{4.0 * all->low, 4.0 * all->high}) : std::nullopt;
  }
  /// The range of the second derivative by t: its value in the middle and the most it changes, and
  /// what the polynomial may be off.
  [[nodiscard]] static Bends secondsOf(const Span& span, double from, double to) {
    double change = 0.0;
    for (int k = 3; k < curveTerms; ++k) {
      change += k * (k - 1) * (k - 2) * std::abs(span.terms[static_cast<std::size_t>(k)]);
    }
    change = 0.5 * (to - from) * change + secondOfUnit * span.off;
    const double middle = valueOf(span, 0.5 * (from + to))[2];
    return {middle - change, middle + change};
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
      const double most = i < 0 || i > rulingsOfASpan ? steepestBeyond : steepest;
      if (!place || !(derived(*place).first.norm() <= most * length) ||
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
  std::vector<Span> spans_;
  std::size_t even_ = 0;  ///< number of those that were not made by halving
  double lastEven_ = 0.0,
         perFraction_ = 0.0;  ///< the number of the last, and of them for each fraction
};

}  // namespace arelem::surface
