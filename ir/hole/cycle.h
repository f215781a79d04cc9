#pragma once
#include <optional>

#include "ir/cl/record.h"
#include "ir/diag/result.h"

namespace arelem::hole {

/// A canned cycle of CYCLE/ type, depth, unit, feed, clearance, modifiers. Lengths in the part
/// unit.
struct Cycle {
  enum class Kind { drill, dwell, peck, chip, bore, boreDwell, tap };
  Kind kind = Kind::drill;
  double depth = 0.0;          ///< below the location; written with either sign
  double clearance = 0.0;      ///< above it, where the feed begins
  double retract = 0.0;        ///< above it, on the way to the next hole; never below clearance
  bool returns = false;        ///< between holes to the height where the cycle began
  double step = 0.0;           ///< of each peck
  double dwell = 0.0;          ///< seconds
  std::optional<double> feed;  ///< of the cycle; with its unit
  Word feedUnit = Word::MMPM;
  bool feedHasUnit = false;
};

/// Reads the positional and the keyworded forms: DRILL, FACE (G81, or G82 with DWELL), DEEP (G83)
/// and BRKCHP (G73) with STEP or INCR, BORE and REAM (G85, or G89 with DWELL: the tool feeds out
/// again), TAP (G84, or G74 where the spindle turns counter-clockwise), with the words of NX,
/// SolidWorks CAM, CAMWorks, Creo and CATIA. Errors: other cycles, a number that is missing.
[[nodiscard]] Result<Cycle> readCycle(const cl::Post& post);

/// The cycle at a location that the tool comes to from `height` above it, none where that is not
/// known: a cycle that returns to where it began retracts to that height, or to its clearance.
[[nodiscard]] Cycle cycleFrom(const Cycle& cycle, std::optional<double> height);

/// What the words CYCLE of a program leave in force.
class Cycles {
 public:
  enum class Change : std::uint8_t {
    none,   ///< a head without a meaning of its own
    ended,  ///< OFF, NOMORE, CLEAR alone
    resumed,
    begun
  };
  /// Errors: as readCycle; more pecks than a hole may have.
  [[nodiscard]] Result<Change> read(const cl::Post& post);
  /// Null between OFF and the next cycle.
  [[nodiscard]] const Cycle* now() const { return on_ && last_ ? &*last_ : nullptr; }
  /// At a location: ON came and no cycle is known. Told once.
  [[nodiscard]] std::optional<Failure> objection();

 private:
  std::optional<Cycle> last_;
  bool on_ = false;
  std::optional<bool> paused_;  ///< NOMORE came last: whether the cycle was on, which ON restores
};

/// What a machine that does not drill has against a word CYCLE: E0673, but for those that end one.
[[nodiscard]] std::optional<Failure> objectionToDrilling(const cl::Post& post);

/// FEDRAT with the feed that a cycle brings; none where it has the feed before it.
[[nodiscard]] std::optional<cl::Post> feedOf(const Cycle& cycle);

}  // namespace arelem::hole
