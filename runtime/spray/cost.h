#pragma once
#include <array>

#include "ir/diag/diagnostic.h"
#include "runtime/spray/units.h"

namespace arelem::spray {

/// Price of gun time and paint (Bartlett 4.2).
struct Prices {
  double time = 0.0;       ///< k1, $/h
  double material = 0.0;   ///< k2, $/l
  double overspray = 0.0;  ///< k3, $/l: disposal of what does not stick
  double sprayBy = 0.0;    ///< k4, $/l: disposal of what misses the work
};

/// Speed and flow of the gun for a mean film.
struct Operation {
  double speed = 0.0;    ///< of the gun while it sprays, mm/s
  double flow = 0.0;     ///< that leaves the gun, mm3/s
  bool limited = false;  ///< the largest flow is reached, so the speed is below the largest
};

/// What limits the gun.
struct GunLimits {
  double speed = 0.0;       ///< largest, mm/s
  double flow = 0.0;        ///< largest, mm3/s; 0: unlimited
  double efficiency = 1.0;  ///< share of the paint that sticks
};

/// Largest speed that the flow allows for a mean film (mm) and passes `interval` (mm) apart:
/// q' = h v s / eta. Source: Bartlett 4.2.3.
[[nodiscard]] Operation operationFor(double film, double interval, const GunLimits& limits);

/// Error E0376: at `speed` (mm/s) the film takes the flow `wanted`, the gun has `largest` (mm3/s).
/// The speed that is offered is `fitting`, rounded down to six digits: one digit more and the flow
/// would be too large again.
[[nodiscard]] Failure tooMuchFlow(double speed, double wanted, double largest, double fitting);

struct PathLengths {
  double painted = 0.0;    ///< X_i, mm
  double unpainted = 0.0;  ///< X_o, mm
  double runUp = 0.0;      ///< of that with the gun switched on early, at the speed of painting
  double runUpTime = 0.0;  ///< how long that takes, s
};

/// The five parts of the process cost, and what they are made of. Source: Bartlett (4.12), (4.14).
/// Where the path sprays less than area times film, all of it counts as film and nothing as
/// spray-by; the source has a negative spray-by there.
struct Cost {
  double paintingTime = 0.0;      ///< T_i, s
  double travelingTime = 0.0;     ///< T_o, s
  std::array<double, 5> parts{};  ///< painting time, other time, overspray, spray-by, film; $
  double total = 0.0;             ///< $
  double used = 0.0;              ///< paint that leaves the gun, mm3
  double deposited = 0.0;         ///< that stays on the work, mm3: area times film at most
  double missing = 0.0;           ///< of area times film, mm3: more than the path sprays
  double overspray = 0.0;         ///< that does not stick, mm3
  double sprayBy = 0.0;           ///< that misses the work, mm3
};
[[nodiscard]] Cost costOf(const PathLengths& path,
                          double area,
                          double film,
                          const Operation& operation,
                          const GunLimits& limits,
                          const Prices& prices);

/// T_min (4.5): no path paints the area faster than the largest flow allows; s.
[[nodiscard]] double shortestTime(double area, double film, const GunLimits& limits);

}  // namespace arelem::spray
