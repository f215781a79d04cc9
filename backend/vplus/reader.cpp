#include "backend/vplus/reader.h"

#include <algorithm>
#include <optional>
#include <set>

#include "backend/vplus/instruction.h"
#include "backend/vplus/name.h"
#include "ir/diag/robot.h"

namespace arelem::vplus {

namespace {
constexpr std::size_t usualLine = 80;

class Reader {
 public:
  Reader(std::string_view text, std::string_view file, const robot::TiltAxis* tilt)
      : text_(text), file_(file), tilt_(tilt) {
    instructions_.emplace(scope_, program_, tilt);
  }

  Result<ProgramText> run() {
    std::size_t begin = 0;
    while (begin < text_.size() && !failed()) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      std::string_view line = text_.substr(begin, end - begin);
      if (line.ends_with('\r')) {
        line.remove_suffix(1);
      }
      ++lineNumber_;
      oneLine(line);
      begin = end + 1;
    }
    if (!failed() && stage_ != Stage::done) {
      ++lineNumber_;
      wrongAt(1, stage_ == Stage::before ? "there is no .PROGRAM" : "the program has no .END");
    }
    if (failed()) {
      return *std::move(failure_);
    }
    reportUnset();
    if (first_) {
      first_->warnings.insert(first_->warnings.end(), program_.warnings.begin(),
                              program_.warnings.end());
      return *std::move(first_);
    }
    return std::move(program_);
  }

 private:
  enum class Stage : std::uint8_t { before, declarations, statements, done };

  [[nodiscard]] bool failed() const { return failure_.has_value(); }
  void wrongAt(std::size_t column, std::string_view what) {
    if (!failed()) {
      failure_ = fail(diag::VplusSyntax, file_, lineNumber_, column, what);
    }
  }

  void oneLine(std::string_view line) {
    if (stage_ == Stage::done && line.find_first_not_of(" \t\f\x1a") == std::string_view::npos) {
      return;
    }
    for (std::size_t i = 0; i < line.size(); ++i) {
      const auto c = static_cast<unsigned char>(line[i]);
      if (c > 126 || (c < 32 && c != '\t')) {
        return wrongAt(i + 1, "a character that is not printable ASCII");
      }
    }
    if (line.size() > longestLine) {
      return wrongAt(longestLine + 1, fmt::format("the line has {} columns; {} is the most",
                                                  line.size(), longestLine));
    }
    if (line.size() > usualLine) {
      program_.warnings.push_back(
          fail(diag::VplusLongLine, file_, lineNumber_, line.size(), usualLine));
    }
    scope_.begin(tokensOf(line));
    if (!scope_.atEnd()) {
      statement();
    }
    if (scope_.error()) {
      wrongAt(scope_.error()->column, scope_.error()->what);
    }
  }

  void statement() {
    if (stage_ == Stage::before) {
      return head();
    }
    if (stage_ == Stage::done) {
      if (scope_.word() != ".PROGRAM") {
        return scope_.wrong(".PROGRAM or the end of the file");
      }
      return another();
    }
    if (scope_.take(".END")) {
      return end();
    }
    for (const char* word : {"AUTO", "LOCAL", "GLOBAL"}) {
      if (scope_.take(word)) {
        return declaration();
      }
    }
    stage_ = Stage::statements;
    scope_.label();
    if (!scope_.atEnd()) {
      instructions_->one(lineNumber_);
      scope_.end();
    }
  }

  /// A further program has names of its own; the moves are those of the first.
  void another() {
    reportUnset();
    if (!first_) {
      first_ = std::move(program_);
    } else {
      first_->warnings.insert(first_->warnings.end(), program_.warnings.begin(),
                              program_.warnings.end());
    }
    ++first_->programs;
    program_ = {};
    scope_.forget();
    instructions_.emplace(scope_, program_, tilt_);
    stage_ = Stage::before;
    head();
  }

  void head() {
    if (!scope_.take(".PROGRAM")) {
      return scope_.wrong(".PROGRAM");
    }
    const std::size_t column = scope_.column();
    program_.name = scope_.name("the name of the program");
    if (!scope_.error() && !names_.insert(program_.name).second) {
      return scope_.wrongAt(column, "a program `" + program_.name + "` stands above");
    }
    scope_.sign("(");
    while (!scope_.error() && !scope_.isSign(")")) {
      scope_.declare(scope_.name("a parameter"));
      if (!scope_.isSign(")")) {
        scope_.sign(",");
      }
    }
    scope_.sign(")");
    scope_.end();
    stage_ = Stage::declarations;
  }

  void end() {
    scope_.end();
    instructions_->finish();
    if (!instructions_->openBlocks().empty()) {
      wrongAt(1, instructions_->openBlocks().back() + " is not closed by END");
    }
    stage_ = Stage::done;
  }

  void declaration() {
    if (stage_ != Stage::declarations) {
      return wrongAt(1, "declarations stand before the first instruction");
    }
    scope_.take("REAL") || scope_.take("DOUBLE");
    do {
      scope_.declare(scope_.name("a name"));
    } while (!scope_.error() && scope_.takeSign(","));
    scope_.end();
  }

  void reportUnset() {
    for (const std::string& name : scope_.unset()) {
      program_.warnings.push_back(fail(diag::VplusUnset, file_, name));
    }
  }

  std::string_view text_;
  std::string_view file_;
  ProgramText program_;
  Scope scope_;
  const robot::TiltAxis* tilt_;
  std::optional<Instructions> instructions_;
  std::set<std::string> names_;       // of the programs
  std::optional<ProgramText> first_;  // of several programs
  std::optional<Failure> failure_;
  std::size_t lineNumber_ = 0;
  Stage stage_ = Stage::before;
};
}  // namespace

Result<ProgramText> readProgram(std::string_view text,
                                std::string_view file,
                                const robot::TiltAxis* tilt) {
  return Reader(text, file, tilt).run();
}

}  // namespace arelem::vplus
