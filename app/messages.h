#pragma once
#include <array>
#include <string>

#include "app/exit_code.h"
#include "app/settings.h"

#include "ir/diag/diagnostic.h"
#include "ir/text/source_map.h"

namespace arelem::app {

/// Collects the diagnostics of one input, bounded in memory, and prints them in reading order.
class DiagnosticLog : public DiagnosticSink {
 public:
  /// A diagnostic beyond this many is only counted.
  static constexpr std::size_t kept = 10'000;

  void accept(Diagnostic diagnostic) override;
  /// A failure that has no place in a text.
  void accept(Failure failure);

  /// Those kept since the last print.
  [[nodiscard]] const std::vector<Diagnostic>& all() const { return all_; }
  [[nodiscard]] std::size_t errors() const { return errors_; }
  [[nodiscard]] std::size_t warnings() const { return warnings_; }
  /// What the process should return for these diagnostics alone.
  [[nodiscard]] ExitCode exitCode() const { return exitCode_; }

  /// Prints to standard error, at most `settings.maxErrors` errors, and forgets them. The counts
  /// stay.
  void print(const SourceMap& sources, BufferId main, const Settings& settings);

 private:
  std::vector<Diagnostic> all_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
  ExitCode exitCode_ = ExitCode::ok;
};

/// `arelem: error: text`.
void printError(const std::string& text);

/// The same for wrong use of the command itself, with the line that leads to the help.
void printUsageError(const std::string& command, const std::string& text);

/// "1 error", "2 errors".
[[nodiscard]] std::string counted(std::size_t n, const char* noun);

/// Whether colors go to standard error: --color, NO_COLOR, CLICOLOR_FORCE, a terminal.
[[nodiscard]] bool useColor(ColorChoice choice);

}  // namespace arelem::app
