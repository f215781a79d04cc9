#include "runtime/spray/gun.h"

#include <cmath>
#include <numbers>

namespace arelem::spray {

namespace {
constexpr std::size_t fixedNumbers = 13;
constexpr double degree = std::numbers::pi / 180.0;
}  // namespace

Profile Gun::profile() const {
  switch (kind) {
    case Kind::fan:
      return Profile::flat();
    case Kind::table:
      return Profile::normalized(table);
    case Kind::ellipse:
    case Kind::cone:
    case Kind::calibrated:
      break;
  }
  return Profile::ellipse();
}

double Gun::standOffFor(double across) const {
  if (heightSlope > 0.0) {
    return heightAtZero + heightSlope * 2.0 * across;
  }
  return angle > 0.0 ? across / std::tan(angle) : standOff;
}

std::vector<double> Gun::canon() const {
  std::vector<double> values = {static_cast<double>(kind),
                                footprint.along,
                                footprint.across,
                                standOff,
                                flow / literPerMinute,
                                efficiency,
                                speed,
                                static_cast<double>(output),
                                leadOn,
                                leadOff,
                                angle / degree,
                                heightAtZero,
                                heightSlope};
  for (const auto& [place, density] : table) {
    values.push_back(place);
    values.push_back(density);
  }
  return values;
}

Gun Gun::of(std::span<const double> canon) {
  Gun gun;
  gun.kind = static_cast<Kind>(static_cast<int>(canon[0]));
  gun.footprint = {canon[1], canon[2]};
  gun.standOff = canon[3];
  gun.flow = canon[4] * literPerMinute;
  gun.efficiency = canon[5];
  gun.speed = canon[6];
  gun.output = static_cast<int>(canon[7]);
  gun.leadOn = canon[8];
  gun.leadOff = canon[9];
  gun.angle = canon[10] * degree;
  gun.heightAtZero = canon[11];
  gun.heightSlope = canon[12];
  for (std::size_t i = fixedNumbers; i + 1 < canon.size(); i += 2) {
    gun.table.emplace_back(canon[i], canon[i + 1]);
  }
  return gun;
}

double coneRadius(double standOff, double halfAngle) {
  return standOff * std::tan(halfAngle);
}

}  // namespace arelem::spray
