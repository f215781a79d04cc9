#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/interrupt.h"

namespace arelem::app {

/// What a command gets: the words after its name.
struct Invocation {
  std::vector<std::string> words;
  InterruptWatch& interrupt;
};

struct Command {
  std::string_view name;
  std::string_view summary;
  int (*run)(const Invocation&);
};

/// THE list of commands, in the order of the help text.
[[nodiscard]] std::span<const Command> commands();

int runAlphabet(const Invocation& invocation);
int runCheck(const Invocation& invocation);
int runCompile(const Invocation& invocation);
int runDiff(const Invocation& invocation);
int runDump(const Invocation& invocation);
int runExplain(const Invocation& invocation);
int runFormat(const Invocation& invocation);
int runGeometry(const Invocation& invocation);
int runLanguage(const Invocation& invocation);
int runRepl(const Invocation& invocation);
int runSpray(const Invocation& invocation);
int runStencil(const Invocation& invocation);
int runTargets(const Invocation& invocation);
int runView(const Invocation& invocation);
int runVerify(const Invocation& invocation);

}  // namespace arelem::app
