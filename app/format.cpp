#include <iostream>

#include "app/command.h"
#include "app/messages.h"
#include "app/options.h"
#include "app/output_file.h"
#include "app/source_file.h"

#include "frontend/format/formatter.h"

namespace arelem::app {

namespace {
struct FormatChoice {
  Settings settings;
  std::vector<std::string> files;
  bool check = false;
  bool toOutput = false;
  bool dropIds = false;
};

void addOptions(CLI::App& app, FormatChoice& choice) {
  app.add_option("FILE", choice.files, "part programs; - is standard input, to standard output")
      ->required();
  app.add_flag("--check", choice.check,
               "changes nothing; names the files that would change, exit code 1 if there are any");
  app.add_flag("--stdout", choice.toOutput, "the result to standard output; for one file");
  app.add_flag("--drop-columns", choice.dropIds,
               "without the identification in columns 73-80, which else stays in its columns");
  addSourceOptions(app, choice.settings);
  addMessageOptions(app, choice.settings);
}

ExitCode report(Failure failure, const Settings& settings) {
  DiagnosticLog log;
  log.accept(std::move(failure));
  log.print(SourceMap(), {}, settings);
  return log.exitCode();
}

ExitCode write(const std::string& path, const std::string& text, const Settings& settings) {
  auto file = openOutput(path);
  if (!file) {
    return report(file.takeFailure(), settings);
  }
  (*file)->stream() << text;
  if (auto size = (*file)->complete(); !size) {
    return report(size.takeFailure(), settings);
  }
  if (auto name = (*file)->commit(false); !name) {
    return report(name.takeFailure(), settings);
  }
  return ExitCode::ok;
}

void say(const FormatChoice& choice, const std::string& path, const std::string& what) {
  if (!choice.settings.quiet) {
    std::cerr << displayName(path) << ": " << what << '\n';
  }
}

/// `changes` counts the files whose text was, or with --check is, not what it should be.
ExitCode formatOne(const std::string& path, const FormatChoice& choice, std::size_t& changes) {
  const Settings& settings = choice.settings;
  Result<std::string> bytes = readBytes(path, settings.limits);
  if (!bytes) {
    return report(bytes.takeFailure(), settings);
  }
  if (std::optional<Failure> objection = objectionToText(path, *bytes)) {
    return report(*std::move(objection), settings);
  }
  const frontend::Formatted result = frontend::format(
      *bytes, {settings.dialect, settings.limits,
               choice.dropIds ? frontend::CardIds::drop : frontend::CardIds::keep});
  const bool changed = result.text != *bytes;
  if (result.clText) {
    say(choice, path, "left as it is: this is CL text of a CAM system");
  }
  if (choice.check) {
    if (changed) {
      ++changes;
      say(choice, path, "would change");
    }
    return ExitCode::ok;
  }
  if (path == "-" || choice.toOutput) {
    return write("-", result.text, settings);
  }
  const ExitCode code = changed ? write(path, result.text, settings) : ExitCode::ok;
  changes += changed && code == ExitCode::ok ? 1 : 0;
  return code;
}
}  // namespace

int runFormat(const Invocation& invocation) {
  CLI::App app(
      "Lays part programs out anew, in place: upper case, loops and macros indented, long "
      "statements broken at commas.\nComments, texts and the meaning stay as they are.",
      "fmt");
  FormatChoice choice;
  addOptions(app, choice);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  if (choice.toOutput && choice.files.size() > 1) {
    printUsageError("fmt", "`--stdout` is for one file");
    return static_cast<int>(ExitCode::wrongUse);
  }
  ExitCode result = ExitCode::ok;
  std::size_t changes = 0;
  std::size_t failures = 0;
  for (const std::string& file : choice.files) {
    if (!invocation.interrupt.flag()) {
      const ExitCode code = formatOne(file, choice, changes);
      failures += code == ExitCode::ok ? 0 : 1;
      result = worse(result, code);
    }
  }
  if (choice.check && changes > 0) {
    result = worse(result, ExitCode::programHasErrors);
  }
  if (!choice.settings.quiet && !choice.toOutput && choice.files.front() != "-") {
    std::cerr << fmt::format("arelem: {}, {} {}{}\n", counted(choice.files.size(), "file"), changes,
                             choice.check ? "would change" : "changed",
                             failures == 0 ? "" : fmt::format(", {} failed", failures));
  }
  return static_cast<int>(result);
}

}  // namespace arelem::app
