#include <array>

#include "app/command.h"
#include "app/messages.h"

namespace arelem::app {

std::span<const Command> commands() {
  static constexpr std::array all = {
      Command{"compile", "part programs to cutter-location files, pictures and reports",
              runCompile},
      Command{"check", "errors and warnings of part programs: text and geometry, no motion",
              runCheck},
      Command{"geometry", "every defined point, line, ... and scalar with its numbers",
              runGeometry},
      Command{"dump", "the inside of a part program or CL file as text", runDump},
      Command{"explain", "what a diagnostic means, with a wrong and a right example", runExplain},
      Command{"targets", "the output formats", runTargets},
  };
  return all;
}

}  // namespace arelem::app
#ifdef ARELEM_PARTIAL  // until frontend, runtime and backend have landed
namespace arelem::app {
namespace {
int unavailable() {
  printUsageError("", "this build holds no front end yet");
  return static_cast<int>(ExitCode::internalError);
}
}  // namespace
int runCheck(const Invocation&) {
  return unavailable();
}
int runCompile(const Invocation&) {
  return unavailable();
}
int runDump(const Invocation&) {
  return unavailable();
}
int runGeometry(const Invocation&) {
  return unavailable();
}
int runTargets(const Invocation&) {
  return unavailable();
}
}  // namespace arelem::app
#endif
