#pragma once
#include <cmath>
#include <random>
#include <vector>

namespace arelem::motion {

/// Flat, ball, bull-nose, and tapered with a corner arc that is a tangent of the side.
inline const std::vector<std::vector<double>> cutters = [] {
  const double beta = 8.0 * std::acos(-1.0) / 180.0;
  const double e = 0.375 - 0.125 * (1.0 - std::sin(beta)) / std::cos(beta);
  return std::vector<std::vector<double>>{
      {0.75}, {0.75, 0.375}, {1.0, 0.1875}, {0.75, 0.125, e, 0.125, 0, 8, 3}};
}();

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double in(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine_); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace arelem::motion
