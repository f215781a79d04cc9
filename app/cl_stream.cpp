#include "app/cl_stream.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>

#include "app/source_file.h"
#include "app/stopwatch.h"

#include "runtime/path/movnrb.h"

namespace arelem::app {

namespace {
/// Bytes of a piece: some ten thousand statements.
constexpr std::size_t pieceSize = 1U << 20U;
/// Smaller files are read at once.
constexpr std::uintmax_t worthIt = 4U * pieceSize;
/// What is looked at to find out whether a text is CL text.
constexpr std::size_t beginning = 1U << 16U;

/// Only whether anything was said: the ordinary way says it again, with its place.
class Silent : public DiagnosticSink {
 public:
  void accept(Diagnostic /*diagnostic*/) override { said = true; }
  bool said = false;
};

/// Cuts a file at ends of statements.
class Pieces {
 public:
  explicit Pieces(const std::string& path) : in_(path, std::ios::binary) {}

  /// The next piece; empty at the end.
  std::string next() {
    std::string piece = std::move(rest_);
    rest_.clear();
    for (std::size_t wanted = pieceSize;; wanted += pieceSize) {
      while (piece.size() < wanted && in_) {
        const std::size_t before = piece.size();
        piece.resize(wanted);
        in_.read(piece.data() + before, static_cast<std::streamsize>(wanted - before));
        piece.resize(before + static_cast<std::size_t>(in_.gcount()));
      }
      if (!in_) {
        return piece;
      }
      if (const std::size_t end = statementEnd(piece); end != 0) {
        rest_ = piece.substr(end);
        piece.resize(end);
        return piece;
      }
    }
  }
  [[nodiscard]] bool atEnd() const { return rest_.empty() && !in_; }
  [[nodiscard]] bool good() const { return !in_.bad(); }

 private:
  /// Behind the last line feed whose line is not continued; 0 when there is none.
  static std::size_t statementEnd(const std::string& piece) {
    for (std::size_t feed = piece.rfind('\n'); feed != std::string::npos && feed > 0;
         feed = piece.rfind('\n', feed - 1)) {
      const std::size_t last = piece.find_last_not_of(" \t\r", feed - 1);
      if (last == std::string::npos || piece[last] != '$') {
        return feed + 1;
      }
    }
    return 0;
  }

  std::ifstream in_;
  std::string rest_;
};

/// Statements that need nothing but what is carried from piece to piece.
bool standsAlone(const ir::Statement& statement) {
  const ir::Body& body = statement.body;
  if (const auto* command = std::get_if<ir::Command>(&body)) {
    switch (row(command->word).wordClass) {
      case WordClass::postWithParameters:
      case WordClass::postWithoutParameters:
      case WordClass::arelemValue:
      case WordClass::arelemSwitch:
      case WordClass::units:
      case WordClass::motion:
        return true;
      default:
        return command->word == Word::CIRCLE || command->word == Word::MACHIN;
    }
  }
  if (const auto* foreign = std::get_if<ir::ForeignCommand>(&body)) {
    return foreign->word != "SMOOTH";
  }
  return std::holds_alternative<ir::LocateNumbers>(body) ||
         std::holds_alternative<ir::Text>(body) || std::holds_alternative<ir::Fini>(body);
}

bool standsAlone(const ir::Program& program) {
  if (program.blocks.size() != 1 || !program.definitions.empty() || !program.symbols.empty()) {
    return false;
  }
  const auto& statements = program.blocks[0].statements;
  return std::all_of(statements.begin(), statements.end(),
                     [](const ir::Statement& s) { return standsAlone(s); });
}

/// The pieces of one file, and what they have in common.
class Stream {
 public:
  Stream(Compilation& job, cl::RecordSink& records, const InterruptFlag& interrupted)
      : job_(job), interrupted_(interrupted) {
    runtime::Options options{job.settings.limits, &interrupted, {}, false, {}, {}};
    options.axesFollow = true;
    options.keepsFacts = false;
    frames_ = frameStage(job.settings, records, silent_);
    splines_ = path::makeMovnrbCheck(*frames_, silent_);
    execution_.emplace(options, *splines_, silent_);
  }

