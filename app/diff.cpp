#include <iostream>

#include "app/command.h"
#include "app/comparison.h"
#include "app/diff_side.h"
#include "app/number_check.h"
#include "app/options.h"

namespace arelem::app {

namespace {
struct DiffOptions {
  Settings settings;
  DiffAllowed allowed;
  std::string first, second;
  bool json = false;
};

void addOptions(CLI::App& app, DiffOptions& options) {
  app.add_option("A", options.first, "a CL file")->required();
  app.add_option("B", options.second, "another one")->required();
  app.add_option("--tolerance", options.allowed.distance,
                 "largest distance of ends and centers, part unit of A (1e-6)")
      ->check(numberFromZero());
  app.add_option("--degrees", options.allowed.degrees, "largest angle between tool axes (1e-4)")
      ->check(numberFromZero());
  app.add_option("--chords", options.allowed.chords,
                 "straight moves of one file that leave an arc of the other by at most so much "
                 "are that arc, part unit of A (0: never)")
      ->check(numberFromZero());
  app.add_flag("--words", options.allowed.words,
               "the words for the machine between the moves are compared too");
  app.add_flag("--json", options.json, "one JSON object instead of sentences");
  addSourceOptions(app, options.settings);
  addMessageOptions(app, options.settings);
}

/// Compares once. None when a file that was read in pieces must be read at once.
std::optional<ExitCode> compare(const DiffOptions& options,
                                bool inPieces,
                                const InterruptFlag& interrupted) {
  const DiffReading how{options.allowed.words, inPieces};
  DiffSide a(options.settings, options.first, how, interrupted);
  DiffSide b(options.settings, options.second, how, interrupted);
  Comparison comparison(a, b, options.allowed);
  comparison.run();
  const bool readA = a.finish();
  const bool readB = b.finish();
  if (a.stale() || b.stale()) {
    return std::nullopt;
  }
  for (DiffSide* side : {&a, &b}) {
    side->log().print(side->job().sources, side->job().main, options.settings);
  }
  const ExitCode code = worse(a.log().exitCode(), b.log().exitCode());
  if (!readA || !readB || interrupted) {
    return code;
  }
  comparison.finish();
  if (options.json) {
    comparison.printJson(std::cout);
  } else if (!options.settings.quiet || !comparison.same()) {
    comparison.print(std::cout);
  }
  return comparison.same() ? ExitCode::ok : ExitCode::verificationFailed;
}
}  // namespace

int runDiff(const Invocation& invocation) {
  CLI::App app(
      "Compares two CL files (CL text of any system, CL tape, json; a part program is compiled) "
      "move by move:\n"
      "ends, tool axes, arcs, rapid and feed. The exit code is 0 where they agree, 5 where they "
      "differ.",
      "diff");
  DiffOptions options;
  addOptions(app, options);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  const InterruptFlag& interrupted = invocation.interrupt.flag();
  std::optional<ExitCode> code;
  for (bool inPieces = true; !code; inPieces = false) {
    code = compare(options, inPieces, interrupted);
  }
  return static_cast<int>(*code);
}

}  // namespace arelem::app
