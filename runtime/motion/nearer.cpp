#include "runtime/motion/nearer.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::motion {

namespace {
/// Nothing worth a search is nearer than what is missed at first, which tells the least way.
constexpr double leastWay = 1.05;
/// Nor where the first step of Newton foretells the position to this share of the way, which is not
/// so many times the least: it is the nearest but for how gaps bend, and they bend little there.
constexpr double foretold = 0.1, straightWay = 1.4;
/// A way that was not found may be so many times as long.
constexpr double farWay = 3.0;
/// Places from which it begins, as shares of the way that was found.
constexpr std::array shares{0.4, 0.8};
/// Where the conditions leave a choice, found ways are the least but for this share; ways to other
/// places that are shorter by less are as long.
constexpr double sameChoice = 0.9, asLong = 0.999;
/// Steps towards the start along what the conditions leave free.
constexpr int slideLimit = 60;
constexpr double slideEnough = 1e-6;

/// What of a way the conditions leave free, at a place.
Vec3 freeOf(Vec3 way,
            const Settled& at,
            std::span<const Wanted> wanted,
            std::span<const Constraint> constraints) {
  std::array<Vec3, 3> taken;
  std::size_t count = 0;
  const auto take = [&](Vec3 normal) {
    for (std::size_t i = 0; i < count; ++i) {
      normal -= normal.dot(taken[i]) * taken[i];
    }
    if (normal.norm() > tolerance::nullDirection) {
      taken[count++] = normal.normalized();
    }
  };
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    take(at.contacts[i].normal);
  }
  for (const Constraint& c : constraints) {
    take(c.normal);
  }
  for (std::size_t i = 0; i < count; ++i) {
    way -= way.dot(taken[i]) * taken[i];
  }
  return way;
}

/// Towards `from`, along what the conditions leave free.
Settled slid(Settled at,
             const Vec3& from,
             AxisRule& axis,
             std::span<const Wanted> wanted,
             std::span<const Constraint> constraints) {
  double share = 1.0;
  for (int i = 0; i < slideLimit && share > slideEnough; ++i) {
    const Vec3 way = freeOf(from - at.toolEnd, at, wanted, constraints);
    if (way.norm() <= slideEnough) {
      break;
    }
    const Settled next = settle(at.toolEnd + share * way, axis, wanted, constraints);
    const bool better =
        next.ok && (next.toolEnd - from).squaredNorm() < (at.toolEnd - from).squaredNorm();
    share = better ? std::min(1.0, 2.0 * share) : 0.5 * share;
    at = better ? next : at;
  }
  return at;
}
}  // namespace

Settled nearer(const Settled& found,
               const Settled& start,
               AxisRule& axis,
               std::span<const Wanted> wanted,
               std::span<const Constraint> constraints) {
  const bool isFree = wanted.size() + constraints.size() < 3;
  const Vec3& from = start.toolEnd;
  const auto [step, atLeast] = firstStep(start, wanted, constraints);
  const double way = found.ok ? (found.toolEnd - from).norm() : farWay * atLeast;
  if (way <= leastWay * atLeast || (found.ok && way <= straightWay * atLeast &&
                                    (found.toolEnd - from - step).norm() <= foretold * way)) {
    return found;
  }
  const Eigen::Matrix3d frame = frameOf(start, wanted.size());
  Settled best = found;
  double least = found.ok ? way - tolerance::coincidence : tolerance::farAway;
  if (isFree && found.ok) {
    const Settled nearest = slid(found, from, axis, wanted, constraints);
    const double away = (nearest.toolEnd - from).norm();
    best = away < sameChoice * way ? nearest : found;
    least = asLong * away;
  }
  for (const double share : shares) {
    for (int cell = 0; cell < 27; ++cell) {
      const Vec3 towards(cell % 3 - 1, cell / 3 % 3 - 1, cell / 9 - 1);
      if (towards.isZero(0.0)) {
        continue;
      }
      const Vec3 place = from + share * way * (frame * towards.normalized());
      Settled next = settle(place, axis, wanted, constraints);
      if (next.ok && isFree && (!found.ok || (next.toolEnd - from).norm() < way)) {
        next = slid(next, from, axis, wanted, constraints);
      }
      const double away = (next.toolEnd - from).norm();
      // Mirror images are equally far: the first one stays.
      if (next.ok && away < least) {
        best = next;
        least = away - tolerance::coincidence;
      }
    }
  }
  return best;
}

}  // namespace arelem::motion
