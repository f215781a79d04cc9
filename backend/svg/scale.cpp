#include "backend/svg/scale.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace arelem::backend::svg {

Scale::Scale(double least, double most, double ticks) : low(least), high(most) {
  constexpr double narrow = 1e-6;
  if (!(high - low > narrow)) {
    low -= 0.5;
    high += 0.5;
  }
  const double rough = (high - low) / ticks;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double share = rough / power;
  step = power * (share <= 1.0 ? 1.0 : share <= 2.0 ? 2.0 : share <= 5.0 ? 5.0 : 10.0);
  decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
}

void Scale::wide() {
  low = step * std::floor(low / step);
  high = step * std::ceil(high / step);
}

double Scale::firstTick() const {
  return step * std::ceil(low / step);
}

std::string Scale::text(double value) const {
  return fmt::format("{:.{}f}", std::abs(value) < 0.5 * step ? 0.0 : value, decimals);
}

}  // namespace arelem::backend::svg
