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

/// Matches GOTO, FROM or GODLTA in any case; returns where the text goes on, or nullptr.
const char* matchVerb(const char* p, const char* end, Word& word) {
  if (end - p < 5) {
    return nullptr;
  }
  const char v[4] = {upper(p[0]), upper(p[1]), upper(p[2]), upper(p[3])};
  if (v[0] == 'G' && v[1] == 'O' && v[2] == 'T' && v[3] == 'O') {
    word = Word::GOTO;
  } else if (v[0] == 'F' && v[1] == 'R' && v[2] == 'O' && v[3] == 'M') {
    word = Word::FROM;
  } else if (v[0] == 'G' && v[1] == 'O' && v[2] == 'D' && v[3] == 'L' && end - p > 6 &&
             upper(p[4]) == 'T' && upper(p[5]) == 'A') {
    word = Word::GODLTA;
    return p + 6;
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
/// Whether a word may have so many numbers in this lane.
bool fits(const ir::LocateNumbers& numbers) {
  const auto n = numbers.count;
  return numbers.word == Word::GODLTA ? n == 3 : n > 1 && n != 5 && n != 8;
}

/// Behind the numbers of a line: nothing, a comment, or `$`, with which it goes on.
FastLane readEnd(const char* p, const char* end, FastLine& result) {
  if (p == end) {
    return FastLane::whole;
  }
  if (*p != '$') {
    return FastLane::none;
  }
  if (p + 1 != end && p[1] == '$') {
    result.comment = true;
    return FastLane::whole;
  }
  return skipBlanks(p + 1, end) == end ? FastLane::open : FastLane::none;
}

/// Numbers and commas from here to the end of the line.
FastLane readList(const char* start, const char* p, const char* end, FastLine& result) {
  ir::LocateNumbers& numbers = result.numbers;
  while (true) {
    p = skipBlanks(p, end);
    if (p == end || *p == '$') {
      const FastLane ending = readEnd(p, end, result);
      const bool good = ending == FastLane::open || (!result.wantsNumber && fits(numbers));
      return good ? ending : FastLane::none;
    }
    if (!result.wantsNumber) {
      if (*p++ != ',') {
        return FastLane::none;
      }
    } else {
      p = numbers.count == numbers.numbers.size()
              ? nullptr
              : readNumber(p, end, numbers.numbers[numbers.count]);
      if (p == nullptr) {
        return FastLane::none;
      }
      ++numbers.count;
      result.end = static_cast<std::size_t>(p - start);
    }
    result.wantsNumber = !result.wantsNumber;
  }
}
}  // namespace

FastLane readFastLine(std::string_view line, FastLine& result) {
  const char* const start = line.data();
  const char* const end = start + line.size();
  const char* p = skipBlanks(start, end);
  result.begin = static_cast<std::size_t>(p - start);
  result.numbers.count = 0;
  p = matchVerb(p, end, result.numbers.word);
  if (p == nullptr) {
    return FastLane::none;
  }
  p = skipBlanks(p, end);
  if (p == end || *p != '/') {
    return FastLane::none;
  }
  result.comment = false;
  result.wantsNumber = true;
  return readList(start, p + 1, end, result);
}

FastLane appendFastLine(std::string_view line, FastLine& result) {
  return readList(line.data(), line.data(), line.data() + line.size(), result);
}

}  // namespace arelem::frontend
