#include "runtime/stencil/alphabet_line.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "ir/diag/stencil.h"

namespace arelem::stencil {

bool AlphabetLine::begin(std::string_view line) {
  words_ = {};
  next_ = 0;
  std::size_t i = 0;
  while (i < line.size() && line[i] != '#') {
    if (line[i] == ' ' || line[i] == '\t' || line[i] == '\r') {
      ++i;
      continue;
    }
    const std::size_t end = std::min(line.find_first_of(" \t\r", i), line.size());
    words_.list.push_back({line.substr(i, end - i), i + 1});
    i = end;
  }
  words_.endColumn = i + 1;
  return !words_.list.empty();
}

void AlphabetLine::wrongAt(std::size_t column, std::string_view what) {
  if (!failure_) {
    failure_ =
        fail(diag::AlphabetSyntax, file_, std::max<std::size_t>(lineNumber_, 1), column, what);
  }
}

void AlphabetLine::wrong(std::string_view wanted) {
  const std::size_t column = more() ? words_.list[next_].column : words_.endColumn;
  const std::string found =
      more() ? "`" + shown(words_.list[next_].text) + "`" : std::string("the end of the line");
  wrongAt(column, found + " stands where " + std::string(wanted) + " is expected");
}

void AlphabetLine::tooMany(std::size_t limit, std::string_view what) {
  if (!failure_) {
    failure_ = fail(diag::AlphabetSize, file_, lineNumber_, limit, what);
  }
}

std::string AlphabetLine::shown(std::string_view word) {
  std::string clean;
  for (const char c : word.substr(0, longestShown)) {
    clean += c > ' ' && c < '\x7f' ? c : '?';
  }
  return word.size() > longestShown ? clean + "..." : clean;
}

bool AlphabetLine::take(std::string_view word) {
  if (more() && words_.list[next_].text == word) {
    ++next_;
    return true;
  }
  return false;
}

void AlphabetLine::end() {
  if (!failure_ && more()) {
    wrong("the end of the line");
  }
}

void AlphabetLine::readNumbers(std::span<double> values, std::string_view wanted) {
  if (!more()) {
    wrong(wanted);
    return;
  }
  const std::string_view text = words_.list[next_].text;
  const char* p = text.data();
  const char* const last = p + text.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto [after, error] = std::from_chars(p, last, values[i]);
    const bool good = error == std::errc{} && std::isfinite(values[i]) &&
                      std::abs(values[i]) <= largestNumber &&
                      (i + 1 == values.size() ? after == last : after != last && *after == ',');
    if (!good) {
      std::fill(values.begin(), values.end(), 0.0);
      wrong(wanted);
      return;
    }
    p = after + 1;
  }
  ++next_;
}

geometry::Vec2 AlphabetLine::point(std::string_view wanted) {
  const auto p = numbers<2>(wanted);
  return {p[0], p[1]};
}

double AlphabetLine::positive(std::string_view wanted) {
  const std::size_t at = next_;
  const double value = numbers<1>(wanted)[0];
  if (!failure_ && value < smallestGrid) {
    next_ = at;
    wrong(wanted);
  }
  return value;
}

int AlphabetLine::wholeNumber(std::string_view wanted, double most) {
  const std::size_t at = next_;
  const double value = numbers<1>(wanted)[0];
  if (!failure_ && (value < 1.0 || value > most || value != std::floor(value))) {
    next_ = at;
    wrong(wanted);
  }
  return failure_ ? 1 : static_cast<int>(value);
}

}  // namespace arelem::stencil
