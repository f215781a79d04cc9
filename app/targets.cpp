#include <iostream>

#include "app/command.h"
#include "app/options.h"

#include "backend/backend.h"

namespace arelem::app {

int runTargets(const Invocation& invocation) {
  CLI::App app("Lists the output formats: the name for --to, the suffixes for -o, what it is.",
               "targets");
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  for (const backend::Target& target : backend::targets()) {
    std::string suffixes;
    for (const std::string_view suffix : target.suffixes) {
      suffixes += (suffixes.empty() ? "" : " ") + std::string(suffix);
    }
    std::cout << fmt::format("{:<12} {:<21} {}\n", target.name, suffixes, target.summary);
  }
  return static_cast<int>(ExitCode::ok);
}

}  // namespace arelem::app
