#include "backend/ngc/block.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "backend/text/clean.h"
#include "backend/text/number.h"
#include "ir/words/units.h"

namespace arelem::backend::ngc {

namespace {
constexpr std::uint64_t lineStep = 10;
}  // namespace

double BlockWriter::scale() const {
  return control_.inches ? 1.0 / millimetersOfAnInch : 1.0;
}
double BlockWriter::resolution() const {
  return std::pow(10.0, -control_.decimals) / scale();
}
double BlockWriter::rounded(double millimeters) const {
  const double unit = std::pow(10.0, control_.decimals);
  return std::round(millimeters * scale() * unit) / unit / scale();
}

std::string BlockWriter::text(double value, int decimals) const {
  std::array<char, numberRoom> digits{};
  const char* end = writeFixed(digits.data(), value, decimals);
  return {digits.data(), static_cast<std::size_t>(end - digits.data())};
}

void BlockWriter::code(std::string_view word) {
  if (!line_.empty()) {
    line_ += ' ';
  }
  line_ += word;
}
void BlockWriter::number(char letter, double value, int decimals) {
  code(letter + text(value, decimals));
}
void BlockWriter::length(char letter, double millimeters) {
  number(letter, millimeters * scale(), control_.decimals);
}
void BlockWriter::angle(char letter, double value) {
  number(letter, value, control_.angleDecimals);
}
void BlockWriter::modal(char group, std::string_view word) {
  if (modal_[group] != word) {
    modal_[group] = word;
    code(word);
  }
}
void BlockWriter::changed(char letter, std::string value) {
  if (written_[letter] != value) {
    code(letter + value);
    written_[letter] = std::move(value);
  }
}
void BlockWriter::changedLength(char letter, double millimeters) {
  changed(letter, text(millimeters * scale(), control_.decimals));
}
void BlockWriter::changedAngle(char letter, double value) {
  changed(letter, text(value, control_.angleDecimals));
}

bool BlockWriter::holds(char letter, const std::string& value) const {
  const auto found = written_.find(letter);
  return found != written_.end() && found->second == value;
}
bool BlockWriter::holdsLength(char letter, double millimeters) const {
  return holds(letter, text(millimeters * scale(), control_.decimals));
}
bool BlockWriter::holdsAngle(char letter, double value) const {
  return holds(letter, text(value, control_.angleDecimals));
}

void BlockWriter::end() {
  if (line_.empty()) {
    return;
  }
  if (control_.lineNumbers) {
    lineNumber_ += lineStep;
    out_.append(fmt::format("N{} ", lineNumber_));
  }
  raw(line_);
  line_.clear();
}

void BlockWriter::raw(std::string_view text) {
  out_.append(text);
  out_.append('\n');
}

void BlockWriter::comment(std::string_view text) {
  end();
  std::string clean = printableAscii(text);
  for (char& c : clean) {
    c = c == '(' ? '[' : c == ')' ? ']' : c;
  }
  raw("(" + std::string(trimmed(clean)).substr(0, control_.lineLimit - 2) + ")");
}

}  // namespace arelem::backend::ngc
