#include "runtime/geometry/polynomial.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::geometry {

double evaluate(std::span<const double> coefficients, double t) {
  double value = 0.0;
  for (std::size_t i = coefficients.size(); i-- > 0;) {
    value = value * t + coefficients[i];
  }
  return value;
}

namespace {

/// A value this small may be rounding of the terms.
double roundingAt(std::span<const double> coefficients, double t) {
  double sum = 0.0;
  double power = 1.0;
  for (const double c : coefficients) {
    sum += std::abs(c) * power;
    power *= std::abs(t);
  }
  return tolerance::rounding * sum;
}

double bisect(std::span<const double> coefficients, double low, double high, bool rising) {
  constexpr int steps = 200;
  for (int i = 0; i < steps; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) {
      break;
    }
    ((evaluate(coefficients, middle) < 0.0) == rising ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::vector<double> derivativeOf(std::span<const double> coefficients) {
  std::vector<double> derivative;
  for (std::size_t i = 1; i < coefficients.size(); ++i) {
    derivative.push_back(static_cast<double>(i) * coefficients[i]);
  }
  return derivative;
}

}  // namespace

std::vector<double> rootsWithin(std::span<const double> coefficients, double low, double high) {
  while (!coefficients.empty() && coefficients.back() == 0.0) {
    coefficients = coefficients.first(coefficients.size() - 1);
  }
  std::vector<double> roots;
  if (coefficients.size() < 2) {
    return roots;
  }
  std::vector<double> stops = rootsWithin(derivativeOf(coefficients), low, high);
  stops.insert(stops.begin(), low);
  stops.push_back(high);
  const auto add = [&](double root) {
    if (roots.empty() || root > roots.back()) {
      roots.push_back(root);
    }
  };
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const double here = evaluate(coefficients, stops[i]);
    if (std::abs(here) <= roundingAt(coefficients, stops[i])) {
      add(stops[i]);
      continue;
    }
    if (i + 1 == stops.size()) {
      break;
    }
    const double next = evaluate(coefficients, stops[i + 1]);
    if (std::abs(next) > roundingAt(coefficients, stops[i + 1]) && (here < 0.0) != (next < 0.0)) {
      add(bisect(coefficients, stops[i], stops[i + 1], here < 0.0));
    }
  }
  return roots;
}

}  // namespace arelem::geometry
