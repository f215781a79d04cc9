#include "app/depfile.h"

#include "app/output_file.h"

#include "ir/diag/render_text.h"

namespace arelem::app {

namespace {
/// Blanks, `#` and `$` as make wants them.
std::string escaped(const std::string& path) {
  std::string text;
  for (const char c : path) {
    text += c == ' ' || c == '#' ? "\\" : c == '$' ? "$" : "";
    text += c;
  }
  return text;
}
}  // namespace

void writeDepfile(Compilation& job,
                  const PlannedJob& plan,
                  const std::vector<std::string>& more,
                  const std::string& path) {
  std::string rule;
  for (const PlannedOutput& output : plan.outputs) {
    rule += (rule.empty() ? "" : " ") + escaped(output.path);
  }
  rule += ":";
  for (std::uint32_t i = 0; i < job.sources.size(); ++i) {
    rule += " \\\n  " + escaped(std::string(job.sources.name({i})));
  }
  for (const std::string& file : job.filesRead) {
    rule += " \\\n  " + escaped(file);
  }
  for (const std::string& file : more) {
    rule += " \\\n  " + escaped(file);
  }
  Result<std::unique_ptr<OutputFile>> file = openOutput(path);
  if (!file) {
    job.log.accept(file.takeFailure());
    return;
  }
  (*file)->stream() << rule << '\n';
  Result<std::string> name = (*file)->commit(false);
  if (!name) {
    job.log.accept(name.takeFailure());
  }
}

}  // namespace arelem::app
