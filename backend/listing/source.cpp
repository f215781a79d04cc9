#include "backend/listing/source.h"

#include <map>
#include <optional>
#include <ostream>

#include <fmt/format.h>

#include "backend/text/clean.h"

namespace arelem::backend {

namespace {
/// ISN of the statement that begins on a line, by buffer and line.
using Numbers = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;

Numbers statementNumbers(const SourceMap& sources, const ir::Program& program) {
  Numbers numbers;
  for (const ir::Block& block : program.blocks) {
    for (const ir::Statement& statement : block.statements) {
      const Span& span = statement.span;
      if (span.buffer.index < sources.size()) {
        numbers.try_emplace({span.buffer.index, sources.locate(span.buffer, span.begin).line},
                            statement.isn);
      }
    }
  }
  return numbers;
}

void printBuffer(std::ostream& out,
                 const SourceMap& sources,
                 BufferId buffer,
                 const Numbers& numbers) {
  const std::string_view text = sources.text(buffer);
  out << fmt::format("\n {}\n\n    ISN   LINE\n", printableAscii(sources.name(buffer)));
  const std::uint32_t count = sources.locate(buffer, static_cast<std::uint32_t>(text.size())).line;
  const bool endsInNewline = text.empty() || text.back() == '\n';
  for (std::uint32_t line = 1; line <= count - (endsInNewline ? 1 : 0); ++line) {
    const auto number = numbers.find({buffer.index, line});
    const std::string isn = number == numbers.end() ? "" : fmt::format_int(number->second).str();
    const std::string shown = printableAscii(sources.line(buffer, line));
    out << fmt::format("{:>7}{:>7}  {}", isn, line, trimmedRight(shown)) << '\n';
  }
}
}  // namespace

void printSource(std::ostream& out, const SourceMap& sources, const ir::Program& program) {
  const Numbers numbers = statementNumbers(sources, program);
  std::optional<std::uint32_t> last;
  for (const auto& [place, isn] : numbers) {
    if (last != place.first) {
      last = place.first;
      printBuffer(out, sources, BufferId{place.first}, numbers);
    }
  }
}

}  // namespace arelem::backend
