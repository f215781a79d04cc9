#pragma once
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "frontend/compile.h"

namespace arelem::frontend {

inline std::string readFile(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

/// A compiled text: its program in the form of `--to ir`, and what was reported.
struct Compiled {
  SourceMap sources;
  ir::Program program;
  CollectingSink sink;

  /// Codes in order of report, "E0201 W0202".
  [[nodiscard]] std::string codes() const {
    std::string all;
    for (const Diagnostic& d : sink.all()) {
      all += (all.empty() ? "" : " ") + std::string(d.kind().code);
    }
    return all;
  }
  /// Old numbers of the errors.
  [[nodiscard]] std::string legacy() const {
    std::string all;
    for (const Diagnostic& d : sink.all()) {
      if (d.severity() == Severity::error) {
        all += (all.empty() ? "" : " ") + std::string(d.kind().legacy);
      }
    }
    return all;
  }
  /// Statement lines of a block without index and isn.
  [[nodiscard]] std::vector<std::string> block(std::size_t wanted = 0) const {
    std::ostringstream out;
    ir::print(out, program);
    std::istringstream in(out.str());
    std::vector<std::string> lines;
    std::string line;
    const std::string head = "block " + std::to_string(wanted);
    bool inside = false;
    while (std::getline(in, line)) {
      if (line.rfind("block ", 0) == 0) {
        inside = line == head || line.rfind(head + " ", 0) == 0;
      } else if (inside) {
        lines.push_back(line.substr(15));
      }
    }
    return lines;
  }
  /// Text under the first diagnostic.
  [[nodiscard]] std::string blamed() const {
    return sink.all().empty() ? "" : std::string(sources.text(sink.all().front().at));
  }
};

/// Compiles `text` as it stands.
inline std::unique_ptr<Compiled> compileText(const std::string& text,
                                             Dialect dialect = Dialect::automatic,
                                             Options options = {}) {
  auto c = std::make_unique<Compiled>();
  options.dialect = dialect;
  const BufferId buffer = c->sources.add("test.apt", text);
  c->program = compile(c->sources, buffer, options, c->sink);
  return c;
}

/// Compiles `body` with a FINI after it and returns its statements (without FINI).
inline std::vector<std::string> statements(const std::string& body,
                                           Dialect dialect = Dialect::automatic) {
  const auto c = compileText(body + "\nFINI\n", dialect);
  EXPECT_EQ(c->codes(), "") << body;
  auto lines = c->block();
  EXPECT_FALSE(lines.empty());
  if (!lines.empty()) {
    EXPECT_EQ(lines.back(), "FINI");
    lines.pop_back();
  }
  return lines;
}
inline std::string statement(const std::string& body, Dialect dialect = Dialect::automatic) {
  const auto lines = statements(body, dialect);
  return lines.empty() ? "" : lines.back();
}
/// Old numbers of the errors in `body`.
inline std::string errors(const std::string& body, Dialect dialect = Dialect::automatic) {
  return compileText(body + "\nFINI\n", dialect)->legacy();
}
/// Codes of everything reported for `body`.
inline std::string reported(const std::string& body, Dialect dialect = Dialect::automatic) {
  return compileText(body + "\nFINI\n", dialect)->codes();
}

}  // namespace arelem::frontend
