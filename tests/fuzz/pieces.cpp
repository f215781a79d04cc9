#include "tests/fuzz/pieces.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "app/cl_input.h"
#include "app/cl_stream.h"
#include "app/word_counts.h"
#include <unistd.h>

#include "backend/backend.h"
#include "ir/diag/reading_order.h"
#include "ir/diag/render_text.h"

namespace arelem::fuzz {

namespace {
/// A file of this process, removed at its end.
class Scratch {
 public:
  Scratch()
      : path_((std::filesystem::temp_directory_path() /
               ("arelem_fuzz_" + std::to_string(::getpid()) + ".cls"))
                  .string()) {}
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::string& write(const std::string& text) {
    std::ofstream(path_, std::ios::binary) << text;
    return path_;
  }

 private:
  std::string path_;
};

/// What a reading gives: a tape and the messages as a user sees them.
struct Given {
  std::string records, messages;
};

std::string messagesOf(const app::Compilation& job) {
  std::ostringstream out;
  for (const Diagnostic& d : inReadingOrder(job.log.all(), job.main)) {
    renderText(out, d, job.sources, {});
  }
  return std::move(out).str();
}

app::Settings smallSettings() {
  app::Settings settings;
  settings.limits.steps = 5000;
  settings.limits.records = 20'000;
  settings.limits.elements = 5000;
  return settings;
}
}  // namespace

void inPieces(const std::string& text) {
  static Scratch scratch;
  const std::string& path = scratch.write(text);
  const app::Settings settings = smallSettings();
  const InterruptFlag never{false};
  const app::ClStreamRules rules{100 + text.size() % 400, 1};
  const auto dialect = app::streamDialect(path, settings, rules);
  if (!dialect) {
    return;
  }
  Given pieces, whole;
  app::Compilation first(settings);
  CollectingSink messages;
  std::ostringstream tape;
  const auto writer = backend::findTarget("cltape")->make(tape, {}, messages);
  app::ClTexts texts;
  app::ClStreamEnd end{*writer, messages, texts};
  if (app::streamCl(first, path, *dialect, end, never, rules) == app::Streamed::refused) {
    return;
  }
  writer->finish();
  pieces = {std::move(tape).str(), messagesOf(first)};
  app::Compilation second(settings);
  std::ostringstream again;
  const auto wholeWriter = backend::findTarget("cltape")->make(again, {}, second.log);
  auto file = app::ClFile::open(path, settings.limits);
  const bool good = file && app::readRecords(second, *file, *wholeWriter, never);
  wholeWriter->finish();
  whole = {std::move(again).str(), messagesOf(second)};
  if (!good || pieces.records != whole.records || pieces.messages != whole.messages) {
    std::cerr << "read in pieces:\n" << pieces.messages << "read at once:\n" << whole.messages;
    std::abort();
  }
}

}  // namespace arelem::fuzz
