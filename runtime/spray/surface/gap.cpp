#include "runtime/spray/surface/gap.h"

#include <cmath>

namespace arelem::spray {

namespace {
constexpr int bins = 1440;
constexpr double degreesOfBin = 360.0 / bins;

int binOf(double degrees) {
  const double turn = degrees - 360.0 * std::floor(degrees / 360.0);
  return static_cast<int>(turn / degreesOfBin) % bins;
}
}  // namespace

std::optional<double> middleOfGap(const std::vector<std::pair<double, double>>& arcs) {
  std::vector<bool> covered(bins, false);
  for (const auto& [from, to] : arcs) {
    const double way = std::remainder(to - from, 360.0);
    const int first = binOf(way >= 0.0 ? from : to);
    const int last = binOf(way >= 0.0 ? to : from);
    for (int i = first;; i = (i + 1) % bins) {
      covered[static_cast<std::size_t>(i)] = true;
      if (i == last) {
        break;
      }
    }
  }
  int longest = 0;
  int end = 0;
  int run = 0;
  for (int i = 0; i < 2 * bins; ++i) {  // twice round: a gap may lie over the end
    run = covered[static_cast<std::size_t>(i % bins)] ? 0 : run + 1;
    if (run > longest && run <= bins) {
      longest = run;
      end = i + 1;
    }
  }
  if (longest == 0) {
    return std::nullopt;
  }
  return (end - longest / 2.0) * degreesOfBin;
}

}  // namespace arelem::spray
