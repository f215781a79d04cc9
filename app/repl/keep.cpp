// Commands that write, read and take back: :save, :load, :undo, :redo, :plot, :view.
#include <charconv>
#include <filesystem>
#include <iostream>

#include "app/messages.h"
#include "app/output_file.h"
#include "app/output_set.h"
#include "app/repl/console.h"
#include "app/source_file.h"
#include "app/view/scene_builder.h"

#include "ir/diag/display_text.h"

namespace arelem::app::repl {

namespace {
/// The number behind a command; 1 without one, 0 for anything else.
std::size_t countOf(const std::string& rest) {
  std::size_t n = rest.empty() ? 1 : 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), n);
  return rest.empty() || (error == std::errc{} && end == rest.data() + rest.size()) ? n : 0;
}

std::string entries(std::size_t n) {
  return n == 1 ? "1 entry" : fmt::format("{} entries", n);
}

/// Whether a name without a suffix or with the right one was given; else what to say.
std::string wrongSuffix(const std::string& path, std::string_view wanted) {
  const std::string suffix = std::filesystem::path(path).extension().string();
  return suffix.empty() || suffix == wanted
             ? ""
             : fmt::format(
                   "it writes {} only, not `{}`; `arelem view FILE -o OUT` writes .svg, "
                   ".png and .html",
                   wanted, suffix);
}

std::string picture(Console& console, const std::string& path, std::string_view name) {
  const backend::Target* target = backend::findTarget(name);
  const Run& run = *console.session.run();
  DiagnosticLog log;
  const backend::Context context = backendContext(run.job);  // the writers keep a reference
  OutputSet outputs(log);
  if (outputs.open({{path, target}}, context)) {
    for (const cl::Record& record : run.path->records) {
      outputs.accept(record);
    }
    if (outputs.close(false)) {
      for (const auto& written : outputs.written()) {
        console.out << written.path << fmt::format("  {} bytes\n", written.bytes);
      }
    }
  }
  console.blame(log.exitCode());
  log.print(run.job.sources, run.job.main, console.settings);
  return "";
}
}  // namespace

std::string save(Console& console, const std::string& rest) {
  if (rest.empty()) {
    return "the name of a file is missing; - shows the program";
  }
  const std::string waits = console.session.waiting();
  const std::string leftOut =
      waits.empty() ? "" : "`" + displayText(waits) + "` is left out: it waits for the next motion";
  if (rest == "-") {
    console.out << console.session.program() << std::flush;
    if (!leftOut.empty()) {
      std::cerr << leftOut << '\n';
    }
    return "";
  }
  auto file = openOutput(rest);
  if (!file) {
    console.report(file.takeFailure());
    return "";
  }
  (*file)->stream() << console.session.program();
  if (auto bytes = (*file)->complete(); !bytes) {
    console.report(bytes.takeFailure());
    return "";
  }
  if (auto name = (*file)->commit(false); !name) {
    console.report(name.takeFailure());
    return "";
  }
  console.out << "saved as " << rest << '\n' << leftOut << (leftOut.empty() ? "" : "\n");
  return "";
}

std::string loadFile(Console& console, const std::string& rest) {
  if (rest.empty()) {
    return "the name of a file is missing";
  }
  Result<std::string> bytes = readBytes(rest, console.settings.limits);
  if (!bytes) {
    console.report(bytes.takeFailure());
    return "";
  }
  if (const auto objection = objectionToText(rest, *bytes)) {
    console.report(*objection);
    return "";
  }
  const Session::Answer answer = console.session.load(rest, *bytes, console.interrupt.flag());
  if (answer.verdict.state == Verdict::State::interrupted) {
    return "interrupted; the session is as it was";
  }
  printDiagnostics(console, *answer.run, answer.verdict.found, answer.inserted);
  console.stepped = 0;
  const bool good = answer.verdict.state == Verdict::State::good;
  const Run& run = *console.session.run();
  std::size_t names = 0;
  for (const runtime::Defined& d : run.job.evaluation.defined) {
    names += d.name.empty() ? 0 : 1;
  }
  console.out << fmt::format(
      "{}{}: {}, {}\n", rest, good ? "" : ", without the statements that have errors",
      counted(names, "name"), counted(run.job.motion.facts.size(), "motion"));
  if (!good) {
    console.blame(ExitCode::programHasErrors);
  }
  return "";
}

std::string undo(Console& console, const std::string& rest) {
  const std::size_t n = countOf(rest);
  if (n == 0) {
    return "a number from 1 on is needed";
  }
  const std::size_t done = console.session.undo(n, console.interrupt.flag());
  console.stepped = 0;
  console.out << (done == 0 ? "there is nothing to take back\n"
                            : fmt::format("{} taken back\n", entries(done)));
  return "";
}

std::string redo(Console& console, const std::string& rest) {
  const std::size_t n = countOf(rest);
  if (n == 0) {
    return "a number from 1 on is needed";
  }
  const std::size_t done = console.session.redo(n, console.interrupt.flag());
  console.out << (done == 0 ? "there is nothing to bring again\n"
                            : fmt::format("{} brought again\n", entries(done)));
  return "";
}

std::string plot(Console& console, const std::string& rest) {
  const std::string wrong = wrongSuffix(rest, ".svg");
  return !wrong.empty() ? wrong : picture(console, rest.empty() ? "session.svg" : rest, "svg");
}

std::string view(Console& console, const std::string& rest) {
  const std::string path = rest.empty() ? "session.html" : rest;
  if (std::string wrong = wrongSuffix(path, ".html"); !wrong.empty()) {
    return wrong;
  }
  const InterruptFlag& interrupted = console.interrupt.flag();
  Compilation job(console.settings);
  if (!load(job, "session", console.session.text(), interrupted)) {
    return "interrupted";
  }
  static_cast<void>(evaluate(job, interrupted));
  const backend::Scene scene = buildScene(job, interrupted);
  if (interrupted) {
    return "interrupted; nothing is written";
  }
  auto file = openOutput(path);
  if (!file) {
    console.report(file.takeFailure());
    return "";
  }
  backend::writePage((*file)->stream(), scene);
  if (auto bytes = (*file)->complete(); !bytes) {
    console.report(bytes.takeFailure());
    return "";
  }
  if (auto name = (*file)->commit(false); !name) {
    console.report(name.takeFailure());
    return "";
  }
  console.out << path << "  open it in a browser\n";
  return "";
}

}  // namespace arelem::app::repl
