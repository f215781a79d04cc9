#pragma once
#include <cstdint>
#include <memory>

#include "runtime/certify/guide.h"

namespace arelem::certify {

/// What a path has to be counted against.
struct StopWanted {
  ir::Condition condition = ir::Condition::to;  ///< TO, ON or PAST
  int nth = 1;                                  ///< n, INTOF
  const tool::Profile* cutter = nullptr;        ///< null: the tool end
  double thick = 0.0;
  Allowed allowed;
  double pathBand = 0.0;     ///< by which cut vectors stray from the path proper
  Vec3 path = Vec3::Zero();  ///< unit, either way: of the path where it begins
};

/// Counts how often a path comes to the positions TO, ON or PAST its check surface, in the order of
/// spec 4.8: from a place clear of it TO, PAST, TO, ..., from within it PAST, TO, ... A start
/// within the tolerance does not count, nor what follows before that is left; nor what the tool
/// meets while it turns to its axis where the motion begins.
///
/// What counts is what must be: a tool that was clear by more than the tolerance, and what cut
/// vectors stray, and then is within the surface by more has been TO it. What may count is a visit
/// within that. Gaps are 1-Lipschitz in the tool position, so that no place between those looked at
/// is left out but in a visit, which is walked in steps of half of the tolerance (or, along cut
/// vectors that stay in it, of `stepsWithin` a cut vector).
class StopCount {
 public:
  StopCount(const surface::AnySurface& surface, const StopWanted& wanted, const Location& first);

  void add(const Location& next);
  /// The path was at the stop that is asked for, and went on beyond.
  [[nodiscard]] bool passed() const { return armed_ && sure_ > before(); }
  /// The path cannot have come as often as is asked for, if it ends here at the surface.
  [[nodiscard]] bool early() const { return armed_ && possible() < before(); }
  /// The number of the stop at which the path ends, if it ends here at the surface.
  [[nodiscard]] int number() const {
    return isPoint() ? possible() + 1 : (possible() + first()) / 2 + 1;
  }
  /// Where the stop that is asked for was passed, and on which cut vector, counted from 0.
  [[nodiscard]] const Vec3& passedAt() const { return passedAt_; }
  [[nodiscard]] std::size_t passedVector() const { return passedVector_; }

 private:
  [[nodiscard]] bool isPoint() const { return wanted_.cutter == nullptr; }
  /// 1 where the first of all positions is not one of those asked for.
  [[nodiscard]] int first() const {
    return (wanted_.condition == ir::Condition::past) == startedClear_ ? 1 : 0;
  }
  /// The positions, TO and PAST, before the one that is asked for.
  [[nodiscard]] int before() const {
    return isPoint() ? wanted_.nth - 1 : 2 * (wanted_.nth - 1) + first();
  }
  [[nodiscard]] int possible() const { return sure_ + visited_ + inVisit(); }
  /// The positions that a visit within the tolerance may be.
  [[nodiscard]] int inVisit() const;
  /// One step within the tolerance.
  [[nodiscard]] double share() const { return 0.5 * tolerance_; }
  /// The greater of the gaps on both sides of the surface, at a place of the chord: above what
  /// counts as near only where that is proven, below it where a smaller one was measured, else 0.
  /// Of the tool end its distance.
  [[nodiscard]] double measure(double s);
  [[nodiscard]] Range gapOf(Probe& probe, double side, double s) const;
  void prove(Probe& probe, Node& node) const;
  void note(double value, const Vec3& place);

  surface::AnySurface surface_;
  StopWanted wanted_;
  std::unique_ptr<Probe> plus_, minus_;
  Location last_;
  Chord chord_;
  double tolerance_;
  double near_;        ///< with what cut vectors stray
  double reach_;       ///< from the tool end to the farthest point of the tool
  double free_ = 0.0;  ///< way of its points by which nothing changes for sure
  std::size_t vectors_ = 0;
  Vec3 begin_;
  bool begins_ = true;  ///< the tool has only turned so far
  bool armed_ = false, startedClear_ = true;
  bool positive_ = true;  ///< the side on which the path was last, by more than a visit
  bool visits_ = false;   ///< it is within the tolerance
  bool above_ = true;     ///< the sign of the gap in this visit
  int changes_ = 0;       ///< of that sign
  int sure_ = 0, visited_ = 0;
  Vec3 passedAt_ = Vec3::Zero();
  std::size_t passedVector_ = 0;
};

}  // namespace arelem::certify
