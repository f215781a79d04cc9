// The algorithm of Naseath, chapter 3, with the corrections of its formulas and one guard: his
// deviation is sampled and lets the curve leave the tube by up to 4 %; here the result is
// certified.
#include <algorithm>
#include <array>
#include <cmath>

#include "ir/space/smooth_tolerance.h"
#include "runtime/smooth/polygon.h"
#include "runtime/smooth/smooth.h"

namespace arelem::smooth {

namespace {

using spline::CubicSpline;

/// Longer paths are smoothed block by block. The source scales all moves by the one place of a path
/// that moves the curve most and ends where the first place meets the tube, so that a long path
/// would take more turns and gain less than its parts.
constexpr std::size_t blockPoints = 1024;
/// Control points on each side of a block that its polygon is looked at with.
constexpr std::size_t context = 4;

/// The control points `from` to `to`; the others stay.
class Block {
 public:
  Block(const CubicSpline& original,
        const Options& options,
        std::vector<Vec3>& control,
        std::size_t from,
        std::size_t to)
      : original_(original), options_(options), control_(control), from_(from), count_(to - from) {
    const std::size_t m = control.size();
    isWhole_ = count_ == m;
    if (!isWhole_) {
      before_ = original.closed() ? context : std::min(context, from);
      after_ = original.closed() ? context : std::min(context, m - to);
    }
    for (std::size_t i = 0; i < before_ + count_ + after_; ++i) {
      given_.push_back(original.control()[(from_ + m - before_ + i) % m]);
    }
    prepareSpans();
  }

  /// Turns that it took.
  int run() {
    const double radius = options_.tolerance;
    const std::vector<double> equal(count_, radius);
    const std::vector<Vec3> mock = steps(equal);
    std::vector<double> sensitivity = measured(mock, equal);
    double left = radius;
    int turns = 0;
    while (turns < options_.mostIterations && !interrupted()) {
      ++turns;
      const std::vector<double> distance = moves(sensitivity, left);
      const std::vector<Vec3> step = steps(distance);
      sensitivity = measured(step, distance);
      add(step, 1.0);
      left = radius - sampledDeviation();
      if (left < 0.0) {
        add(step, -1.0);  // the polygon before stays
        break;
      }
      if (left <= options_.accuracy * radius ||
          largest(step) < tolerance::smoothStillness * radius) {
        break;
      }
    }
    return turns;
  }

 private:
  using Row = std::array<double, 4>;
  /// A place of the difference spline by four control points of the path.
  struct Place {
    std::size_t span;
    Row weights;
  };

  [[nodiscard]] bool interrupted() const {
    return options_.interrupted != nullptr && options_.interrupted->load(std::memory_order_relaxed);
  }

  [[nodiscard]] Place placeAt(std::size_t span, double share) const {
    const CubicSpline::Weights w = original_.pieceWeights(span);
    const double rest = 1.0 - share;
    const Row bernstein{rest * rest * rest, 3.0 * rest * rest * share, 3.0 * rest * share * share,
                        share * share * share};
    Place place{span, {}};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t r = 0; r < 4; ++r) {
        place.weights[i] += bernstein[r] * w[r][i];
      }
    }
    return place;
  }

  /// Where the control points act, eqs. 3-33 to 3-37, and where the deviation is sampled.
  void prepareSpans() {
    const std::size_t spans = original_.spans();
    const std::size_t m = control_.size();
    for (std::size_t i = from_; i < from_ + count_; ++i) {
      if (original_.closed()) {
        acting_.push_back(placeAt((i + m - 1) % m, 0.0));
      } else if (i == 1 || i + 2 == m) {
        acting_.push_back(placeAt(i == 1 ? 0 : spans - 1, 0.5));
      } else {
        acting_.push_back(i + 1 == m ? placeAt(spans - 1, 1.0)
                                     : placeAt(std::max<std::size_t>(i, 1) - 1, 0.0));
      }
    }
    const std::size_t touched = isWhole_ ? spans : count_ + 3;
    const std::size_t first = isWhole_ ? 0 : from_ + (original_.closed() ? m : 0);
    for (std::size_t k = 0; k < touched; ++k) {
      const std::size_t span = isWhole_ ? k : first + k;
      const bool isThere = isWhole_ || original_.closed() || (span >= 3 && span - 3 < spans);
      for (int i = 0; isThere && i <= options_.precision; ++i) {
        const std::size_t index = isWhole_ ? span : (span - 3) % spans;
        sampled_.push_back(placeAt(index, static_cast<double>(i) / options_.precision));
      }
    }
  }

  [[nodiscard]] std::vector<Vec3> steps(const std::vector<double>& distance) const {
    const std::size_t m = control_.size();
    std::vector<Vec3> polygon;
    for (std::size_t i = 0; i < given_.size(); ++i) {
      polygon.push_back(control_[(from_ + m - before_ + i) % m]);
    }
    const bool closed = isWhole_ && original_.closed();
    const std::vector<Vec3> way = directions(polygon, given_, categories(polygon, closed), closed);
    std::vector<Vec3> step(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      step[i] = distance[i] * way[before_ + i];
    }
    return step;
  }

  void add(const std::vector<Vec3>& step, double factor) {
    for (std::size_t i = 0; i < count_; ++i) {
      control_[from_ + i] += factor * step[i];
    }
  }

  /// Change of the curve where a control point acts, for its move.
  [[nodiscard]] std::vector<double> measured(const std::vector<Vec3>& step,
                                             const std::vector<double>& distance) const {
    std::vector<double> sensitivity(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      Vec3 change = Vec3::Zero();
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t index = original_.index(acting_[i].span, k);
        if (index >= from_ && index < from_ + count_) {
          change += acting_[i].weights[k] * step[index - from_];
        }
      }
      sensitivity[i] = change.norm() / distance[i];
    }
    return sensitivity;
  }

  [[nodiscard]] double sampledDeviation() const {
    double most = 0.0;
    for (const Place& place : sampled_) {
      Vec3 gap = Vec3::Zero();
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t index = original_.index(place.span, k);
        gap += place.weights[k] * (control_[index] - original_.control()[index]);
      }
      most = std::max(most, gap.squaredNorm());
    }
    return std::sqrt(most);
  }

  static double largest(const std::vector<Vec3>& step) {
    double most = 0.0;
    for (const Vec3& one : step) {
      most = std::max(most, one.norm());
    }
    return most;
  }

  const CubicSpline& original_;
  const Options& options_;
  std::vector<Vec3>& control_;
  std::size_t from_, count_;
  bool isWhole_ = false;
  std::size_t before_ = 0, after_ = 0;  // of the context
  std::vector<Vec3> given_;             // block and context before the first turn
  std::vector<Place> acting_;
  std::vector<Place> sampled_;
};

}  // namespace

Smoothed sourceMethod(const CubicSpline& curve, const Options& options) {
  std::vector<Vec3> control = curve.control();
  const std::size_t m = control.size();
  const std::size_t blocks = (m + blockPoints - 1) / blockPoints;
  int turns = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t from = b * m / blocks;
    const std::size_t to = (b + 1) * m / blocks;
    turns = std::max(turns, Block(curve, options, control, from, to).run());
  }
  Smoothed result = guarded(curve, curve.withControl(std::move(control)), options.tolerance);
  result.iterations = turns;
  return result;
}

}  // namespace arelem::smooth
