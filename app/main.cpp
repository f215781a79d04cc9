#include <algorithm>
#include <array>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>

#include "app/command.h"
#include "app/exit_code.h"
#include "app/messages.h"
#include "app/nearest.h"
#include "app/version.h"
#include <poll.h>
#include <unistd.h>

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

auto commandNamed(const auto& all, const std::string& name) {
  return std::find_if(all.begin(), all.end(), [&](const Command& c) { return c.name == name; });
}

/// The command that was meant by a word that is none, or "".
std::string commandMeant(const std::string& word) {
  std::vector<std::string> names;
  for (const Command& command : commands()) {
    names.emplace_back(command.name);
  }
  return nearest(word, names);
}

/// Flags and `--option=value` may stand before the command. Other options may not: a word behind
/// them may be their value.
void commandFirst(std::vector<std::string>& words) {
  constexpr std::array<std::string_view, 4> flags = {"-q", "--quiet", "-v", "--verbose"};
  const auto command = std::find_if_not(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(flags.begin(), flags.end(), word) != flags.end() ||
           (word.starts_with("--") && word.find('=') != std::string::npos);
  });
  const auto all = commands();
  if (command != words.end() && commandNamed(all, *command) != all.end()) {
    std::rotate(words.begin(), command, command + 1);
  }
}

int run(std::vector<std::string> words, InterruptWatch& interrupt) {
  if (words.empty()) {
    printHelp(std::cerr);
    return static_cast<int>(ExitCode::wrongUse);
  }
  commandFirst(words);
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
  const auto named = commandNamed(all, first);
  if (named == all.end()) {
    std::error_code unknown;
    if (!std::filesystem::exists(first, unknown)) {
      if (first == "help") {
        if (words.size() > 1 && commandNamed(all, words[1]) != all.end()) {
          return run({words[1], "--help"}, interrupt);
        }
        printHelp(std::cout);
        return static_cast<int>(ExitCode::ok);
      }
      if (const std::string meant = commandMeant(first); !meant.empty()) {
        printUsageError("", "there is neither a file nor a command `" + first +
                                "`; did you mean `" + meant + "`?");
        return static_cast<int>(ExitCode::inputUnreadable);
      }
    }
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

/// A reader that left (head) is no fault; a full disk is.
bool outputIsLost() {
  std::cout.flush();
  if (std::cout.good()) {
    return false;
  }
  pollfd out{STDOUT_FILENO, POLLOUT, 0};
  const bool left = ::poll(&out, 1, 0) > 0 && (out.revents & POLLERR) != 0;
  if (!left) {
    std::fputs(
        "arelem: error: standard output cannot be written; what was to stand there is lost\n",
        stderr);
  }
  return !left;
}

ExitCode runUnderWatch(int argc, char** argv) {
  InterruptWatch interrupt;
  interrupt.setLastWill(backend::AtomicFile::removeTemporaries);
  const auto code = static_cast<ExitCode>(run({argv + 1, argv + argc}, interrupt));
  const bool lost = outputIsLost();
  const ExitCode signal = interrupt.result();
  return signal != ExitCode::ok ? signal : lost ? worse(code, ExitCode::outputNotWritten) : code;
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
