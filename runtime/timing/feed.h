#pragma once
#include <optional>

#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"

namespace arelem::timing {

/// The feed in force, as FEDRAT and SPINDL say.
class FeedInForce {
 public:
  void setUnit(double millimeters) { unit_ = millimeters; }
  /// Other statements than these two change nothing.
  void take(const cl::Post& post);
  /// mm a minute along a move of this length, mm; 0 where no feed is known.
  [[nodiscard]] double perMinute(double length) const;
  /// Whether the feed counts moves a minute.
  [[nodiscard]] bool isInverse() const { return mode_ == Mode::inverse; }
  /// Whether the feed is per turn, and the spindle has no speed.
  [[nodiscard]] bool lacksSpindle() const {
    return mode_ == Mode::perTurn && value_ > 0.0 && !(turns_ > 0.0);
  }
  /// Of the spindle, a minute.
  [[nodiscard]] double turns() const { return turns_; }

 private:
  enum class Mode { perMinute, perTurn, inverse };
  double unit_ = 1.0;   // mm
  double value_ = 0.0;  // mm a minute or a turn, or moves a minute
  Mode mode_ = Mode::perMinute;
  double turns_ = 0.0;
};

/// Why no time follows from a FEDRAT or a DELAY: it is not one number, with one of the units that
/// FeedInForce knows, or with REV. None for other statements. The row is E0598.
[[nodiscard]] std::optional<Failure> objectionToTiming(const cl::Post& post);

/// The first number among the parameters, if there is one.
[[nodiscard]] const double* firstNumber(const cl::Post& post);
[[nodiscard]] bool hasOneOf(const cl::Post& post, std::initializer_list<Word> words);

}  // namespace arelem::timing
