#include "app/decimals_seen.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace arelem::app {

namespace {
double unitOf(int decimals) {
  return std::pow(10.0, -decimals);
}

/// A number of so many decimals, but for the rounding of its binary form.
bool fits(double value, int decimals) {
  constexpr double binary = 1e-9;  // of the last decimal
  const double units = value / unitOf(decimals);
  return std::abs(units - std::round(units)) <= binary * std::max(1.0, std::abs(units) * 1e-3);
}
}  // namespace

void DecimalsSeen::accept(const cl::Record& record) {
  if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
    const std::size_t stride = motion->stride();
    for (std::size_t i = 0; i < motion->coordinates.size(); ++i) {
      while (i % stride < 3 && decimals_ <= most && !fits(motion->coordinates[i], decimals_)) {
        ++decimals_;
      }
    }
  }
  next_.accept(record);
}

}  // namespace arelem::app
