#pragma once
#include <string>
#include <vector>

#include "frontend/format/card_list.h"
#include "frontend/format/formatter.h"

namespace arelem::frontend {

/// Follows loops, macros and blocks from statement to statement and tells how far each is indented.
class Indent {
 public:
  /// Levels of the statement, which then opens or closes its own.
  [[nodiscard]] std::size_t next(const CardGroup& group);

 private:
  std::size_t depth_ = 0;
};

/// The lines of a statement in the layout of formatter.h. Empty when a card does not fit into the
/// columns that its identification leaves.
[[nodiscard]] std::vector<std::string> layOut(const CardGroup& group,
                                              std::size_t levels,
                                              CardIds ids);

/// The lines as they stand, without blanks at their ends.
[[nodiscard]] std::vector<std::string> asItStands(const CardGroup& group, CardIds ids);

}  // namespace arelem::frontend
