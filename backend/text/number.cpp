#include "backend/text/number.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace arelem::backend {

namespace {
constexpr std::array<double, maxDecimals + 1> powersOfTen = {
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

/// Largest whole number up to which the fast path works: every such double is exact.
constexpr double exactWhole = 9007199254740992.0;
/// How near to a tie of rounding the scaled value may be for the fast path: its own rounding error
/// is smaller.
constexpr double tieMargin = 0.01;

/// Writes `whole` / 10^decimals by integer arithmetic.
char* writeScaled(char* first, std::uint64_t whole, int decimals) {
  std::array<char, 24> digits{};
  int count = 0;
  while (whole != 0 || count <= decimals) {
    digits[static_cast<std::size_t>(count++)] = static_cast<char>('0' + whole % 10);
    whole /= 10;
  }
  while (count > 0) {
    if (count == decimals) {
      *first++ = '.';
    }
    *first++ = digits[static_cast<std::size_t>(--count)];
  }
  return first;
}

/// Removes a sign before nothing but zeros.
char* dropNegativeZero(char* first, char* last) {
  if (*first != '-') {
    return last;
  }
  for (const char* p = first + 1; p != last; ++p) {
    if (*p != '0' && *p != '.') {
      return last;
    }
  }
  std::memmove(first, first + 1, static_cast<std::size_t>(last - first - 1));
  return last - 1;
}

char* writeDecimals(char* first, double value, int decimals) {
  const double scaled = std::abs(value) * powersOfTen[static_cast<std::size_t>(decimals)];
  const double whole = std::nearbyint(scaled);
  const bool tie = std::abs(std::abs(scaled - whole) - 0.5) < tieMargin;
  if (scaled < exactWhole / 128 && !tie) {  // seven bits of fraction: error 0.008 at most
    if (value < 0.0 && whole > 0.0) {
      *first++ = '-';
    }
    return writeScaled(first, static_cast<std::uint64_t>(whole), decimals);
  }
  char* last =
      std::to_chars(first, first + numberRoom, value, std::chars_format::fixed, decimals).ptr;
  return dropNegativeZero(first, last);
}
}  // namespace

bool isWritable(double value) {
  return std::abs(value) <= textNumberLimit;
}

char* writeFixed(char* first, double value, int decimals) {
  if (decimals > 0) {
    return writeDecimals(first, value, decimals < maxDecimals ? decimals : maxDecimals);
  }
  char* last = writeParameter(first, value, shortest);
  for (const char* p = first; p != last; ++p) {
    if (*p == '.') {
      return last;
    }
  }
  *last++ = '.';
  *last++ = '0';
  return last;
}

char* writeParameter(char* first, double value, int decimals) {
  if (std::abs(value) < textNumberFloor) {
    *first = '0';
    return first + 1;
  }
  if (decimals > 0 && value != std::trunc(value)) {
    return writeFixed(first, value, decimals);
  }
  return std::to_chars(first, first + numberRoom, value, std::chars_format::fixed).ptr;
}

void appendJsonNumber(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  std::array<char, 32> text{};
  const char* last =
      std::to_chars(text.data(), text.data() + text.size(), value == 0.0 ? 0.0 : value).ptr;
  const std::string_view digits(text.data(), static_cast<std::size_t>(last - text.data()));
  out += digits;
  if (digits.find_first_of(".e") == std::string_view::npos) {
    out += ".0";
  }
}

}  // namespace arelem::backend
