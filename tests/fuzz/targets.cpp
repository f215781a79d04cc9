#include "tests/fuzz/targets.h"

#include <sstream>

#include "frontend/compile.h"
#include "runtime/run.h"

namespace arelem::fuzz {

namespace {
class Silence : public DiagnosticSink {
 public:
  void accept(Diagnostic diagnostic) override {
    length_ += diagnostic.message.size();  // the text is made, as a user would see it
  }

 private:
  std::size_t length_ = 0;
};

Limits smallLimits() {
  Limits limits;
  limits.steps = 5000;
  limits.depth = 20;
  limits.records = 20'000;
  limits.elements = 5000;
  limits.points = 1000;
  limits.array = 10'000;
  return limits;
}

frontend::Options optionsFor(const std::string& text) {
  frontend::Options options;
  options.dialect = static_cast<frontend::Dialect>(text.size() % frontend::dialectCount);
  options.limits = smallLimits();
  return options;
}
}  // namespace

void readText(const std::string& text) {
  SourceMap sources;
  Silence silence;
  const BufferId buffer = sources.add("fuzz.apt", text);
  const ir::Program program = frontend::compile(sources, buffer, optionsFor(text), silence);
  std::ostringstream out;
  ir::print(out, program);
  ir::FeatureCounts counts;
  ir::survey(program, counts);
}

void wholeProgram(const std::string& text) {
  SourceMap sources;
  Silence silence;
  const BufferId buffer = sources.add("fuzz.apt", text);
  const frontend::Options options = optionsFor(text);
  const ir::Program program = frontend::compile(sources, buffer, options, silence);
  const runtime::Evaluation evaluation =
      runtime::evaluate(program, {options.limits, nullptr, {}}, silence);
  static_cast<void>(evaluation);
}

}  // namespace arelem::fuzz
