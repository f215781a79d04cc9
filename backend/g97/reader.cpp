#include "backend/g97/reader.h"

#include <charconv>
#include <cmath>
#include <map>

#include "ir/diag/g97.h"

namespace arelem::backend::g97 {

namespace {
constexpr double fullRange = 180.0;

class Reader {
 public:
  Reader(std::string_view text, std::string_view name) : text_(text), name_(name) {}

  Result<std::vector<Program>> run() {
    while (!text_.empty()) {
      Program& program = programs_.emplace_back();
      if (text_.starts_with('O')) {
        takeLine();
        program.number = whole("O", 4);
        end();
      }
      bool last = false;
      while (!failure_ && !last) {
        last = block(program);
      }
      checkEnd(program);
      if (failure_) {
        return *std::move(failure_);
      }
    }
    if (programs_.empty()) {
      return fail(diag::G97Syntax, name_, std::size_t{1}, "the file is empty");
    }
    return std::move(programs_);
  }

 private:
  void wrong(std::string what) {
    if (!failure_) {
      failure_ = fail(diag::G97Syntax, name_, lineNumber_, std::move(what));
    }
  }

  void takeLine() {
    ++lineNumber_;
    const std::size_t end = text_.find("\r\n");
    if (end == std::string_view::npos) {
      wrong(text_.empty() ? "the program ends without PE" : "the line does not end with CR LF");
      line_ = {};
      text_ = {};
      return;
    }
    line_ = text_.substr(0, end);
    text_.remove_prefix(end + 2);
  }
  void end() {
    if (!line_.empty()) {
      wrong("`" + std::string(line_.substr(0, 40)) + "` too much");
    }
  }
  void expect(std::string_view wanted) {
    if (!line_.starts_with(wanted)) {
      wrong("`" + std::string(wanted) + "` is missing before `" + std::string(line_.substr(0, 20)) +
            "`");
      return;
    }
    line_.remove_prefix(wanted.size());
  }
  bool accept(std::string_view wanted) {
    if (!line_.starts_with(wanted)) {
      return false;
    }
    line_.remove_prefix(wanted.size());
    return true;
  }
  char oneOf(std::string_view letters) {
    if (line_.empty() || letters.find(line_.front()) == std::string_view::npos) {
      wrong("one of " + std::string(letters) + " is missing");
      return letters.front();
    }
    const char c = line_.front();
    line_.remove_prefix(1);
    return c;
  }
  /// `digits` digits, or as many as there are.
  int whole(std::string_view before, std::size_t digits) {
    expect(before);
    int value = 0;
    const std::string_view span = digits > 0 ? line_.substr(0, digits) : line_;
    const auto [next, error] = std::from_chars(span.data(), span.data() + span.size(), value);
    const auto used = static_cast<std::size_t>(next - span.data());
    if (error != std::errc() || (digits > 0 && used != digits) || span.starts_with('+')) {
      wrong("a whole number is missing behind `" + std::string(before) + "`");
      return 0;
    }
    line_.remove_prefix(used);
    return value;
  }
  /// A number of two decimals between the bounds.
  double number(std::string_view before, double low, double high) {
    expect(before);
    const std::size_t end = std::min(line_.find(' '), line_.size());
    const std::string_view word = line_.substr(0, end);
    double value = 0.0;
    const auto [next, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = error == std::errc() && next == word.data() + word.size();
    if (!whole || word.size() < 4 || word[word.size() - 3] != '.' || word == "-0.00") {
      wrong("`" + std::string(word) + "` is no number of two decimals");
      return 0.0;
    }
    if (!(value >= low && value <= high)) {
      wrong(fmt::format("{} is outside {} to {}", word, low, high));
    }
    line_.remove_prefix(end);
    return value;
  }

  /// True after the last block of the program.
  bool block(Program& program) {
    Block b;
    takeLine();
    const int number = whole("N", 4);
    const int wanted = static_cast<int>(program.blocks.size()) + 1;
    if (number != wanted) {
      wrong(fmt::format("block N{:04} where N{:04} is next", number, wanted));
    }
    expect(" ");
    b.linear = oneOf("LP") == 'L';
    b.speed = whole(" F", 4);
    if (b.speed < 1) {
      wrong("the speed is 0");
    }
    expect("M G97,");
    b.configuration.wrist = oneOf("NF");
    expect(",");
    b.configuration.arm = oneOf("FB");
    for (int& turns : b.configuration.turns) {
      turns = whole(",", 0);
      if (std::abs(turns) > 1) {
        wrong(fmt::format("{} turns; -1, 0 and 1 are possible", turns));
      }
    }
    end();
    takeLine();
    b.place.x() = number("      X ", -largestPlace, largestPlace);
    b.place.y() = number(" Y ", -largestPlace, largestPlace);
    b.place.z() = number(" Z ", -largestPlace, largestPlace);
    end();
    takeLine();
    b.angles.p = number("      P ", -fullRange, fullRange);
    b.angles.q = number(" Q ", -fullRange, fullRange);
    b.angles.r = number(" R ", -fullRange, fullRange);
    end();
    takeLine();
    expect("      ");
    if (line_.starts_with("R")) {
      const bool on = accept("RON,");
      b.change = Block::Switch{whole(on ? "" : "ROF,", 0), on};
      expect(" ");
    }
    const bool last = accept("PE");
    if (!last) {
      expect("BE");
    }
    end();
    if (!program.blocks.empty() && !(program.blocks.front().configuration == b.configuration)) {
      wrong("the configuration changes: the hand would swing round");
    }
    program.blocks.push_back(b);
    return last;
  }

  void checkEnd(const Program& program) {
    std::map<int, bool> outputs;
    for (const Block& b : program.blocks) {
      if (b.change) {
        outputs[b.change->output] = b.change->on;
      }
    }
    for (const auto& [output, on] : outputs) {
      if (on) {
        wrong(fmt::format("output {} is still on at the end of the program", output));
      }
    }
  }

  std::string_view text_;
  std::string_view name_;
  std::string_view line_;
  std::size_t lineNumber_ = 0;
  std::vector<Program> programs_;
  std::optional<Failure> failure_;
};
}  // namespace

bool looksLikeProgram(std::string_view text) {
  const auto digits = [&text](std::size_t from) {
    return text.size() >= from + 4 &&
           text.substr(from, 4).find_first_not_of("0123456789") == std::string_view::npos;
  };
  return (text.starts_with('O') && digits(1) && text.substr(5).starts_with("\r\n")) ||
         text.starts_with("N0001 L F") || text.starts_with("N0001 P F");
}

Result<std::vector<Program>> readPrograms(std::string_view text, std::string_view name) {
  return Reader(text, name).run();
}

}  // namespace arelem::backend::g97
