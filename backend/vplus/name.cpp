#include "backend/vplus/name.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace arelem::vplus {

namespace {
constexpr std::array<std::string_view, 66> keywords = {
    "ABOVE", "ACCEL",     "ALWAYS",  "APPRO",  "APPROS",   "AUTO",   "BASE",    "BELOW",  "BITS",
    "BREAK", "BY",        "CALL",    "COARSE", "CPOFF",    "CPON",   "DELAY",   "DEPART", "DEPARTS",
    "DEST",  "DISABLE",   "DO",      "DOUBLE", "DURATION", "ELSE",   "ENABLE",  "END",    "FINE",
    "FLIP",  "FOR",       "GLOBAL",  "GOTO",   "HERE",     "IF",     "INVERSE", "IPS",    "LEFTY",
    "LOCAL", "MMPS",      "MONITOR", "MOVE",   "MOVES",    "NOFLIP", "NONULL",  "NULL",   "OFF",
    "ON",    "PARAMETER", "PAUSE",   "REAL",   "RETURN",   "RIGHTY", "RX",      "RY",     "RZ",
    "SET",   "SHIFT",     "SIGNAL",  "SPEED",  "STEP",     "STOP",   "THEN",    "TO",     "TOOL",
    "TRANS", "TYPE",      "WHILE"};

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
}  // namespace

std::string programName(std::string_view text) {
  std::string name;
  for (const char c : text) {
    const bool plain = isLetter(c) || isDigit(c);
    if (plain || (!name.empty() && name.back() != '.')) {
      name += plain ? static_cast<char>(std::tolower(static_cast<unsigned char>(c))) : '.';
    }
  }
  if (!name.empty() && !isLetter(name[0])) {
    name.insert(0, "p.");
  }
  name.resize(std::min(name.size(), nameLength));
  while (!name.empty() && name.back() == '.') {
    name.pop_back();
  }
  std::string upper = name;
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  if (isKeyword(upper)) {
    name = "p." + name;
  }
  return name.empty() ? "part" : name;
}

bool isName(std::string_view text) {
  return !text.empty() && isLetter(text[0]) && std::all_of(text.begin(), text.end(), [](char c) {
    return isLetter(c) || isDigit(c) || c == '.' || c == '_';
  });
}

bool isKeyword(std::string_view word) {
  return std::binary_search(keywords.begin(), keywords.end(), word);
}

}  // namespace arelem::vplus
