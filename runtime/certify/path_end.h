#pragma once
#include <vector>

#include "runtime/certify/chord.h"
#include "runtime/certify/guide.h"

namespace arelem::certify {

/// Where a motion is, and how it came there. Cut vectors shorter than the band may go from one side
/// of it to the other, whatever the path does: the last stretch that is longer tells.
class PathEnd {
 public:
  PathEnd(const Location& first, double band)
      : place_(first), from_(first), band_(band), recent_{first} {}

  void moveTo(const Location& next);
  [[nodiscard]] const Location& place() const { return place_; }
  /// The last locations of the path, that of its end behind the others.
  [[nodiscard]] const std::vector<Location>& recent() const { return recent_; }
  /// Of the way by which the tool end came there.
  [[nodiscard]] double length() const { return stretch_.length(); }
  /// Direction in which the point of the tool at `offset` from the tool end came: where the axis
  /// turns, another one than that of the tool end. Zero if it did not move.
  [[nodiscard]] Vec3 towards(const Vec3& offset) const {
    return directionOf(stretch_.velocity(offset));
  }
  /// The same at the very end of a path that keeps both contacts.
  [[nodiscard]] Vec3 towards(const Vec3& offset, const Touch& drive, const Touch& part) const {
    return directionOf(velocity(drive, part) + stretch_.velocity(offset) - stretch_.step());
  }
  /// A location a little farther on such a path.
  [[nodiscard]] Location ahead(double way, const Touch& drive, const Touch& part) const;

 private:
  static Vec3 directionOf(const Vec3& velocity);
  /// Of the tool end, by the time in which it came along the stretch.
  [[nodiscard]] Vec3 velocity(const Touch& drive, const Touch& part) const;

  Location place_;
  Location from_;  ///< where the present stretch begins
  Chord stretch_;
  double band_;
  std::vector<Location> recent_;
  bool known_ = false;  ///< a stretch longer than the band is behind
};

}  // namespace arelem::certify
