#pragma once
#include <iosfwd>

#include "ir/diag/diagnostic.h"
#include "ir/text/source_map.h"

namespace arelem {

/// A diagnostic that concerns no place of a text (a file that cannot be read) has this buffer.
inline constexpr Span nowhere{BufferId{0xFFFFFFFF}, 0, 0};

struct TextRendering {
  bool color = false;       ///< ANSI colors
  bool excerpt = true;      ///< false: only the GNU line `file:line:col: severity[code]: text`
  std::size_t width = 100;  ///< columns of source shown; longer lines are cut round the place
  std::size_t calls = 10;   ///< called-from lines shown
};

/// The message as people read it: GNU line, source with carets, labels, calls, notes, help.
void renderText(std::ostream& out,
                const Diagnostic& diagnostic,
                const SourceMap& sources,
                const TextRendering& rendering);

/// `file:line:column`, or the empty string for `nowhere`.
[[nodiscard]] std::string describePlace(const Span& span, const SourceMap& sources);

}  // namespace arelem
