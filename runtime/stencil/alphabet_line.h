#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/diag/result.h"
#include "runtime/geometry/shapes.h"

namespace arelem::stencil {

/// The words of one line with their columns; `#` begins a comment.
struct LineWords {
  struct Word {
    std::string_view text;
    std::size_t column = 1;
  };
  std::vector<Word> list;
  std::size_t endColumn = 1;
};

/// Reads the words of one line of an alphabet after another. The first failure is kept and ends the
/// reading.
class AlphabetLine {
 protected:
  explicit AlphabetLine(std::string_view file) : file_(file) {}

  /// False for a line without words.
  bool begin(std::string_view line);
  void wrongAt(std::size_t column, std::string_view what);
  /// What stands at the next word is not what is wanted.
  void wrong(std::string_view wanted);
  void tooMany(std::size_t limit, std::string_view what);
  /// A word of the file as a message may show it: printable and short.
  static std::string shown(std::string_view word);

  [[nodiscard]] bool more() const { return next_ < words_.list.size(); }
  bool take(std::string_view word);
  void end();
  /// A number or several with commas between them.
  template <std::size_t count>
  std::array<double, count> numbers(std::string_view wanted) {
    std::array<double, count> values{};
    readNumbers(values, wanted);
    return values;
  }
  geometry::Vec2 point(std::string_view wanted = "a point such as 4,18");
  double positive(std::string_view wanted);
  int wholeNumber(std::string_view wanted, double most);

  static constexpr double smallestGrid = 1e-3;  // grid units
  LineWords words_;
  std::size_t next_ = 0;
  std::size_t lineNumber_ = 0;
  std::optional<Failure> failure_;

 private:
  void readNumbers(std::span<double> values, std::string_view wanted);

  static constexpr double largestNumber = 1000.0;  // grid units
  static constexpr std::size_t longestShown = 24;  // of a wrong word
  std::string file_;
};

}  // namespace arelem::stencil
