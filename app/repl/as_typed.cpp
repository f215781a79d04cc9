// Diagnostics of a session, with its statements as they were typed.
#include <algorithm>
#include <string>

#include "app/repl/console.h"

namespace arelem::app::repl {

namespace {
/// A span of the text without what was inserted.
Span without(const Span& inserted, Span span) {
  if (span.buffer != inserted.buffer || span.end() <= inserted.begin) {
    return span;
  }
  const auto moved = [&](std::uint32_t at) {
    return at <= inserted.begin ? at : std::max(at, inserted.end()) - inserted.length;
  };
  const std::uint32_t begin = moved(span.begin);
  return {span.buffer, begin, moved(span.end()) - begin};
}

SourceMap without(const Span& inserted, const SourceMap& sources) {
  SourceMap typed;
  for (std::uint32_t i = 0; i < sources.size(); ++i) {
    std::string text(sources.text(BufferId{i}));
    if (inserted.buffer == BufferId{i}) {
      text.erase(inserted.begin, inserted.length);
    }
    typed.add(std::string(sources.name(BufferId{i})), std::move(text));
  }
  return typed;
}

void remove(const Span& inserted, Diagnostic& d) {
  d.at = without(inserted, d.at);
  for (Label& label : d.labels) {
    label.span = without(inserted, label.span);
  }
  for (Span& call : d.calledFrom) {
    call = without(inserted, call);
  }
}
}  // namespace

void printDiagnostics(const Console& console,
                      const Run& run,
                      std::vector<Diagnostic> found,
                      const std::optional<Span>& inserted) {
  if (found.empty()) {
    return;
  }
  DiagnosticLog log;
  for (Diagnostic& d : found) {
    if (inserted) {
      remove(*inserted, d);
    }
    log.accept(std::move(d));
  }
  console.out.flush();
  log.print(inserted ? without(*inserted, run.job.sources) : run.job.sources, run.job.main,
            console.settings);
}

}  // namespace arelem::app::repl
