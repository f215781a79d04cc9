#include <array>

#include "app/command.h"
#include "app/time.h"

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
      Command{"spray", "passes, times, paint, cost and film of SPRAY statements", runSpray},
      Command{"stencil", "strokes, times, tilt and film of STENCL statements", runStencil},
      Command{"alphabet", "the symbols of an alphabet file: picture and films", runAlphabet},
      Command{"verify", "reads an output again and compares it with its part program", runVerify},
      Command{"diff", "compares two CL files move by move", runDiff},
      Command{"time", "how long a machine takes for the path of a part program", runTime},
      Command{"view", "pictures, and a page that plays the path in a browser", runView},
      Command{"repl", "computes statements as they are typed", runRepl},
      Command{"fmt", "lays part programs out anew, with the same meaning", runFormat},
      Command{"explain", "what a diagnostic means, with a wrong and a right example", runExplain},
      Command{"language", "definition forms and statements: their syntax and meaning", runLanguage},
      Command{"targets", "the output formats", runTargets},
  };
  return all;
}

}  // namespace arelem::app
