#pragma once
#include <cstddef>
#include <string_view>

#include "frontend/compile.h"

namespace arelem::frontend {

/// How a physical line divides into statement field and identification.
struct CardFields {
  std::size_t fieldEnd = 0;  ///< byte offset in the line where the statement field ends
  std::string_view cardId;   ///< columns 73-80 without outer blanks, or empty
};

/// Columns count code points, with tabs expanded to stops of eight.
///   apt360, apt4: columns 73-80 are identification, what follows is ignored (a line with tabs: as
///   below). cl: free width. automatic, native: columns 73-80 are identification when they hold
///   only letters, digits and blanks, the line has at most 80 columns, and they are set apart:
///   column 72 neither a letter, a digit nor a point, and either the line has exactly 80 columns,
///   or column 72 is `$`, or columns 71-72 are blank after something other than a comma. Otherwise
///   the line is of free width. (Of the lines longer than 72 columns in the corpus all 148 of card
///   decks and none of CAM systems are identified by this rule.)
[[nodiscard]] CardFields splitCard(std::string_view line, Dialect dialect);

}  // namespace arelem::frontend
