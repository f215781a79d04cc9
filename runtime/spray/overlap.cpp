#include "runtime/spray/overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ir/space/spray_tolerance.h"
#include "ir/space/tolerance.h"

namespace arelem::spray {

namespace {
constexpr int coarseSteps = 100;  // of the overlap, 0 to 1/2
constexpr double golden = 0.6180339887498949;

/// Nodes and weights of Gauss and Legendre's rule of 16 points on 0 ... 1.
const std::array<std::pair<double, double>, 16>& gaussRule() {
  static const std::array<std::pair<double, double>, 16> rule = [] {
    std::array<std::pair<double, double>, 16> made;
    constexpr int n = 16;
    for (int i = 0; i < n; ++i) {
      double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
      double slope = 1.0;
      for (int step = 0; step < 100; ++step) {
        double p0 = 1.0;
        double p1 = x;
        for (int k = 2; k <= n; ++k) {
          const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
          p0 = p1;
          p1 = p2;
        }
        slope = n * (x * p1 - p0) / (x * x - 1.0);
        x -= p1 / slope;
      }
      made[static_cast<std::size_t>(i)] = {(1.0 + x) / 2.0, 1.0 / ((1.0 - x * x) * slope * slope)};
    }
    return made;
  }();
  return rule;
}

/// Places of 0 ... 1 between which the film of the interval is smooth.
std::vector<double> breaks(const Profile& profile, double spacing) {
  // Every pass has its knots at the same places of its interval.
  std::vector<double> places = {0.0, 1.0};
  for (const double knot : profile.knots()) {
    const double t = knot / spacing - std::floor(knot / spacing);
    if (t > 0.0 && t < 1.0) {
      places.push_back(t);
    }
  }
  std::sort(places.begin(), places.end());
  const double same = tolerance::rounding * std::max(1.0, 1.0 / spacing);
  places.erase(std::unique(places.begin(), places.end(),
                           [same](double a, double b) { return b - a < same; }),
               places.end());
  return places;
}

/// The film at t by the passes that reach `inside`. A profile may end with a step: a fan's does.
/// At the end of a smooth piece its passes count with what they have just inside.
double film(const Profile& profile, double spacing, double t, double inside) {
  double sum = 0.0;
  const int reach = static_cast<int>(std::ceil(1.0 / spacing)) + 1;
  for (int k = -reach; k <= reach; ++k) {
    if (std::abs((inside - k) * spacing) < 1.0) {
      sum += profile.density(std::clamp((t - k) * spacing, -1.0, 1.0));
    }
  }
  return sum * spacing;
}

/// A piece on which the film is a straight line: exact.
void measureStraight(double atStart, double atEnd, double length, Uniformity& sums) {
  const double a = std::abs(atStart);
  const double b = std::abs(atEnd);
  const bool crosses = atStart * atEnd < 0.0;
  sums.largest = std::max({sums.largest, a, b});
  sums.average += length * (crosses ? (a * a + b * b) / (a + b) : a + b) / 2.0;
  sums.rms += length * (a * a + atStart * atEnd + b * b) / 3.0;
}

/// The film as a function of x in 0 ... pi on one smooth piece. The cosine takes the square-root
/// ends of an ellipse's profile out of the integrals.
class Piece {
 public:
  Piece(const Profile& profile, double spacing, double from, double to)
      : profile_(profile),
        spacing_(spacing),
        middle_((from + to) / 2.0),
        half_((to - from) / 2.0) {}

  [[nodiscard]] double excess(double x) const {
    return film(profile_, spacing_, middle_ - half_ * std::cos(x), middle_) - 1.0;
  }

