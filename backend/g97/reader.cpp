// The strict reader of G97 programs: the grammar of docs/manual/g97.md to the letter.
#include <charconv>
#include <cmath>
#include <set>

#include "backend/g97/block.h"
#include "ir/diag/robot.h"

namespace arelem::g97 {

namespace {
constexpr double farthest = 9999.99;

class Reader {
 public:
  Reader(std::string_view text, const robot::G97Style& style, std::string_view file)
      : text_(text), style_(style), file_(file) {}

  Result<std::vector<Program>> read() {
    while (!failure_ && !text_.empty()) {
      program();
    }
    if (!failure_ && programs_.empty()) {
      wrong("there is no block");
    }
    if (failure_) {
      return *std::move(failure_);
    }
    return std::move(programs_);
  }

 private:
  void wrong(std::string what) {
    if (!failure_) {
      failure_ = fail(diag::G97Syntax, file_, line_, std::move(what));
    }
  }

  bool next() {
    const std::size_t end = text_.find("\r\n");
    ++line_;
    if (end == std::string_view::npos) {
      wrong(text_.empty() ? "the program ends inside a block" : "the line does not end in CR LF");
      return false;
    }
    rest_ = text_.substr(0, end);
    text_.remove_prefix(end + 2);
    return true;
  }

  bool literal(std::string_view wanted) {
    if (rest_.substr(0, wanted.size()) != wanted) {
      wrong(fmt::format("`{}` belongs before `{}`", wanted, rest_.substr(0, 20)));
      return false;
    }
    rest_.remove_prefix(wanted.size());
    return true;
  }
  char oneOf(std::string_view letters) {
    const char found = rest_.empty() ? '\0' : rest_.front();
    if (letters.find(found) == std::string_view::npos || found == '\0') {
      wrong(fmt::format("one of `{}` belongs before `{}`", letters, rest_.substr(0, 20)));
      return '\0';
    }
    rest_.remove_prefix(1);
    return found;
  }
  /// Exactly four digits.
  int four() {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const char digit = oneOf("0123456789");
      value = 10 * value + (digit == '\0' ? 0 : digit - '0');
    }
    return value;
  }
  /// A number with two decimals, no more digits than it needs, never -0.00.
  double number(double low, double high) {
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    double value = 0.0;
    const auto [last, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || last != word.data() + word.size() ||
        fmt::format("{:.2f}", value == 0.0 ? 0.0 : value) != word) {
      wrong(fmt::format("`{}` is no number with two decimals", word));
    } else if (value < low || value > high) {
      wrong(fmt::format("{} is outside {} to {}", word, low, high));
    }
    rest_.remove_prefix(end);
    return value;
  }
  void lineEnd() {
    if (!rest_.empty()) {
      wrong(fmt::format("`{}` belongs to nothing", rest_.substr(0, 20)));
    }
  }

  void program() {
    Program& program = programs_.emplace_back();
    on_.clear();
    if (text_.front() == 'O') {
      if (next() && literal("O")) {
        program.number = four();
        lineEnd();
      }
      if (!failure_ && (program.number == 0 || !numbers_.insert(program.number).second)) {
        wrong(fmt::format("program number {} is 0 or there already", program.number));
      }
    }
    bool last = false;
    while (!failure_ && !last) {
      if (program.blocks.size() == static_cast<std::size_t>(style_.blocks)) {
        wrong(fmt::format("a program has at most {} blocks", style_.blocks));
        return;
      }
      last = block(program);
    }
    if (!failure_ && program.blocks.front().code != style_.s63 && !style_.s63.empty()) {
      wrong(fmt::format("the program does not begin with `{}`", style_.s63));
    }
    if (!failure_ && !on_.empty()) {
      wrong(fmt::format("the program ends with output {} on", *on_.begin()));
    }
  }

