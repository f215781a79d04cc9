#include "app/repl/statement_lines.h"

#include <algorithm>
#include <cctype>

#include "frontend/outline.h"
#include "ir/diag/display_text.h"

namespace arelem::app::repl {

namespace {
StatementLines linesOf(const SourceMap& sources,
                       BufferId buffer,
                       const frontend::OutlinedStatement& statement) {
  StatementLines found{sources.locate(buffer, statement.begin).line, {}};
  std::string_view rest =
      sources.text(buffer).substr(statement.begin, statement.end - statement.begin);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view card = rest.substr(0, end);
    if (card.ends_with('\r')) {
      card.remove_suffix(1);
    }
    found.cards.push_back(displayText(card));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return found;
}

/// "A)X=X+1" gives "X=X+1".
std::string_view withoutLabel(std::string_view statement) {
  const auto other = std::find_if(statement.begin(), statement.end(),
                                  [](unsigned char c) { return std::isalnum(c) == 0; });
  return other != statement.end() && *other == ')'
             ? statement.substr(static_cast<std::size_t>(other - statement.begin()) + 1)
             : statement;
}

bool assigns(std::string_view statement, const std::string& name) {
  statement = withoutLabel(statement);
  if (!statement.starts_with(name)) {
    return false;
  }
  statement.remove_prefix(name.size());
  return statement.starts_with('=') ||
         (statement.starts_with('(') && statement.find(")=") != statement.npos);
}

/// All cards of the statement in which `at` begins.
StatementLines statementAt(const SourceMap& sources, const Span& at, const Settings& settings) {
  for (const auto& s :
       frontend::outline(sources.text(at.buffer), settings.dialect, settings.limits)) {
    if (s.begin <= at.begin && at.begin < s.end) {
      return linesOf(sources, at.buffer, s);
    }
  }
  const std::uint32_t line = sources.locate(at.buffer, at.begin).line;
  return {line, {displayText(sources.line(at.buffer, line))}};
}
}  // namespace

std::vector<StatementLines> statementsThatDefine(const SourceMap& sources,
                                                 const runtime::Defined& defined,
                                                 const Settings& settings) {
  const BufferId buffer = defined.definition.buffer;
  std::vector<StatementLines> found;
  if (!defined.entity) {
    for (const auto& s :
         frontend::outline(sources.text(buffer), settings.dialect, settings.limits)) {
      if (assigns(s.text, defined.name)) {
        found.push_back(linesOf(sources, buffer, s));
      }
    }
  }
  if (found.empty()) {
    found.push_back(statementAt(sources, defined.definition, settings));
  }
  return found;
}

}  // namespace arelem::app::repl
