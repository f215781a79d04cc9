#pragma once
#include "ir/words/words.h"

namespace arelem {

inline constexpr double millimetersOfAnInch = 25.4;

/// Millimeters of one unit of length of UNITS/: MM, CM, INCHES or FEET.
[[nodiscard]] constexpr double millimetersOf(Word unit) {
  switch (unit) {
    case Word::CM:
      return 10.0;
    case Word::INCHES:
      return millimetersOfAnInch;
    case Word::FEET:
      return 12.0 * millimetersOfAnInch;
    default:
      return 1.0;
  }
}

}  // namespace arelem
