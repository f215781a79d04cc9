#include "backend/vplus/reader.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "backend/vplus/expression.h"
#include "backend/vplus/name.h"
#include "ir/diag/robot.h"

namespace arelem::vplus {

namespace {
constexpr std::size_t usualLine = 80;
constexpr std::size_t deepestBlock = 64;

class Reader {
 public:
  Reader(std::string_view text, std::string_view file, const robot::TiltAxis* tilt)
      : text_(text), file_(file), tilt_(tilt) {}

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
      return scope_.wrong("the end of the file");
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
      instruction();
      scope_.end();
    }
  }

  void head() {
    if (!scope_.take(".PROGRAM")) {
      return scope_.wrong(".PROGRAM");
    }
    program_.name = scope_.name("the name of the program");
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
    if (!blocks_.empty()) {
      wrongAt(1, blocks_.back() + " is not closed by END");
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

  void instruction() {
    const std::string word = scope_.word();
    if (word == "MOVE" || word == "MOVES") {
      scope_.next();
      return move(word == "MOVES");
    }
    if (motionWord(word) || settingWord(word) || blockWord(word) || outputWord(word)) {
      return;
    }
    assignment(word);
  }

  void move(bool straight) {
    const Place place = scope_.location();
    if (place.known && !scope_.error()) {
      Move made;
      made.pose = robot::poseOf(place.shift, place.turn);
      lean(made.pose);
      made.line = lineNumber_;
      made.straight = straight;
      made.speed = speed_;
      program_.moves.push_back(made);
    }
  }
  /// The tilt axis leans the tool along its side.
  void lean(robot::Pose& pose) const {
    if (tilt_ == nullptr || tiltDegrees_ == 0.0) {
      return;
    }
    const Vec3 across = pose.axis.cross(*pose.side);
    const Eigen::AngleAxisd turn(tiltDegrees_ * std::numbers::pi / 180.0, across);
    pose.axis = turn * pose.axis;
    pose.side = turn * *pose.side;
  }

  bool motionWord(const std::string& word) {
    if (word == "APPRO" || word == "APPROS") {
      scope_.next();
      scope_.location();
      scope_.sign(",");
      scope_.expression();
    } else if (word == "DEPART" || word == "DEPARTS" || word == "DELAY") {
      scope_.next();
      scope_.expression();
    } else if (word == "BREAK" || word == "RETURN" || word == "PAUSE" || word == "STOP" ||
               word == "LEFTY" || word == "RIGHTY" || word == "ABOVE" || word == "BELOW" ||
               word == "FLIP" || word == "NOFLIP") {
      scope_.next();
    } else {
      return false;
    }
    return true;
  }

  bool settingWord(const std::string& word) {
    if (word == "SPEED") {
      scope_.next();
      setSpeed();
    } else if (word == "ACCEL") {
      scope_.next();
      if (scope_.takeSign("(")) {
        scope_.expression();
        scope_.sign(")");
      }
      scope_.expression();
      scope_.sign(",");
      scope_.expression();
    } else if (word == "DURATION") {
      scope_.next();
      scope_.expression();
      scope_.take("ALWAYS");
    } else if (word == "COARSE" || word == "FINE" || word == "NULL" || word == "NONULL" ||
               word == "CPON" || word == "CPOFF") {
      scope_.next();
      if ((word == "COARSE" || word == "FINE") && !scope_.atEnd() && scope_.word() != "ALWAYS") {
        scope_.expression();
      }
      scope_.take("ALWAYS");
    } else if (word == "TOOL" || word == "BASE") {
      scope_.next();
      if (word == "TOOL" && !scope_.atEnd()) {
        scope_.location();
      } else if (word == "BASE" && !scope_.atEnd()) {
        scope_.list();
      }
    } else if (word == "ENABLE" || word == "DISABLE") {
      scope_.next();
      scope_.anyWord("a switch");
    } else if (word == "PARAMETER") {
      scope_.next();
      scope_.anyWord("a parameter");
      scope_.sign("=");
      scope_.expression();
    } else {
      return false;
    }
    return true;
  }

  void setSpeed() {
    const std::size_t column = scope_.column();
    const std::optional<double> value = scope_.expression();
    if (scope_.takeSign(",")) {
      scope_.expression();
    }
    const bool millimeters = scope_.take("MMPS");
    const bool inches = !millimeters && scope_.take("IPS");
    const bool monitor = !millimeters && !inches && scope_.take("MONITOR");
    scope_.take("ALWAYS");
    if (value && !(*value > 0.0)) {
      return wrongAt(column, fmt::format("the speed is {:g}; it is above 0", *value));
    }
    if (!monitor) {
      constexpr double inch = 25.4;
      speed_ = value && millimeters ? *value : value && inches ? *value * inch : 0.0;
    }
  }

  bool outputWord(const std::string& word) {
    if (word == "SIGNAL") {
      scope_.next();
      do {
        signal();
      } while (!scope_.error() && scope_.takeSign(","));
    } else if (word == "BITS") {
      scope_.next();
      bits();
    } else if (word == "TYPE") {
      scope_.next();
      scope_.items();
    } else {
      return false;
    }
    return true;
  }

  void signal() {
    const std::size_t column = scope_.column();
    const std::optional<double> value = scope_.expression();
    if (!value) {
      return;
    }
    const auto output = static_cast<int>(std::lround(std::abs(*value)));
    const bool exists = (output >= 1 && output <= 512) || (output >= 2001 && output <= 2512) ||
                        (output >= 3001 && output <= 4999);
    if (!exists) {
      return wrongAt(column, fmt::format("there is no output {}; there are 1 to 512, 2001 to 2512 "
                                         "and 3001 to 4999",
                                         output));
    }
    program_.signals.push_back({program_.moves.size(), output, *value > 0.0});
  }

  void bits() {
    const std::optional<double> first = scope_.expression();
    std::optional<double> count = 1.0;
    if (scope_.takeSign(",")) {
      count = scope_.expression();
    }
    scope_.sign("=");
    const std::optional<double> value = scope_.expression();
    constexpr double bitsOfTilt = 8.0;
    if (tilt_ != nullptr && first && value && *first == tilt_->firstOutput && count == bitsOfTilt) {
      tiltDegrees_ = robot::tiltAngle(*tilt_, static_cast<int>(std::lround(*value)));
    }
  }

  bool blockWord(const std::string& word) {
    if (word == "IF" || word == "WHILE") {
      open(word);
      scope_.expression();
      scope_.require(word == "IF" ? "THEN" : "DO");
    } else if (word == "FOR") {
      open(word);
      scope_.setReal(scope_.name("a variable"), std::nullopt);
      scope_.sign("=");
      scope_.expression();
      scope_.require("TO");
      scope_.expression();
      if (scope_.take("STEP")) {
        scope_.expression();
      }
    } else if (word == "ELSE") {
      scope_.next();
      if (blocks_.empty() || blocks_.back() != "IF") {
        wrongAt(1, "ELSE outside IF");
      }
    } else if (word == "END") {
      scope_.next();
      if (blocks_.empty()) {
        return wrongAt(1, "END without IF, FOR or WHILE"), true;
      }
      blocks_.pop_back();
    } else if (word == "CALL") {
      program_.straightLine = false;
      scope_.next();
      scope_.name("the name of a program");
      scope_.sign("(");
      if (!scope_.isSign(")")) {
        scope_.items();
      }
      scope_.sign(")");
    } else {
      return false;
    }
    return true;
  }
  void open(const std::string& word) {
    program_.straightLine = false;
    scope_.next();
    blocks_.push_back(word);
    if (blocks_.size() > deepestBlock) {
      wrongAt(1, fmt::format("more than {} blocks in each other", deepestBlock));
    }
  }

  void assignment(const std::string& word) {
    if (word == "SET") {
      scope_.next();
      const std::string name = scope_.name("the name of a location");
      scope_.sign("=");
      const Place place = scope_.location();
      // The frame that the program sets first carries its coordinates: poses are seen from it.
      const bool first = frames_++ == 0;
      return scope_.setLocation(
          name, first ? Place{Vec3::Zero(), robot::Matrix3::Identity(), true} : place);
    }
    if (word.empty() || isKeyword(word)) {
      return scope_.wrong("an instruction");
    }
    const std::string name = scope_.name("an instruction");
    scope_.sign("=");
    scope_.setReal(name, scope_.expression());
  }

  void reportUnset() {
    for (const std::string& name : scope_.unset()) {
      program_.warnings.push_back(fail(diag::VplusUnset, file_, name));
    }
  }

  std::string_view text_;
  std::string_view file_;
  const robot::TiltAxis* tilt_;
  ProgramText program_;
  Scope scope_;
  std::optional<Failure> failure_;
  std::vector<std::string> blocks_;
  std::size_t lineNumber_ = 0;
  int frames_ = 0;
  double speed_ = 0.0;
  double tiltDegrees_ = 0.0;
  Stage stage_ = Stage::before;
};
}  // namespace

Result<ProgramText> readProgram(std::string_view text,
                                std::string_view file,
                                const robot::TiltAxis* tilt) {
  return Reader(text, file, tilt).run();
}

}  // namespace arelem::vplus