  /// False when the file must be read at once.
  bool take(std::string text, const std::string& path, bool last) {
    if (objectionToText(path, text) || ended_) {
      return ended_ && text.find_first_not_of(" \t\r\n") == std::string::npos;
    }
    const bool single = compile(std::move(text), path);
    if (!single || silent_.said || interrupted_) {
      return false;
    }
    const auto& statements = program_.blocks[0].statements;
    statements_ += statements.size();
    evaluate();
    ended_ = statements.back().span.length > 0;  // a FINI that was written
    if (!ended_ && !last) {
      evaluation_.actions.pop_back();  // that of the end of the piece
      --statements_;
      --job_.evaluation.steps;
    }
    if (job_.evaluation.steps > job_.settings.limits.steps) {
      return false;
    }
    {
      const Stopwatch watch(job_.seconds.execute);
      execution_->feed(evaluation_.actions);
    }
    return !silent_.said && !interrupted_;
  }

  bool finish() {
    job_.motion = execution_->finish();
    return !silent_.said && job_.motion.complete;
  }
  [[nodiscard]] std::size_t statements() const { return statements_; }

 private:
  bool compile(std::string text, const std::string& path) {
    const Stopwatch watch(job_.seconds.parse);
    frontend::Options options;
    options.dialect = frontend::Dialect::cl;
    options.limits = job_.settings.limits;
    options.interrupted = &interrupted_;
    SourceMap sources;
    const BufferId buffer = sources.add(displayName(path), std::move(text));
    program_ = frontend::compile(sources, buffer, options, silent_);
    return standsAlone(program_) && !program_.blocks[0].statements.empty();
  }

  void evaluate() {
    const Stopwatch watch(job_.seconds.evaluate);
    runtime::Options options{job_.settings.limits, &interrupted_, {}, false, {}, {}};
    options.carried = &carried_;
    evaluation_ = runtime::evaluate(program_, options, silent_);
    job_.evaluation.steps += evaluation_.steps;
    for (runtime::Action& action : evaluation_.actions) {
      action.isn += isn_;
      action.origin = {};  // its text is gone soon
    }
    // The end of a piece has the number of the statement behind it.
    isn_ += static_cast<int>(program_.blocks[0].statements.back().isn) - 1;
  }

  Compilation& job_;
  const InterruptFlag& interrupted_;
  Silent silent_;
  std::unique_ptr<cl::RecordSink> frames_, splines_;
  std::optional<runtime::Execution> execution_;
  runtime::Carried carried_;
  ir::Program program_;
  runtime::Evaluation evaluation_;
  int isn_ = 0;
  std::size_t statements_ = 0;
  bool ended_ = false;
};
}  // namespace

bool isLargeCl(const std::string& path, const Settings& settings) {
  std::error_code error;
  const bool fits = path != "-" && std::filesystem::is_regular_file(path, error) &&
                    std::filesystem::file_size(path, error) >= worthIt &&
                    std::filesystem::file_size(path, error) <= settings.limits.bytes;
  if (!fits || error || !settings.defines.empty()) {
    return false;
  }
  if (settings.dialect != frontend::Dialect::automatic) {
    return settings.dialect == frontend::Dialect::cl;
  }
  std::string begin(beginning, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(in.gcount()));
  return begin.find('\0') == std::string::npos && frontend::looksLikeCl(begin).has_value();
}

Streamed streamCl(Compilation& job,
                  const std::string& path,
                  cl::RecordSink& records,
                  std::size_t& statements,
                  const InterruptFlag& interrupted) {
  Pieces pieces(path);
  Stream stream(job, records, interrupted);
  do {
    std::string piece = pieces.next();
    const bool last = pieces.atEnd();
    if (!pieces.good() || !stream.take(std::move(piece), path, last)) {
      return Streamed::refused;
    }
  } while (!pieces.atEnd());
  if (!stream.finish()) {
    return Streamed::refused;
  }
  statements = stream.statements();
  return Streamed::whole;
}

}  // namespace arelem::app
