// The tilts of a run for which the worst film of its cells is the least.
#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/stencil/cell.h"
#include "runtime/stencil/plan.h"

namespace arelem::stencil {

namespace {
struct Span {
  double low = 0.0;
  double high = 0.0;
  [[nodiscard]] bool empty() const { return low > high; }
};

/// The worst departure of one cell's film from its mean at tilts of an even step.
struct Cell {
  std::vector<double> worst;  // empty: without area, any tilt will do
  std::size_t best = 0;       // the best of these
  double wanted = 0.0;        // the best tilt, degrees
};

/// A run of cells; a cell has the mean of the tilts of the lines at its ends.
class Chain {
 public:
  Chain(const std::vector<Line>& lines,
        double fan,
        const TiltLimits& limits,
        const std::vector<double>& seconds)
      : most_(limits.most), count_(lines.size()) {
    const auto samples = static_cast<std::size_t>(2.0 * std::ceil(most_ / coarse)) + 1;
    step_ = 2.0 * most_ / static_cast<double>(samples - 1);
    std::vector<double> steepness;
    for (std::size_t k = 0; k < samples; ++k) {
      steepness.push_back(steepnessOf(tiltAt(k), fan));
    }
    for (std::size_t i = 0; i + 1 < count_; ++i) {
      Cell& cell = cells_.emplace_back();
      turn_.push_back(limits.rate * seconds[i]);
      const Balance balance = balanceOf(lines[i], lines[i + 1]);
      if (balance.area <= tolerance::rounding) {
        continue;
      }
      for (const double m : steepness) {
        cell.worst.push_back(spreadOf(balance.lean, m).worst());
      }
      cell.best = static_cast<std::size_t>(std::min_element(cell.worst.begin(), cell.worst.end()) -
                                           cell.worst.begin());
      cell.wanted = bestTilt(balance.lean, fan, tiltAt(cell.best));
    }
  }

  std::vector<double> tilts() {
    double low = 0.0;
    double high = 0.0;  // no tilt at all keeps all limits
    for (const Cell& cell : cells_) {
      low = cell.worst.empty() ? low : std::max(low, cell.worst[cell.best]);
      high = cell.worst.empty() ? high : std::max(high, cell.worst[cell.worst.size() / 2]);
    }
    constexpr int halvings = 24;
    for (int i = 0; i < halvings; ++i) {
      const double level = 0.5 * (low + high);
      (reach(level) ? high : low) = level;
    }
    // A little more than the least: tilts that are forced to the last digit swing to and fro.
    constexpr double slack = 0.002;
    reach(high + slack);
    return back();
  }

 private:
  static constexpr double coarse = 0.8;  // degrees

  /// The best tilt near a sample, by thirds: the worst film has one valley there.
  [[nodiscard]] double bestTilt(double lean, double fan, double near) const {
    double low = std::max(-most_, near - step_);
    double high = std::min(most_, near + step_);
    const auto worst = [&](double tilt) { return spreadOf(lean, steepnessOf(tilt, fan)).worst(); };
    constexpr int thirds = 7;  // to 0.1 degrees
    for (int i = 0; i < thirds; ++i) {
      const double a = low + (high - low) / 3.0;
      const double b = high - (high - low) / 3.0;
      const bool lower = worst(a) < worst(b);
      (lower ? high : low) = lower ? b : a;
    }
    const double found = 0.5 * (low + high);
    return worst(found) < worst(near) ? found : near;
  }

  [[nodiscard]] double tiltAt(std::size_t k) const {
    return -most_ + step_ * static_cast<double>(k);
  }
  /// The tilts of a cell whose film departs by no more than `level`: straight between the samples.
  [[nodiscard]] Span allowed(const Cell& cell, double level) const {
    if (cell.worst.empty()) {
      return {-most_, most_};
    }
    if (cell.worst[cell.best] > level) {
      return {1.0, 0.0};
    }
    const auto crossing = [&](std::size_t inside, std::size_t outside) {
      const double a = cell.worst[inside];
      const double b = cell.worst[outside];
      const double t = b > a ? (level - a) / (b - a) : 0.0;
      return tiltAt(inside) + t * (tiltAt(outside) - tiltAt(inside));
    };
    std::size_t low = cell.best;
    while (low > 0 && cell.worst[low - 1] <= level) {
      --low;
    }
    std::size_t high = cell.best;
    while (high + 1 < cell.worst.size() && cell.worst[high + 1] <= level) {
      ++high;
    }
    return {low == 0 ? -most_ : crossing(low, low - 1),
            high + 1 == cell.worst.size() ? most_ : crossing(high, high + 1)};
  }

  /// The tilts that each line can have when all cells before it are within the level. What can be
  /// reached from an interval by linear bounds is an interval again.
  bool reach(double level) {
    lines_.assign(1, {-most_, most_});
    allowed_.clear();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const Span mean = allowed(cells_[i], level);
      const Span from = lines_.back();
      if (mean.empty()) {
        return false;
      }
      const double turn = turn_[i];
      // y >= 2 low - x and y >= x - turn: the least y where both meet, if that x can be had.
      const double x = std::clamp(mean.low + 0.5 * turn, from.low, from.high);
      const double z = std::clamp(mean.high - 0.5 * turn, from.low, from.high);
      const Span next = {std::max({2.0 * mean.low - x, x - turn, -most_}),
                         std::min({2.0 * mean.high - z, z + turn, most_})};
      if (next.empty()) {
        return false;
      }
      lines_.push_back(next);
      allowed_.push_back(mean);
    }
    return true;
  }

  /// Tilts from the last line back, each as near as can be to what the cells beside it want.
  [[nodiscard]] std::vector<double> back() const {
    std::vector<double> tilts(count_, 0.0);
    for (std::size_t i = count_; i-- > 0;) {
      Span span = lines_[i];
      if (i + 1 < count_) {
        const double next = tilts[i + 1];
        span.low = std::max({span.low, 2.0 * allowed_[i].low - next, next - turn_[i]});
        span.high = std::min({span.high, 2.0 * allowed_[i].high - next, next + turn_[i]});
      }
      tilts[i] = span.empty() ? 0.5 * (span.low + span.high)  // by rounding only
                              : std::clamp(wanted(i), span.low, span.high);
    }
    return tilts;
  }
  [[nodiscard]] double wanted(std::size_t line) const {
    double sum = 0.0;
    int count = 0;
    for (const std::size_t i : {line - 1, line}) {
      if (i < cells_.size() && !cells_[i].worst.empty()) {
        sum += cells_[i].wanted;
        ++count;
      }
    }
    return count > 0 ? sum / count : 0.0;
  }

  double most_;
  std::size_t count_;
  double step_ = coarse;
  std::vector<Cell> cells_;
  std::vector<double> turn_;   // that each cell leaves time for
  std::vector<Span> lines_;    // what each line can have
  std::vector<Span> allowed_;  // what each cell may have
};
}  // namespace

std::vector<double> evenestTilts(const std::vector<Line>& lines,
                                 double fan,
                                 const TiltLimits& limits,
                                 const std::vector<double>& seconds) {
  return lines.size() < 2 ? std::vector<double>(lines.size(), 0.0)
                          : Chain(lines, fan, limits, seconds).tilts();
}

}  // namespace arelem::stencil
