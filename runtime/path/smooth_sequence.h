#pragma once
#include <optional>
#include <vector>

#include "runtime/path/smooth_order.h"
#include "runtime/path/smoother.h"
#include "runtime/timing/transition.h"

namespace arelem::path {

/// Successive locations of a tool with one axis.
struct SmoothSequence {
  cl::Record first;          ///< of its cut vectors: its place, and the kind of the new ones
  std::vector<Vec3> points;  ///< where the tool stands before it, and its locations
  std::optional<Vec3> axis;  ///< where the records have one
  double unit = 1.0;         ///< mm
  double speed = 0.0;        ///< the feed, mm/s; 0: none is known
  timing::Limits limits;     ///< of the machine, mm
};

struct SmoothedSequence {
  std::vector<cl::Record> records;  ///< the curve, where it is asked for, and its cut vectors
  Vec3 end = Vec3::Zero();
  SmoothFact fact;
  double secondsBefore = 0.0, secondsAfter = 0.0;  ///< at the feed, from rest to rest
};

/// Fits a curve to a sequence, smooths it and chords it, all within the tolerance of the order. The
/// least time is that of the feed and the machine. Errors: E0397, E0591, those of the curve.
[[nodiscard]] Result<SmoothedSequence> smoothSequence(const SmoothSequence& sequence,
                                                      const SmoothOrder& order);

}  // namespace arelem::path
