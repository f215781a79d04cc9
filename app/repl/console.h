#pragma once
#include <ostream>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/repl/display.h"

#include "runtime/timing/cut_timer.h"

namespace arelem::app::repl {

/// What the commands of a session work on.
struct Console {
  Settings& settings;
  Session& session;
  InterruptWatch& interrupt;
  std::ostream& out;
  Style style;
  timing::Machine machine;  ///< of :time
  std::size_t stepped = 0;  ///< motions that :step has shown
  bool leaving = false;
  ExitCode worst = ExitCode::ok;  ///< of what was refused

  /// A command that was used wrongly counts only where nothing else went wrong.
  void blame(ExitCode code);
  /// Prints a failure as the other commands do, and blames its exit code.
  void report(Failure failure);
};

/// What the last word of a command may be.
enum class Completes : std::uint8_t {
  nothing,
  name,
  typeOrName,
  setting,
  help,     ///< what there is help on
  program,  ///< files that may be part programs, and folders
  picture,
  page
};

/// A command that begins with a colon.
struct ConsoleCommand {
  std::string_view name;       ///< ":help"
  std::string_view arguments;  ///< "[WORD]"
  std::string_view summary;
  Completes completes = Completes::nothing;
  /// What is wrong, or "".
  std::string (*run)(Console& console, const std::string& rest);
};

/// THE list of commands, in the order of the help text.
[[nodiscard]] std::span<const ConsoleCommand> consoleCommands();

/// Carries out a line that begins with a colon. A command may be shortened as long as it is clear.
void obey(Console& console, const std::string& line);

/// The names of :set.
[[nodiscard]] std::vector<std::string> settingNames();

/// Prints diagnostics of a run as the other commands do. `inserted`: what nobody typed, the name of
/// an unnamed result; text and columns are shown without it.
void printDiagnostics(const Console& console,
                      const Run& run,
                      std::vector<Diagnostic> found,
                      const std::optional<Span>& inserted = {});

// Commands, by the file that has them.
std::string showEntity(Console& console, const std::string& rest);  // look.cpp
std::string listNames(Console& console, const std::string& rest);
std::string explainEntity(Console& console, const std::string& rest);
std::string measure(Console& console, const std::string& rest);
std::string tellCurve(Console& console, const std::string& rest);  // curve.cpp
std::string help(Console& console, const std::string& rest);       // help.cpp
std::string save(Console& console, const std::string& rest);       // keep.cpp
std::string loadFile(Console& console, const std::string& rest);
std::string undo(Console& console, const std::string& rest);
std::string redo(Console& console, const std::string& rest);
std::string plot(Console& console, const std::string& rest);
std::string view(Console& console, const std::string& rest);
std::string tellTime(Console& console, const std::string& rest);  // motion.cpp
std::string step(Console& console, const std::string& rest);
std::string set(Console& console, const std::string& rest);  // settings.cpp

/// The name and subscript of "A(3)" in upper case; the rest of a program's name rules is its own.
struct NamePart {
  std::string name;
  int subscript = 0;
};
[[nodiscard]] NamePart nameOf(const Console& console, std::string text);
/// The last definition of a name, or nullptr.
[[nodiscard]] const runtime::Defined* findDefined(const Console& console, const NamePart& name);

}  // namespace arelem::app::repl
