#pragma once
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "frontend/compile.h"
#include "runtime/run.h"

namespace arelem::test {

/// A program text taken through the frontend and Section 1.
struct SectionOne {
  SourceMap sources;
  CollectingSink sink;
  runtime::Evaluation evaluation;

  explicit SectionOne(std::string text) { run(sources.add("test.apt", std::move(text))); }
  explicit SectionOne(const std::filesystem::path& file,
                      frontend::Dialect dialect = frontend::Dialect::automatic)
      : dialect_(dialect) {
    std::ifstream in(file, std::ios::binary);
    run(sources.add(file.filename().string(), {std::istreambuf_iterator<char>(in), {}}));
  }

  [[nodiscard]] bool reports(std::string_view legacy) const {
    for (const Diagnostic& d : sink.all()) {
      if (d.kind().legacy == legacy) {
        return true;
      }
    }
    return false;
  }
  /// Every diagnostic, one a line, for the message of a failed test.
  [[nodiscard]] std::string messages() const {
    std::string all;
    for (const Diagnostic& d : sink.all()) {
      const LineColumn place = sources.locate(d.at.buffer, d.at.begin);
      all += fmt::format("{}:{} {} [{}] {}\n", place.line, place.column, d.kind().code,
                         d.kind().legacy, d.message);
    }
    return all;
  }

 private:
  void run(BufferId buffer) {
    frontend::Options options;
    options.dialect = dialect_;
    options.libraryPath = {ARELEM_SOURCE_DIR "/stdlib"};
    const ir::Program program = frontend::compile(sources, buffer, options, sink);
    evaluation = runtime::evaluate(program, {}, sink);
  }

  frontend::Dialect dialect_ = frontend::Dialect::automatic;
};

}  // namespace arelem::test
