// The tube along a path: the whole path at once, or windows along a long one.
#include "runtime/smooth/tube_solver.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/smooth/tube.h"

namespace arelem::smooth {

namespace {

using spline::CubicSpline;

/// How strongly the bounds pull in the first and in the last round.
constexpr double firstPull = 0.03;
constexpr double lastPull = 3.0;
/// A long path is solved in windows of so many knot intervals, each with a look at so many more,
/// which are solved again with the next one. What is farther away has no influence that counts.
constexpr std::size_t windowSpans = 512;
constexpr std::size_t aheadSpans = 64;
/// Turns of the control polygon beyond a right angle are opened before the first round: about a
/// hairpin the problem is far from convex. The legs are moved apart by this share of the tolerance,
/// the next points by less.
constexpr double sharpCosine = 0.0;
constexpr std::array opening = {0.9, 0.9, 0.6, 0.3};
class Solver {
 public:
  Solver(const CubicSpline& original,
         const std::vector<Vec3>& start,
         const Schedule& schedule,
         const Options& options)
      : original_(original), start_(start), schedule_(schedule), options_(options), shift_(start) {}

  std::vector<Vec3> run() {
    const std::size_t spans = original_.spans();
    if (spans <= windowSpans + 2 * aheadSpans) {
      solve({0, spans, original_.closed(), options_.fixedEnds, options_.fixedEnds});
    } else if (original_.closed()) {
      // The seam is nothing special: the first window begins before it, the last one ends at it.
      solve({spans - aheadSpans, windowSpans + 2 * aheadSpans, false, false, false});
      slide(windowSpans, true);
    } else {
      solve({0, windowSpans + aheadSpans, false, options_.fixedEnds, false});
      slide(windowSpans, options_.fixedEnds);
    }
    return std::move(shift_);
  }

 private:
  [[nodiscard]] bool interrupted() const {
    return options_.interrupted != nullptr && options_.interrupted->load(std::memory_order_relaxed);
  }

  /// Windows from a knot interval on; each keeps what the one before left at its start.
  void slide(std::size_t first, bool holdsEnd) {
    const std::size_t spans = original_.spans();
    while (!interrupted()) {
      const std::size_t left = spans - first;
      if (left <= windowSpans + aheadSpans) {
        return solve({first, left, false, true, holdsEnd});
      }
      solve({first, windowSpans + aheadSpans, false, true, false});
      first += windowSpans;
    }
  }

  /// What windows saw ahead fades out from the join on, so that the next one begins without a jump.
  static double faded(std::size_t fromEnd) {
    const std::size_t held = BandedSystem::band;
    const std::size_t away = fromEnd < held ? 0 : fromEnd - held + 1;
    return 1.0 - static_cast<double>(std::min(away, aheadSpans)) / aheadSpans;
  }

  void solve(const Stretch& stretch) {
    Tube tube(original_, stretch, options_.tolerance);
    const std::size_t size = shift_.size();
    std::vector<Vec3> given(tube.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
      const std::size_t at = (stretch.first + i) % size;
      given[i] = start_[at] + faded(std::min(i, given.size() - 1 - i)) * (shift_[at] - start_[at]);
    }
    tube.start(std::move(given));
    for (int i = 0; i < schedule_.rounds && !interrupted(); ++i) {
      const double share = static_cast<double>(i) / (schedule_.rounds - 1);
      tube.round(schedule_.exponent, firstPull * std::pow(lastPull / firstPull, share),
                 schedule_.turns);
    }
    for (std::size_t i = 0; i < tube.shift().size(); ++i) {
      shift_[(stretch.first + i) % size] = tube.shift()[i];
    }
  }

  const CubicSpline& original_;
  const std::vector<Vec3>& start_;  // where the rounds start from
  const Schedule& schedule_;
  const Options& options_;
  std::vector<Vec3> shift_;
};

}  // namespace

std::vector<Vec3> opened(const CubicSpline& curve, double radius) {
  const std::vector<Vec3>& control = curve.control();
  const std::size_t m = control.size();
  std::vector<Vec3> shift(m, Vec3::Zero());
  for (std::size_t i = curve.closed() ? 0 : 1; i + (curve.closed() ? 0 : 1) < m; ++i) {
    const Vec3 in = (control[i] - control[(i + m - 1) % m]).normalized();
    const Vec3 out = (control[(i + 1) % m] - control[i]).normalized();
    const Vec3 across = in + out;
    if (in.dot(out) > sharpCosine || !(across.norm() > tolerance::nullDirection)) {
      continue;
    }
    for (std::size_t k = 0; k < opening.size(); ++k) {
      const Vec3 step = opening[k] * radius * across.normalized();
      if (curve.closed() || i > k + 1) {
        shift[(i + m - k - 1) % m] -= step;
      }
      if (curve.closed() || i + k + 2 < m) {
        shift[(i + k + 1) % m] += step;
      }
    }
  }
  for (Vec3& one : shift) {
    one *= std::min(1.0, radius / std::max(one.norm(), tolerance::coincidence));
  }
  return shift;
}

std::vector<Vec3> displaced(const CubicSpline& original,
                            const std::vector<Vec3>& start,
                            const Schedule& schedule,
                            const Options& options) {
  return Solver(original, start, schedule, options).run();
}

CubicSpline shifted(const CubicSpline& curve, const std::vector<Vec3>& shift) {
  std::vector<Vec3> control = curve.control();
  for (std::size_t i = 0; i < control.size(); ++i) {
    control[i] += shift[i];
  }
  return curve.withControl(std::move(control));
}

}  // namespace arelem::smooth
