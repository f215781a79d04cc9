#include "app/cl_stream.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <future>
#include <utility>

#include "app/source_file.h"
#include "app/stopwatch.h"

#include "ir/diag/frontend.h"
#include "ir/diag/interpret.h"
#include "ir/diag/render_text.h"
#include "runtime/interpret/ignored.h"
#include "runtime/path/curve_needs.h"
#include "runtime/path/feed_override.h"
#include "runtime/path/movnrb.h"
#include "runtime/path/swarf.h"

namespace arelem::app {

namespace {
/// What is looked at to find out whether a text is CL text.
constexpr std::size_t beginning = 1U << 16U;

/// Statements that need nothing but what is carried from piece to piece.
bool standsAlone(const ir::Statement& statement) {
  const ir::Body& body = statement.body;
  if (const auto* command = std::get_if<ir::Command>(&body)) {
    if (command->word == Word::SMOOTH || command->word == Word::MACHLM) {
      return false;  // of the whole path
    }
    switch (row(command->word).wordClass) {
      case WordClass::postWithParameters:
      case WordClass::postWithoutParameters:
      case WordClass::arelemValue:
      case WordClass::arelemSwitch:
      case WordClass::toolPosition:
      case WordClass::runControl:
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
  return !statements.empty() && std::all_of(statements.begin(), statements.end(),
                                            [](const ir::Statement& s) { return standsAlone(s); });
}

/// Actions whose motion is rewritten over the whole program, unless a CAM system did so already.
bool needsAll(const std::vector<runtime::Action>& actions, frontend::Dialect dialect) {
  return dialect != frontend::Dialect::cl &&
         (path::overridesFeeds(actions) || path::firstSwarf(actions).has_value() ||
          path::needsChords(actions));
}
}  // namespace

class ClReading::Reader {
 public:
  Reader(Compilation& job,
         ClTexts& texts,
         const std::string& path,
         frontend::Dialect dialect,
         const InterruptFlag& interrupted,
         const ClStreamRules& rules)
      : job_(job),
        texts_(texts),
        path_(path),
        dialect_(dialect),
        interrupted_(interrupted),
        pieces_(path, rules.piece) {}

  bool open() {
    std::optional<ClPieces::Piece> piece = pieces_.next();
    if (!piece) {
      return false;
    }
    last_ = piece->last;
    size_ = piece->text.size();
    good_ = good_ && !objectionToText(path_, piece->text);
    if (!last_ && frontend::rulesOf(dialect_).missingFini == frontend::Leave::refused) {
      piece->text += "FINI\n";  // the end of a piece is no end of the program
    }
    buffer_ = texts_.add(displayName(path_), std::move(piece->text), piece->start);
    return true;
  }

  std::unique_ptr<ClPiece> read() {
    const std::string_view text = texts_.map().text(buffer_).substr(0, size_);
    if (!good_ || !pieces_.good() ||
        (ended_ && text.find_first_not_of(" \t\r\n") != std::string_view::npos)) {
      return nullptr;
    }
    auto piece = std::make_unique<ClPiece>();
    piece->buffer = buffer_;
    piece->text = text;
    if (ended_) {
      return piece;
    }
    CollectingSink messages;
    if (!compile(*piece, messages)) {
      return nullptr;
    }
    evaluate(*piece, messages);
    const bool most = job_.evaluation.steps > job_.settings.limits.steps;
    return tell(*piece, messages.all()) && good_ && !most && !interrupted_ ? std::move(piece)
                                                                           : nullptr;
  }

  bool take(const std::vector<Diagnostic>& messages) {
    for (const Diagnostic& d : messages) {
      late_.push_back(texts_.inWhole(d));
    }
    return check(messages);
  }

  /// Messages in the order in which a reading at once tells them.
  bool finish() {
    for (const runtime::Ignored& known : ignored_) {
      told_.push_back(texts_.inWhole(runtime::noEffect(known)));
    }
    told_.insert(told_.end(), late_.begin(), late_.end());
    if (told_.empty()) {
      return pieces_.good();
    }
    Result<std::string> text = readBytes(path_, job_.settings.limits);
    if (!text) {
      return false;
    }
    job_.main = job_.sources.add(displayName(path_), *std::move(text));
    for (Diagnostic& d : told_) {
      job_.log.accept(std::move(d));
    }
    return pieces_.good();
  }
  [[nodiscard]] std::size_t statements() const { return statements_; }

 private:
  /// What has no effect is counted and told at the end.
  bool tell(ClPiece& piece, const std::vector<Diagnostic>& messages) {
    for (const Diagnostic& d : messages) {
      // A text has this one once, at the first of them.
      const bool again = d.row == diag::InvisibleCharacter.row && std::exchange(invisible_, true);
      if (d.row != diag::NoEffect.row && !again) {
        piece.messages.push_back(d);
        told_.push_back(texts_.inWhole(d));
      }
    }
    for (const runtime::Ignored& here : piece.evaluation.ignored) {
      const auto known =
          std::find_if(ignored_.begin(), ignored_.end(),
                       [&](const runtime::Ignored& i) { return i.what == here.what; });
      if (known != ignored_.end()) {
        known->times += here.times;
        continue;
      }
      ignored_.push_back(here);
      piece.messages.push_back(runtime::noEffect(here));
    }
    return check(piece.messages);
  }

  /// False for what is not told, or not in the same way, of a file in pieces.
  bool check(const std::vector<Diagnostic>& messages) {
    const bool good = std::all_of(messages.begin(), messages.end(), [](const Diagnostic& d) {
      const bool countsBytes = d.row == diag::NotUtf8.row;  // in its words, from the beginning
      return !countsBytes && d.at.buffer != nowhere.buffer && d.severity() != Severity::error;
    });
    // Beyond these some are only counted, and not the same ones as for a text read at once.
    const std::uint64_t most =
        std::min<std::uint64_t>(DiagnosticLog::kept, 4 * job_.settings.limits.errors);
    return good && told_.size() + late_.size() <= most;
  }

  bool compile(ClPiece& piece, DiagnosticSink& messages) {
    const Stopwatch watch(job_.seconds.parse);
    frontend::Options options;
    options.dialect = dialect_;
    options.limits = job_.settings.limits;
    options.interrupted = &interrupted_;
    SourceMap& map = texts_.map();
    const std::size_t texts = map.size();
    piece.program = frontend::compile(map, buffer_, options, messages);
    // A piece may look like the text of a CAM system where the beginning of the file does not.
    return standsAlone(piece.program) && map.size() == texts &&
           (piece.program.dialect == frontend::spell(dialect_));
  }

  void evaluate(ClPiece& piece, DiagnosticSink& messages) {
    const Stopwatch watch(job_.seconds.evaluate);
    auto& statements = piece.program.blocks[0].statements;
    runtime::Options options{job_.settings.limits, &interrupted_, {}, false, {}, {}};
    options.carried = &carried_;
    piece.evaluation = runtime::evaluate(piece.program, options, messages);
    for (runtime::Action& action : piece.evaluation.actions) {
      action.isn += isn_;
    }
    const ir::Statement& end = statements.back();
    // The end of a piece has the number of the statement behind it.
    isn_ += static_cast<int>(end.isn) - 1;
    ended_ = end.span.length > 0 && end.span.begin < size_;  // a FINI that was written
    statements_ += statements.size();
    job_.evaluation.steps += piece.evaluation.steps;
    if (!ended_ && !last_) {
      piece.evaluation.actions.pop_back();  // that of the end of the piece
      statements.pop_back();
      --statements_;
      --job_.evaluation.steps;
    }
    good_ = good_ && piece.evaluation.complete && !needsAll(piece.evaluation.actions, dialect_);
  }

  Compilation& job_;
  ClTexts& texts_;
  std::string path_;
  frontend::Dialect dialect_;
  const InterruptFlag& interrupted_;
  ClPieces pieces_;
  runtime::Carried carried_;
  BufferId buffer_;
  std::size_t size_ = 0;  ///< of the piece as it stands in the file
  int isn_ = 0;
  std::vector<Diagnostic> told_;  ///< of Section 1
  bool invisible_ = false;        ///< an invisible character was told
  std::vector<Diagnostic> late_;  ///< of the motion: told behind those of Section 1
  std::vector<runtime::Ignored> ignored_;
  std::size_t statements_ = 0;
  bool last_ = false, ended_ = false, good_ = true;
};

ClReading::ClReading(Compilation& job,
                     ClTexts& texts,
                     const std::string& path,
                     frontend::Dialect dialect,
                     const InterruptFlag& interrupted,
                     const ClStreamRules& rules)
    : reader_(std::make_unique<Reader>(job, texts, path, dialect, interrupted, rules)) {}
ClReading::~ClReading() = default;
bool ClReading::open() {
  return reader_->open();
}
std::unique_ptr<ClPiece> ClReading::read() {
  return reader_->read();
}
bool ClReading::take(const std::vector<Diagnostic>& messages) {
  return reader_->take(messages);
}
bool ClReading::finish() {
  return reader_->finish();
}
std::size_t ClReading::statements() const {
  return reader_->statements();
}

namespace {
/// Sections 2 and 3 of the pieces, each beside the reading of the next one.
class ClMotion {
 public:
  ClMotion(Compilation& job,
           frontend::Dialect dialect,
           ClStreamEnd& end,
           const InterruptFlag& interrupted)
      : job_(job), messages_(end.messages) {
    runtime::Options options{job.settings.limits, &interrupted, {}, false, {}, {}};
    options.axesFollow = dialect == frontend::Dialect::cl;
    options.keepsFacts = false;
    cl::RecordSink* first = &end.records;
    if (options.axesFollow) {
      frames_ = frameStage(job.settings, *first, messages_);
      splines_ = path::makeMovnrbCheck(*frames_, messages_);
      first = splines_.get();
    }
    execution_.emplace(options, *first, messages_);
  }
  ~ClMotion() {
    if (running_.valid()) {
      running_.wait();
    }
  }
  ClMotion(const ClMotion&) = delete;
  ClMotion& operator=(const ClMotion&) = delete;

  void begin(std::unique_ptr<ClPiece> piece) {
    running_ = std::async(std::launch::async, [this, piece = std::move(piece)] {
      const Stopwatch watch(job_.seconds.execute);
      execution_->feed(piece->evaluation.actions);
    });
  }
  /// What the piece in work has told.
  std::vector<Diagnostic> wait() {
    if (running_.valid()) {
      running_.get();
    }
    std::vector<Diagnostic> told = messages_.all();
    messages_.clear();
    return told;
  }
  bool finish() {
    job_.motion = execution_->finish();
    return job_.motion.complete;
  }

 private:
  Compilation& job_;
  CollectingSink& messages_;
  std::unique_ptr<cl::RecordSink> frames_, splines_;
  std::optional<runtime::Execution> execution_;
  std::future<void> running_;
};
}  // namespace

std::optional<frontend::Dialect> streamDialect(const std::string& path,
                                               const Settings& settings,
                                               const ClStreamRules& rules) {
  std::error_code error;
  const bool fits = path != "-" && std::filesystem::is_regular_file(path, error) &&
                    std::filesystem::file_size(path, error) >= rules.smallest &&
                    std::filesystem::file_size(path, error) <= settings.limits.bytes;
  if (!fits || error || !settings.defines.empty()) {
    return std::nullopt;
  }
  std::string begin(beginning, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(in.gcount()));
  if (begin.find('\0') != std::string::npos || begin.starts_with('{')) {
    return std::nullopt;
  }
  const bool named =
      settings.dialect == frontend::Dialect::automatic && frontend::looksLikeCl(begin).has_value();
  return named ? frontend::Dialect::cl : settings.dialect;
}

Streamed streamCl(Compilation& job,
                  const std::string& path,
                  frontend::Dialect dialect,
                  ClStreamEnd& end,
                  const InterruptFlag& interrupted,
                  const ClStreamRules& rules) {
  ClReading reading(job, end.texts, path, dialect, interrupted, rules);
  ClMotion motion(job, dialect, end, interrupted);
  bool more = reading.open();
  while (more) {
    std::unique_ptr<ClPiece> piece = reading.read();
    if (!reading.take(motion.wait()) || piece == nullptr) {
      return Streamed::refused;
    }
    more = reading.open();  // not beside the motion, which may look at texts
    motion.begin(std::move(piece));
  }
  const bool good = reading.take(motion.wait()) && motion.finish() && (!end.close || end.close());
  if (!good || !reading.take(motion.wait()) || !reading.finish()) {
    return Streamed::refused;
  }
  end.statements = reading.statements();
  return Streamed::whole;
}

}  // namespace arelem::app