  /// True at the program's end.
  bool block(Program& program) {
    Block& b = program.blocks.emplace_back();
    if (!next()) {
      return true;
    }
    b.line = line_;
    literal("N");
    const int number = four();
    if (!failure_ && number != static_cast<int>(program.blocks.size())) {
      wrong(fmt::format("block {} has the number {}", program.blocks.size(), number));
    }
    literal(" ");
    b.straight = oneOf("LP") == 'L';
    literal(" F");
    b.speed = four();
    if (!failure_ && b.speed == 0) {
      wrong("the speed is 0");
    }
    literal(fmt::format("M G97,{},{},{},{},{}", style_.flipped ? 'F' : 'N', style_.back ? 'B' : 'F',
                        style_.turns[0], style_.turns[1], style_.turns[2]));
    lineEnd();
    return !placed(b.pose) || !coded(b);
  }

  bool placed(BlockPose& pose) {
    if (failure_ || !next()) {
      return false;
    }
    for (const auto& [name, i] : {std::pair{"      X ", 0}, {" Y ", 1}, {" Z ", 2}}) {
      literal(name);
      pose.point[i] = number(-farthest, farthest);
    }
    lineEnd();
    if (failure_ || !next()) {
      return false;
    }
    literal("      P ");
    pose.angles.p = number(-179.99, 180.0);
    literal(" Q ");
    pose.angles.q = number(-90.0, 90.0);
    literal(" R ");
    pose.angles.r = number(-179.99, 180.0);
    lineEnd();
    return !failure_;
  }

  /// The line of codes; false at the program's end.
  bool coded(Block& b) {
    if (!next() || !literal("      ")) {
      return false;
    }
    const std::size_t blank = rest_.rfind(' ');
    if (blank != std::string_view::npos) {
      b.code = rest_.substr(0, blank);
      rest_.remove_prefix(blank + 1);
      code(b.code);
    }
    if (rest_ != "BE" && rest_ != "PE") {
      wrong(fmt::format("BE or PE belongs in place of `{}`", rest_.substr(0, 20)));
    }
    return !failure_ && rest_ == "BE";
  }

  void code(const std::string& code) {
    const bool on = code.rfind("RON,", 0) == 0;
    if (!on && code.rfind("ROF,", 0) != 0) {
      if (code != style_.s63 && !isOfWords(code)) {
        wrong(fmt::format("`{}` is no code of the machine file", code));
      }
      return;
    }
    int output = 0;
    const char* end = code.data() + code.size();
    const auto [last, error] = std::from_chars(code.data() + 4, end, output);
    if (error != std::errc() || last != end || output < 1) {
      wrong(fmt::format("`{}` names no output", code));
    } else if (on ? !on_.insert(output).second : on_.erase(output) == 0) {
      wrong(fmt::format("output {} is {} already", output, on ? "on" : "off"));
    }
  }

  /// The codes of the machine file, any number in the place of {1}.
  [[nodiscard]] bool isOfWords(std::string_view code) const {
    for (const auto& [word, pattern] : style_.words) {
      const std::size_t hole = pattern.find("{1}");
      const std::string_view front = std::string_view(pattern).substr(0, hole);
      const std::string_view back =
          hole == std::string::npos ? "" : std::string_view(pattern).substr(hole + 3);
      if (hole == std::string::npos
              ? code == pattern
              : code.size() > front.size() + back.size() && code.substr(0, front.size()) == front &&
                    code.substr(code.size() - back.size()) == back) {
        return true;
      }
    }
    return false;
  }

  std::string_view text_;
  const robot::G97Style& style_;
  std::string_view file_;
  std::string_view rest_;
  std::size_t line_ = 0;
  std::vector<Program> programs_;
  std::set<int> on_, numbers_;
  std::optional<Failure> failure_;
};
}  // namespace

Result<std::vector<Program>> readPrograms(std::string_view text,
                                          const robot::G97Style& style,
                                          std::string_view file) {
  return Reader(text, style, file).read();
}

}  // namespace arelem::g97
