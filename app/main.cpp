#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>

#include "app/command.h"
#include "app/messages.h"
#include "app/version.h"

#include "backend/atomic_file.h"

namespace arelem::app {
namespace {

void printHelp(std::ostream& out) {
  out << "arelem compiles APT part programs to cutter-location files.\n\n"
         "usage: arelem FILE... [options]            the same as arelem compile\n"
         "       arelem COMMAND [arguments]\n\ncommands:\n";
  for (const Command& command : commands()) {
    out << fmt::format("  {:<10} {}\n", command.name, command.summary);
  }
  out << "\n`arelem COMMAND --help` tells the options of a command, `arelem --version` the "
         "version.\n"
         "\nexamples:\n"
         "  arelem plate.apt                         CL text on standard output\n"
         "  arelem plate.apt -o plate.cltape         the format follows from the suffix\n"
         "  arelem plate.apt -o plate.cls -o plate.svg\n"
         "  arelem check jobs/*.apt                  errors and warnings only\n"
         "  arelem explain E0201                     a diagnostic with examples\n"
         "\nexit codes: 0 ok, 1 errors in the program, 2 wrong use, 3 unreadable input, 4 "
         "unsolvable geometry or\n"
         "motion, 5 verification failed, 6 output not written, 7 limit reached, 70 internal error, "
         "130 and 143\n"
         "interrupted.\n";
}

int run(std::vector<std::string> words, InterruptWatch& interrupt) {
  if (words.empty()) {
    printHelp(std::cerr);
    return static_cast<int>(ExitCode::wrongUse);
  }
  const std::string first = words.front();
  if (first == "-h" || first == "--help") {
    printHelp(std::cout);
    return static_cast<int>(ExitCode::ok);
  }
  if (first == "-V" || first == "--version") {
    std::cout << "arelem " << versionText() << '\n';
    return static_cast<int>(ExitCode::ok);
  }
  const auto all = commands();
  const auto named =
      std::find_if(all.begin(), all.end(), [&](const Command& c) { return c.name == first; });
  if (named == all.end()) {
    return runCompile({std::move(words), interrupt});
  }
  words.erase(words.begin());
  return named->run({std::move(words), interrupt});
}

/// Nothing below may allocate: memory is what has run out.
void reportOutOfMemory() {
  std::fputs("arelem: error: out of memory; nothing was written (see the limits of --help)\n",
             stderr);
}

ExitCode runUnderWatch(int argc, char** argv) {
  InterruptWatch interrupt;
  interrupt.setLastWill(backend::AtomicFile::removeTemporaries);
  const auto code = static_cast<ExitCode>(run({argv + 1, argv + argc}, interrupt));
  std::cout.flush();
  const ExitCode signal = interrupt.result();
  return signal == ExitCode::ok ? code : signal;
}

int guarded(int argc, char** argv) {
  ExitCode code = ExitCode::ok;
  try {
    code = runUnderWatch(argc, argv);
  } catch (const std::bad_alloc&) {
    reportOutOfMemory();
    code = ExitCode::limitReached;
  } catch (const std::length_error&) {
    reportOutOfMemory();
    code = ExitCode::limitReached;
  } catch (const std::exception& error) {
    std::cerr << "arelem: internal error: " << error.what() << "\n   this is a bug of arelem "
              << versionText() << "; nothing was written\n";
    code = ExitCode::internalError;
  }
  return static_cast<int>(code);
}

}  // namespace
}  // namespace arelem::app

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error of write(), handled where it happens
  std::ios::sync_with_stdio(false);
  return arelem::app::guarded(argc, argv);
}
