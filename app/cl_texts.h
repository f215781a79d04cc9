#pragma once
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "app/cl_pieces.h"

#include "ir/diag/diagnostic.h"
#include "ir/text/source_map.h"

namespace arelem::app {

/// The texts of a file that is read in pieces, of which only the last ones are there. Spans of
/// piece i have the buffer i.
class ClTexts {
 public:
  /// Takes the next piece and forgets an old one.
  BufferId add(const std::string& name, std::string text, PieceStart start);
  /// For the front end: the last piece under its number.
  [[nodiscard]] SourceMap& map() { return *live_.back(); }
  /// The line of the whole file on which a span begins; 0 where it is unknown.
  [[nodiscard]] std::uint32_t line(const Span& span) const;
  /// A message with places in the whole text, which is the first buffer.
  [[nodiscard]] Diagnostic inWhole(Diagnostic diagnostic) const;

 private:
  [[nodiscard]] Span inWhole(Span span) const;
  /// Texts of so many pieces are there at a time.
  static constexpr std::size_t most = 3;
  std::deque<std::unique_ptr<SourceMap>> live_;
  std::vector<PieceStart> starts_;
};

}  // namespace arelem::app
