#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "ir/space/vector.h"

/// Private to runtime/tool.
namespace arelem::tool {

/// A zero of a slope lies between the places where the slope was last negative and positive. Where
/// the surface is as near on two sides (deep in a hollow) the slope jumps there: between two
/// branches of the value, which their tangents foretell.
class Bracket {
 public:
  /// Steps by less than the curvature tells go on for ever where that is small: those to the same
  /// side grow.
  [[nodiscard]] double paced(double step) {
    onwards_ = step > 0.0 ? std::max(onwards_, 0) + 1 : std::min(onwards_, 0) - 1;
    return std::ldexp(step, std::clamp(std::abs(onwards_) - free, 0, mostDoublings));
  }

  /// Where the value has that slope, and the distance that normal. True where it jumps from slope
  /// to slope, and nothing is to be gained between the ends.
  [[gnu::noinline]] bool note(double at, double value, double slope, const Vec3& normal) {
    const double widthBefore = width();
    const double jumpBefore = isClosed() ? jump() : 0.0;
    End& end = slope < 0.0 ? low_ : high_;
    end.at = at;
    end.value = value;
    end.slope = slope;
    end.normal = normal;
    if (widthBefore < open && width() < narrower * widthBefore) {
      jumps_ = jump() > asSteep * jumpBefore ? jumps_ + 1 : 0;
    }
    return jumps_ >= certain && isSettled();
  }
  /// The place proposed, or one between the ends where that leaves the bracket or takes too long.
  [[nodiscard]] double keep(double proposed, int iteration) {
    if (!isClosed()) {
      return proposed;
    }
    if (jumps_ >= certain) {
      return nearJump();
    }
    const bool outside = proposed <= low_.at || proposed >= high_.at;
    return outside || iteration > patience ? 0.5 * (low_.at + high_.at) : proposed;
  }
  /// The end with the lesser value: the one noted last may be the other.
  [[nodiscard]] double lesser() const { return low_.value <= high_.value ? low_.at : high_.at; }
  /// The mean of both normals that has no slope: what the least value changes by as the tool moves.
  [[nodiscard]] Vec3 meanNormal() const {
    return (high_.slope * low_.normal - low_.slope * high_.normal) / jump();
  }

 private:
  /// All but the place is known where that is finite.
  struct End {
    double at, value, slope;
    Vec3 normal;
    explicit End(double place) : at(place) {}
  };
  /// Iterations after which it is halved whatever Newton says.
  static constexpr int patience = 12;
  /// Steps before they grow, and how often they double.
  static constexpr int free = 3, mostDoublings = 20;
  /// The slope jumps where it changes no less in a bracket that got narrower, so many times.
  static constexpr int certain = 3;
  static constexpr double narrower = 0.75, asSteep = 0.9;
  /// Widths in which branches are straight, and of places that are the same; what is not gained.
  static constexpr double close = 1e-7, closest = 1e-14, unseenGain = 1e-14;
  /// The crossing of the tangents is wrong by the square of the width: so far beyond it is the
  /// other branch.
  static constexpr double beyond = 0.5, leastBeyond = 1e-4;
  static constexpr double open = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool isClosed() const { return std::isfinite(width()); }
  [[nodiscard]] double width() const { return high_.at - low_.at; }
  [[nodiscard]] double jump() const { return high_.slope - low_.slope; }
  [[nodiscard]] bool isSettled() const {
    const double gain = std::min(low_.value, high_.value) - (low_.value + low_.slope * way());
    return width() <= closest ||
           (width() <= close && gain <= unseenGain * (1.0 + std::abs(low_.value)));
  }
  /// From the low end to where the tangents cross.
  [[nodiscard]] double way() const {
    return (high_.slope * width() - (high_.value - low_.value)) / jump();
  }

  /// Rounds of the crossing, a place beyond it on the other side, and the middle where both did not
  /// halve the bracket.
  [[gnu::noinline]] double nearJump() {
    const double across = width();
    const double aside = std::max(beyond * std::min(before_, 1.0), leastBeyond) * before_;
    const bool isLow = low_.at == crossing_;
    const double next = isLow ? crossing_ + aside : crossing_ - aside;
    if (turn_ == 1 && next > low_.at && next < high_.at) {
      turn_ = 2;
      return next;
    }
    const double middle = 0.5 * across;
    if (turn_ != 0 && across > 0.5 * before_) {
      turn_ = 0;
      return low_.at + middle;
    }
    before_ = across;
    turn_ = 1;
    const double to = way();
    crossing_ = low_.at + (to > 0.0 && to < across ? to : middle);
    return crossing_;
  }

  End low_{-open}, high_{open};
  int onwards_ = 0;  ///< positive: steps that went on to that side, else to the other
  int jumps_ = 0;    ///< times that the slope changed no less in a narrower bracket
  int turn_ = 0;     ///< of the round
  double before_ = open, crossing_ = 0.0;
};

}  // namespace arelem::tool
