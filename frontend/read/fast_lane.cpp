#include "frontend/read/fast_lane.h"

#include <charconv>

#include "frontend/read/characters.h"

namespace arelem::frontend {

namespace {
const char* skipBlanks(const char* p, const char* end) {
  while (p != end && (*p == ' ' || *p == '\t')) {
    ++p;
  }
  return p;
}

/// Matches GOTO or FROM in any case; returns where the text goes on, or nullptr.
const char* matchVerb(const char* p, const char* end, Word& word) {
  if (end - p < 5) {
    return nullptr;
  }
  const char v[4] = {upper(p[0]), upper(p[1]), upper(p[2]), upper(p[3])};
  if (v[0] == 'G' && v[1] == 'O' && v[2] == 'T' && v[3] == 'O') {
    word = Word::GOTO;
  } else if (v[0] == 'F' && v[1] == 'R' && v[2] == 'O' && v[3] == 'M') {
    word = Word::FROM;
  } else {
    return nullptr;
  }
  return p + 4;
}

/// At most 16 significant digits may be written (the 17th is an error of its own), an exponent only
/// after a decimal point: everything else is left to the lexer.
bool isPlainNumber(const char* p, const char* end) {
  int digits = 0;
  bool point = false;
  for (; p != end; ++p) {
    if (isDigit(*p)) {
      ++digits;
    } else if (*p == '.') {
      point = true;
    } else {
      return point && digits > 0 && digits <= 16;
    }
  }
  return digits > 0 && digits <= 16;
}

const char* readNumber(const char* p, const char* end, double& value) {
  const bool plus = *p == '+';
  p += plus ? 1 : 0;
  const char* digits = p + ((!plus && p != end && *p == '-') ? 1 : 0);
  if (digits == end || !(isDigit(*digits) || *digits == '.')) {
    return nullptr;
  }
  const auto [next, error] = std::from_chars(p, end, value);
  if (error != std::errc{} || !isPlainNumber(digits, next)) {
    return nullptr;
  }
  return next;
}
}  // namespace

bool readFastLine(std::string_view line, FastLine& result) {
  const char* const start = line.data();
  const char* const end = start + line.size();
  const char* p = skipBlanks(start, end);
  result.begin = static_cast<std::size_t>(p - start);
  p = matchVerb(p, end, result.numbers.word);
  if (p == nullptr) {
    return false;
  }
  p = skipBlanks(p, end);
  if (p == end || *p != '/') {
    return false;
  }
  std::uint8_t count = 0;
  while (p != end && count < result.numbers.numbers.size()) {
    p = skipBlanks(p + 1, end);
    p = p == end ? nullptr : readNumber(p, end, result.numbers.numbers[count]);
    if (p == nullptr) {
      return false;
    }
    ++count;
    result.end = static_cast<std::size_t>(p - start);
    p = skipBlanks(p, end);
    if (p != end && *p != ',') {
      return false;
    }
  }
  result.numbers.count = count;
  return p == end && count != 1 && count != 5 && count != 8;
}

}  // namespace arelem::frontend
