#include "backend/vplus/name.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace arelem::vplus {

namespace {
constexpr std::array<std::string_view, 104> keywords = {
    "ABORT",    "ABOVE",   "ACCEL",  "ALIGN",  "ALWAYS",   "AND",   "APPRO",  "APPROS",
    "ATTACH",   "AUTO",    "BASE",   "BELOW",  "BITS",     "BRAKE", "BREAK",  "BY",
    "CALL",     "CASE",    "CLOSE",  "CLOSEI", "COARSE",   "CPOFF", "CPON",   "DELAY",
    "DEPART",   "DEPARTS", "DEST",   "DETACH", "DISABLE",  "DO",    "DOUBLE", "DRIVE",
    "DURATION", "ELSE",    "ENABLE", "END",    "EXECUTE",  "EXIT",  "FALSE",  "FINE",
    "FLIP",     "FOR",     "GLOBAL", "GOTO",   "HALT",     "HERE",  "IF",     "IGNORE",
    "INVERSE",  "IPS",     "KILL",   "LEFTY",  "LOCAL",    "MMPS",  "MOD",    "MONITOR",
    "MOVE",     "MOVES",   "MOVEST", "MOVET",  "MULTIPLE", "NEXT",  "NOFLIP", "NONULL",
    "NOT",      "NULL",    "OFF",    "ON",     "OPEN",     "OPENI", "OR",     "PARAMETER",
    "PAUSE",    "REACT",   "REACTI", "READ",   "READY",    "REAL",  "RESET",  "RETURN",
    "RIGHTY",   "RX",      "RY",     "RZ",     "SELECT",   "SET",   "SHIFT",  "SIGNAL",
    "SINGLE",   "SPEED",   "STEP",   "STOP",   "THEN",     "TIMER", "TO",     "TOOL",
    "TRANS",    "TRUE",    "TYPE",   "UNTIL",  "WAIT",     "WHILE", "WRITE",  "XOR"};

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
