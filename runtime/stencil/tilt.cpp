#include <algorithm>
#include <limits>

#include "runtime/stencil/plan.h"

namespace arelem::stencil {

namespace {
/// What one cell wants.
double wantedBy(const Line& from, const Line& to, TiltRule rule, double fan) {
  switch (rule) {
    case TiltRule::trapezoid:
      return tiltFor(
          trapezoidShare((to.first - from.first).norm(), (to.second - from.second).norm()), fan);
    case TiltRule::quadrilateral:
      return tiltFor(quadrilateralShare(from, to), fan);
    case TiltRule::best:  // see evenestTilts
    case TiltRule::off:
      break;
  }
  return 0.0;
}
}  // namespace

std::vector<double> tiltsOf(const std::vector<Line>& lines,
                            TiltRule rule,
                            double fan,
                            const TiltLimits& limits,
                            const std::vector<double>& seconds) {
  const std::size_t count = lines.size();
  std::vector<double> wanted(count, 0.0);
  if (rule == TiltRule::off || count < 2) {
    return wanted;
  }
  // A line stands between two cells: it takes the mean of what they want.
  double before = 0.0;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const double cell =
        std::clamp(wantedBy(lines[i], lines[i + 1], rule, fan), -limits.most, limits.most);
    wanted[i] = i == 0 ? cell : 0.5 * (before + cell);
    wanted[i + 1] = cell;
    before = cell;
  }
  // The lowest curve above and the highest below that turn no faster than allowed; their mean does
  // not either, and no such curve comes nearer to what is wanted.
  std::vector<double> above = wanted;
  std::vector<double> below = wanted;
  const auto limit = [&](std::size_t i, std::size_t from, double time) {
    above[i] = std::max(above[i], above[from] - limits.rate * time);
    below[i] = std::min(below[i], below[from] + limits.rate * time);
  };
  for (std::size_t i = 1; i < count; ++i) {
    limit(i, i - 1, seconds[i - 1]);
  }
  for (std::size_t i = count - 1; i-- > 0;) {
    limit(i, i + 1, seconds[i]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    wanted[i] = 0.5 * (above[i] + below[i]);
  }
  return wanted;
}

}  // namespace arelem::stencil
