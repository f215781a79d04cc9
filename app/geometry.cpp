#include <iostream>

#include "app/command.h"
#include "app/options.h"
#include "app/pipeline.h"

#include "ir/diag/render_json.h"

namespace arelem::app {

namespace {
const std::string nested = "*NESTED*";  // the old listing's name of a definition in parentheses

struct Row {
  std::string_view type;
  std::span<const double> values;
};

Row rowOf(const runtime::Defined& defined) {
  if (defined.entity) {
    return {spell(defined.entity->type), defined.entity->canon};
  }
  return {"SCALAR", {&defined.scalar, 1}};
}

/// Shortest digits that give the same double again.
std::string numbers(std::span<const double> values, std::string_view separator) {
  return fmt::format("{}", fmt::join(values, separator));
}

void printJson(const std::vector<runtime::Defined>& all) {
  std::string separator = "\n";
  std::cout << '[';
  for (const runtime::Defined& defined : all) {
    const Row row = rowOf(defined);
    std::cout << separator
              << fmt::format(
                     R"({{"name": {}, "subscript": {}, "type": "{}", "n": {}, "values": [{}]}})",
                     jsonString(defined.name.empty() ? nested : defined.name), defined.subscript,
                     row.type, row.values.size(), numbers(row.values, ", "));
    separator = ",\n";
  }
  std::cout << "\n]\n";
}

void printTable(const std::vector<runtime::Defined>& all) {
  for (const runtime::Defined& defined : all) {
    const Row row = rowOf(defined);
    const std::string name = defined.name.empty() ? nested
                             : defined.subscript == 0
                                 ? defined.name
                                 : fmt::format("{}({})", defined.name, defined.subscript);
    std::cout << fmt::format("{:<12} {:<7} {:>3}  {}\n", name, row.type, row.values.size(),
                             numbers(row.values, "  "));
  }
}
}  // namespace

int runGeometry(const Invocation& invocation) {
  CLI::App app(
      "Prints every definition of a part program in the order of execution: name, type, count, "
      "canonical numbers. A scalar stands where it got its first value, with its last one.",
      "geometry");
  Settings settings;
  std::string file;
  bool json = false;
  app.add_option("FILE", file, "a part program; - is standard input")->required();
  app.add_flag("--json", json, "an array of {name, subscript, type, n, values}");
  addSourceOptions(app, settings);
  addMessageOptions(app, settings);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  const InterruptFlag& interrupted = invocation.interrupt.flag();
  Compilation job(settings);
  if (load(job, file, interrupted)) {
    static_cast<void>(evaluate(job, interrupted, true));
    (json ? printJson : printTable)(job.evaluation.history);
  }
  job.log.print(job.sources, job.main, settings);
  return static_cast<int>(job.log.exitCode());
}

}  // namespace arelem::app
