#pragma once
#include <map>
#include <string>

#include "backend/ngc/control.h"
#include "backend/text/out_buffer.h"

namespace arelem::backend::ngc {

/// Writes lines of RS-274. Words that keep their value are left out where they are modal.
class BlockWriter {
 public:
  BlockWriter(std::ostream& out, const Control& control) : out_(out), control_(control) {}

  /// Adds a word as it is: "G0", "M3".
  void code(std::string_view word);
  /// Adds a letter with a length of the output unit, an angle, or a plain number.
  void length(char letter, double millimeters);
  void angle(char letter, double value);
  void number(char letter, double value, int decimals);
  /// Adds the code of a modal group unless it is in force.
  void modal(char group, std::string_view word);
  void forget(char group) { modal_.erase(group); }

  /// The same, unless the letter was written with this value before.
  void changedLength(char letter, double millimeters);
  void changedAngle(char letter, double value);
  void forgetAxes() { written_.clear(); }
  /// What a line of the program's own changed is not known.
  void forgetAll() {
    modal_.clear();
    written_.clear();
  }

  /// Whether these words would say nothing new.
  [[nodiscard]] bool holdsLength(char letter, double millimeters) const;
  [[nodiscard]] bool holdsAngle(char letter, double value) const;

  [[nodiscard]] bool empty() const { return line_.empty(); }
  /// Ends the line, if there is anything on it.
  void end();
  /// Lines of their own.
  void comment(std::string_view text);
  void raw(std::string_view text);
  void finish() { out_.finish(); }

  /// The value that the output holds for a length: rounded, mm.
  [[nodiscard]] double rounded(double millimeters) const;
  [[nodiscard]] double resolution() const;

 private:
  [[nodiscard]] double scale() const;
  [[nodiscard]] std::string text(double value, int decimals) const;
  void changed(char letter, std::string value);
  [[nodiscard]] bool holds(char letter, const std::string& value) const;

  OutBuffer out_;
  const Control& control_;
  std::string line_;
  std::map<char, std::string> modal_;
  std::map<char, std::string> written_;
  std::uint64_t lineNumber_ = 0;
};

}  // namespace arelem::backend::ngc
