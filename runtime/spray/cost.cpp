#include "runtime/spray/cost.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ir/diag/spray.h"

namespace arelem::spray {

Operation operationFor(double film, double interval, const GunLimits& limits) {
  const double wanted = film * limits.speed * interval / limits.efficiency;
  if (limits.flow > 0.0 && wanted > limits.flow) {
    return {limits.flow * limits.efficiency / (film * interval), limits.flow, true};
  }
  return {limits.speed, wanted, false};
}

Failure tooMuchFlow(double speed, double wanted, double largest, double fitting) {
  constexpr double digits = 6.0;
  const double unit = std::pow(10.0, std::floor(std::log10(fitting)) + 1.0 - digits);
  const double offered = (std::ceil(fitting / unit) - 1.0) * unit;
  return fail(diag::SprayFlow, speed, wanted / literPerMinute, largest / literPerMinute)
      .withHelp(fmt::format("SPEED, {:.6g} would give the film", offered));
}

Cost costOf(const PathLengths& path,
            double area,
            double film,
            const Operation& operation,
            const GunLimits& limits,
            const Prices& prices) {
  Cost cost;
  cost.paintingTime = path.painted / operation.speed;
  cost.travelingTime = (path.unpainted - path.runUp) / limits.speed + path.runUpTime;
  cost.used = operation.flow * cost.paintingTime;
  cost.overspray = (1.0 - limits.efficiency) * cost.used;
  const double sticks = limits.efficiency * cost.used;
  cost.deposited = std::min(area * film, sticks);
  cost.missing = area * film - cost.deposited;
  cost.sprayBy = sticks - cost.deposited;
  const double hour = prices.time / secondsPerHour;
  const double liter = 1.0 / cubicMillimetersPerLiter;
  cost.parts = {hour * cost.paintingTime, hour * cost.travelingTime,
                (prices.material + prices.overspray) * liter * cost.overspray,
                (prices.material + prices.sprayBy) * liter * cost.sprayBy,
                prices.material * liter * cost.deposited};
  for (const double part : cost.parts) {
    cost.total += part;
  }
  return cost;
}

double shortestTime(double area, double film, const GunLimits& limits) {
  return limits.flow > 0.0 ? area * film / (limits.efficiency * limits.flow) : 0.0;
}

}  // namespace arelem::spray
