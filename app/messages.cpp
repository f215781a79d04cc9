#include "app/messages.h"

#include <cstdlib>
#include <iostream>

#include <unistd.h>

#include "ir/diag/display_text.h"
#include "ir/diag/reading_order.h"
#include "ir/diag/render_json.h"
#include "ir/diag/render_text.h"

namespace arelem::app {

namespace {
bool set(const char* name) {
  const char* value =
      std::getenv(name);  // NOLINT(concurrency-mt-unsafe): read once, nothing writes it
  return value != nullptr && *value != '\0';
}
}  // namespace

std::string counted(std::size_t n, const char* noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

bool useColor(ColorChoice choice) {
  if (choice != ColorChoice::automatic) {
    return choice == ColorChoice::always;
  }
  if (set("NO_COLOR")) {
    return false;
  }
  return set("CLICOLOR_FORCE") || ::isatty(STDERR_FILENO) == 1;
}

void printError(const std::string& text) {
  std::cerr << "arelem: error: " << displayText(text) << '\n';
}

void printUsageError(const std::string& command, const std::string& text) {
  const std::string help = command.empty() ? "arelem --help" : "arelem " + command + " --help";
  printError(text);
  std::cerr << "   try `" << help << "`\n";
}

void DiagnosticLog::accept(Diagnostic diagnostic) {
  const bool error = diagnostic.severity() == Severity::error;
  (error ? errors_ : warnings_) += 1;
  exitCode_ = worse(exitCode_, exitCodeFor(diagnostic.kind()));
  if (all_.size() < kept) {
    all_.push_back(std::move(diagnostic));
  }
}

void DiagnosticLog::accept(Failure failure) {
  accept(at(nowhere, std::move(failure)));
}

void DiagnosticLog::print(const SourceMap& sources, BufferId main, const Settings& settings) {
  TextRendering rendering;
  rendering.color = useColor(settings.color);
  rendering.excerpt = settings.format == DiagnosticFormat::human;
  std::size_t shown = 0;
  for (const Diagnostic& d : inReadingOrder(std::move(all_), main)) {
    const bool error = d.severity() == Severity::error;
    if ((!error && settings.quiet) || (error && shown == settings.maxErrors)) {
      continue;
    }
    shown += error ? 1 : 0;
    if (settings.format == DiagnosticFormat::json) {
      renderJson(std::cerr, d, sources);
    } else {
      renderText(std::cerr, d, sources, rendering);
    }
  }
  all_.clear();
  if (shown == settings.maxErrors && errors_ > shown && settings.format != DiagnosticFormat::json) {
    std::cerr << fmt::format("arelem: {} in all, the first {} shown (--max-errors)\n",
                             counted(errors_, "error"), shown);
  }
}

}  // namespace arelem::app
