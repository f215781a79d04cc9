#pragma once
#include <algorithm>
#include <utility>

#include "ir/space/tolerance.h"

namespace arelem::motion {

/// Lengths of a cut vector that were tried. The root of what is used of the band is taken for a
/// linear function of the length: over even curvature it grows from zero, behind an even stretch
/// from the length up to there.
class Tried {
 public:
  /// The length to try after one that was too long by `factor`, which is below 1. Where that
  /// converges slowly (the gap does not bend evenly) lengths are halved until one fits.
  [[nodiscard]] double shorter(double length, double factor, int times) {
    note({length, 1.0 / std::max(factor, leastFactor)});
    if (fits_.length > 0.0) {
      return between();
    }
    const double line = isKnown_ ? through(before_, last_) : 0.0;
    const double scaled = length * (times < patience ? std::max(factor * safety, 0.3) : 0.5);
    return line > 0.3 * length ? std::min(line, scaled) : scaled;
  }
  /// The same after one up to which the path cannot be followed.
  [[nodiscard]] double shorter(double length) {
    note({length, unknown});
    return 0.5 * (fits_.length + length);
  }
  /// The length to try after one that could grow by `factor`.
  [[nodiscard]] double longer(double length, double factor) {
    note({length, 1.0 / factor});
    const double line = isKnown_ && before_.length < length ? through(before_, last_) : 0.0;
    const double next = std::min(line > length ? line : length * factor * safety, bold_ * length);
    bold_ *= bold_;  // what hardly binds for long may hardly bind for much longer
    return next < fails_.length ? next : between();
  }
  [[nodiscard]] double fits() const { return fits_.length; }
  [[nodiscard]] double fails() const { return fails_.length; }
  /// Nothing longer that fits is much longer.
  [[nodiscard]] bool isNarrow() const { return fails_.length <= narrow * fits_.length; }

 private:
  /// A length and the root of the share of the band that it uses.
  struct Trial {
    double length, used;
  };
  static constexpr double leastFactor = 1e-3;
  static constexpr double safety = 0.9994;
  /// Trials after which lengths that do not fit are halved.
  static constexpr int patience = 5;
  /// Lengths grow by at most this factor at first, then by its square and so on.
  static constexpr double mostLonger = 3.0;
  static constexpr double unknown = tolerance::farAway;
  /// Lengths that differ by less than this factor need no more trials.
  static constexpr double narrow = 1.03;
  /// What is aimed at between two trials.
  static constexpr double wanted = 0.997;
  /// What is far too long does not tell by how much.
  static constexpr double mostUsed = 2.0;
  /// Between two trials the next is not nearer to one of them than this share of their distance.
  static constexpr double leastShare = 0.05;

  void note(Trial trial) {
    isKnown_ = last_.length > 0.0 && last_.used < unknown && trial.used < unknown;
    before_ = std::exchange(last_, trial);
    isSameSide_ = (before_.used > 1.0) == (trial.used > 1.0);
    if (trial.used > 1.0) {
      fails_ = trial.length < fails_.length ? trial : fails_;
    } else {
      fits_ = trial.length > fits_.length ? trial : fits_;
    }
  }
  /// Where the line through two trials reaches what is aimed at; 0 where it never does.
  static double through(const Trial& a, const Trial& b) {
    const double steepness = (b.used - a.used) / (b.length - a.length);
    return steepness > 0.0 ? std::max(0.0, b.length + (wanted - b.used) / steepness) : 0.0;
  }
  /// By the line between the two; the end that has stayed counts less from time to time.
  [[nodiscard]] double between() {
    const double width = fails_.length - fits_.length;
    if (fails_.used == unknown) {
      return fits_.length + 0.5 * width;
    }
    stays_ = isBetween_ && isSameSide_ ? 0.5 * stays_ : 1.0;
    isBetween_ = true;
    const bool fitted = last_.used <= 1.0;
    const double below = (wanted - fits_.used) * (fitted ? 1.0 : stays_);
    const double above = (std::min(fails_.used, mostUsed) - wanted) * (fitted ? stays_ : 1.0);
    const double share = below / (below + above);
    return fits_.length + std::clamp(share, leastShare, 1.0 - leastShare) * width;
  }

  Trial fits_{0.0, 0.0}, fails_{tolerance::farAway, unknown};
  Trial before_{0.0, 0.0}, last_{0.0, 0.0};
  bool isKnown_ = false;     ///< what the last two trials used
  bool isSameSide_ = false;  ///< both fitted, or neither did
  bool isBetween_ = false;   ///< the last trial was chosen between two
  double stays_ = 1.0;
  double bold_ = mostLonger;
};

}  // namespace arelem::motion
