#pragma once
#include <optional>

#include "ir/cl/record.h"
#include "ir/diag/result.h"

namespace arelem::backend::ngc {

/// A canned cycle of CYCLE/ type, depth, unit, feed, clearance, modifiers. Lengths in the part
/// unit.
struct Cycle {
  enum class Kind { drill, dwell, peck, chip, bore, boreDwell, tap };
  Kind kind = Kind::drill;
  double depth = 0.0;          ///< below the location; written with either sign
  double clearance = 0.0;      ///< above it, where the feed begins
  double retract = 0.0;        ///< above it, on the way to the next hole; never below clearance
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

}  // namespace arelem::backend::ngc
