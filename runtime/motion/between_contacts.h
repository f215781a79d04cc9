#pragma once
#include "runtime/motion/angle_rule.h"

namespace arelem::motion {

/// The axis with which two places of the cutter touch at once: with more of a turn to either side
/// one of them does, and its normals turn the axis back. The normals that count are then between
/// those of the two.
class BetweenContacts {
 public:
  explicit BetweenContacts(AngleRule& rule) : rule_(rule) {}

  /// From an axis that repeats turn to and fro.
  [[nodiscard]] std::optional<Vec3> find(const Vec3& toolEnd, const Vec3& axis);
  /// The last one that was found.
  struct Last {
    AngleNormals here, there;
    double share = -1.0;  ///< of the way between them; below 0: none was found
    Vec3 toolEnd = Vec3::Zero();
    double rate = 1.0;  ///< that the share changes per length, at most
  };
  [[nodiscard]] const Last& last() const { return last_; }
  void setLast(const Last& last) { last_ = last; }
  /// Near the last one that was found: it follows the tool end steadily.
  [[nodiscard]] std::optional<Vec3> follow(const Vec3& toolEnd);

 private:
  /// An axis of the way from the normals of `here` (share 0) to those of `there`: near share 0 the
  /// contacts are `there`, near share 1 `here`.
  struct Probe {
    double share = 0.0;
    Vec3 axis = Vec3::UnitZ();
    AngleTouch touch;
    bool isThere = false;
  };
  /// The part of the way in which the contacts go from `there` to `here`.
  struct Bracket {
    std::optional<Probe> low, high;  ///< none: the end of the way, not looked at

    [[nodiscard]] double from() const { return low ? low->share : 0.0; }
    [[nodiscard]] double to() const { return high ? high->share : 1.0; }
    [[nodiscard]] double width() const { return to() - from(); }
    void take(const Probe& p) { (p.isThere ? low : high) = p; }
  };

  [[nodiscard]] std::optional<Vec3> settle(const Vec3& toolEnd, Bracket bracket);
  [[nodiscard]] std::optional<Probe> probe(const Vec3& toolEnd, double share);
  [[nodiscard]] std::optional<Bracket> around(const Vec3& toolEnd, double share, double margin);
  [[nodiscard]] bool narrow(const Vec3& toolEnd, Bracket& bracket);
  [[nodiscard]] static double likely(const Vec3& toolEnd, const Bracket& bracket);

  AngleRule& rule_;
  Last last_;
};

}  // namespace arelem::motion