  void measure(Uniformity& sums) const {
    if (!profile_.isEllipse()) {
      return measureStraight(excess(0.0), excess(std::numbers::pi), 2.0 * half_, sums);
    }
    std::array<double, 13> cuts{};
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      cuts[i] = std::numbers::pi * static_cast<double>(i) / (cuts.size() - 1.0);
    }
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const double a = excess(cuts[i - 1]);
      const double b = excess(cuts[i]);
      sums.largest = std::max({sums.largest, std::abs(a), std::abs(b)});
      if (a * b < 0.0) {
        const double zero = crossing(cuts[i - 1], cuts[i], a);
        integrate(cuts[i - 1], zero, sums);
        integrate(zero, cuts[i], sums);
      } else {
        integrate(cuts[i - 1], cuts[i], sums);
      }
      if (i + 1 < cuts.size()) {
        sums.largest = std::max(sums.largest, peak(cuts[i - 1], cuts[i + 1]));
      }
    }
  }

 private:
  [[nodiscard]] double crossing(double from, double to, double atFrom) const {
    for (int i = 0; i < 60; ++i) {
      const double middle = (from + to) / 2.0;
      (excess(middle) * atFrom > 0.0 ? from : to) = middle;
    }
    return (from + to) / 2.0;
  }
  void integrate(double from, double to, Uniformity& sums) const {
    for (const auto& [node, weight] : gaussRule()) {
      const double x = from + node * (to - from);
      const double value = excess(x);
      const double w = weight * (to - from) * half_ * std::sin(x);
      sums.average += w * std::abs(value);
      sums.rms += w * value * value;
    }
  }
  /// The largest |excess| between two places, if one lies inside.
  [[nodiscard]] double peak(double from, double to) const {
    const double middle = std::abs(excess((from + to) / 2.0));
    if (middle < std::abs(excess(from)) || middle < std::abs(excess(to))) {
      return 0.0;
    }
    while (to - from > tolerance::filmPeak) {
      const double left = to - golden * (to - from);
      const double right = from + golden * (to - from);
      (std::abs(excess(left)) > std::abs(excess(right)) ? to : from) =
          std::abs(excess(left)) > std::abs(excess(right)) ? right : left;
    }
    return std::abs(excess((from + to) / 2.0));
  }

  const Profile& profile_;
  double spacing_;
  double middle_;
  double half_;
};

double value(const Profile& profile, Measure measure, double overlap) {
  const Uniformity all = uniformity(profile, overlap);
  return measure == Measure::average ? all.average
         : measure == Measure::rms   ? all.rms
                                     : all.largest;
}
}  // namespace

double intervalFilm(const Profile& profile, double overlap, double t) {
  const double spacing = 2.0 * (1.0 - overlap);
  const std::vector<double> places = breaks(profile, spacing);
  const auto above = std::upper_bound(places.begin() + 1, places.end() - 1, t);
  return film(profile, spacing, t, (*(above - 1) + *above) / 2.0);
}

Uniformity uniformity(const Profile& profile, double overlap) {
  const double spacing = 2.0 * (1.0 - overlap);
  Uniformity sums;
  const std::vector<double> places = breaks(profile, spacing);
  for (std::size_t i = 1; i < places.size(); ++i) {
    Piece(profile, spacing, places[i - 1], places[i]).measure(sums);
  }
  sums.rms = std::sqrt(sums.rms);
  return sums;
}

double optimalOverlap(const Profile& profile, Measure measure) {
  constexpr double step = 0.5 / coarseSteps;
  int best = 0;
  double smallest = value(profile, measure, 0.0);
  for (int i = 1; i <= coarseSteps; ++i) {
    const double now = value(profile, measure, i * step);
    if (now < smallest) {
      smallest = now;
      best = i;
    }
  }
  double from = std::max(best - 1, 0) * step;
  double to = std::min(best + 1, coarseSteps) * step;
  double left = to - golden * (to - from);
  double right = from + golden * (to - from);
  double atLeft = value(profile, measure, left);
  double atRight = value(profile, measure, right);
  while (to - from > tolerance::overlap) {
    if (atLeft < atRight) {
      to = right;
      right = left;
      atRight = atLeft;
      left = to - golden * (to - from);
      atLeft = value(profile, measure, left);
    } else {
      from = left;
      left = right;
      atLeft = atRight;
      right = from + golden * (to - from);
      atRight = value(profile, measure, right);
    }
  }
  const double inside = (from + to) / 2.0;
  return value(profile, measure, inside) < smallest ? inside : best * step;
}

}  // namespace arelem::spray
