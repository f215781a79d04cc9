#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "runtime/motion/path.h"

namespace arelem::motion {

/// The last cut vectors: next to a crossing they get short and turn.
class LastWay {
 public:
  void note(const Vec3& way) { ways_[count_++ % ways_.size()] = way; }
  /// The direction of the longest one, if there is any.
  [[nodiscard]] std::optional<Vec3> general() const {
    const auto shorter = [](const Vec3& a, const Vec3& b) {
      return a.squaredNorm() < b.squaredNorm();
    };
    const Vec3& longest = *std::max_element(ways_.begin(), ways_.end(), shorter);
    return longest.isZero(0.0) ? std::nullopt : std::optional<Vec3>(longest.normalized());
  }

 private:
  std::array<Vec3, 8> ways_{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero(),
                            Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  std::size_t count_ = 0;
};

/// How a motion gets on where its path does not go straight on: the path turns where another place
/// of the cutter begins to touch, or the tool axis of the rule leaps from one to another.
class Corners {
 public:
  explicit Corners(Path& path) : path_(path) {}

  struct Way {
    std::vector<PathPoint> through;  ///< ends of cut vectors up to there
    PathPoint on;                    ///< the place behind the corner, with the new direction
  };
  /// From the last place before a corner; `tip`, if not null, is a place between, too near for a
  /// cut vector that nothing calls for. None where there is no way.
  [[nodiscard]] std::optional<Way> from(const PathPoint& last, const PathPoint* tip);
  /// The end of a cut vector, straight on and not longer than `longest`, over a place where the
  /// path has no one direction: it crosses another one, or the tool may go anywhere on two surfaces
  /// that touch.
  [[nodiscard]] std::optional<PathPoint> across(const PathPoint& last,
                                                const Vec3& direction,
                                                double longest);

 private:
  [[nodiscard]] std::optional<Way> turned(const PathPoint& last, const PathPoint* tip);
  [[nodiscard]] std::optional<Way> leapt(const PathPoint& last);
  [[nodiscard]] std::optional<PathPoint> straightOn(const PathPoint& last,
                                                    const Vec3& way,
                                                    const std::array<double, 2>& gaps);
  void startAnew();

  Path& path_;
  std::optional<Vec3> turn_;  ///< where the path turned last
  std::optional<Vec3> leap_;  ///< where the axis leapt last
};

}  // namespace arelem::motion
