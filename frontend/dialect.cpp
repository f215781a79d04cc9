#include "frontend/dialect.h"

#include <algorithm>
#include <array>
#include <string>

#include "frontend/read/characters.h"

namespace arelem::frontend {

namespace {
using enum Leave;

constexpr std::array names = {"auto", "apt360", "apt4", "cl", "native"};
static_assert(names.size() == dialectCount);

constexpr std::array table = {
#define ARELEM_DIALECT_RULE(member, what, ...) DialectRow{what, {__VA_ARGS__}},
#define ARELEM_CL_MARK(begin, writer)
#include "frontend/dialects.def"
#undef ARELEM_DIALECT_RULE
#undef ARELEM_CL_MARK
};

constexpr std::array marks = {
#define ARELEM_DIALECT_RULE(member, what, ...)
#define ARELEM_CL_MARK(begin, writer) ClMark{begin, writer},
#include "frontend/dialects.def"
#undef ARELEM_DIALECT_RULE
#undef ARELEM_CL_MARK
};

constexpr DialectRules rulesAt(std::size_t dialect) {
  DialectRules rules;
  std::size_t row = 0;
#define ARELEM_DIALECT_RULE(member, what, ...) rules.member = table[row++].leave[dialect];
#define ARELEM_CL_MARK(begin, writer)
#include "frontend/dialects.def"
#undef ARELEM_DIALECT_RULE
#undef ARELEM_CL_MARK
  return rules;
}
constexpr std::array rules = {rulesAt(0), rulesAt(1), rulesAt(2), rulesAt(3), rulesAt(4)};

/// The begin of a line in upper case without blanks, as long as the longest mark needs it.
std::string beginOf(std::string_view line) {
  constexpr std::size_t enough = 16;
  std::string begin;
  for (const char c : line) {
    if (begin.size() == enough) {
      break;
    }
    if (!isBlank(c)) {
      begin += upper(c);
    }
  }
  return begin;
}

/// `name =` or `label) name =` outside comments and texts.
bool isAssignment(std::string_view line, std::string_view begin) {
  for (const std::string_view text : {"$", "PARTNO", "PPRINT", "INSERT", "TITLES", "REMARK"}) {
    if (begin.starts_with(text)) {
      return false;
    }
  }
  const std::size_t equals = line.find('=');
  return equals != std::string_view::npos && equals > 0 && line.find_first_of("/,$'") > equals;
}
}  // namespace

std::string_view spell(Dialect dialect) {
  return names.at(static_cast<std::size_t>(dialect));
}

const DialectRules& rulesOf(Dialect dialect) {
  return rules.at(static_cast<std::size_t>(dialect));
}

std::span<const DialectRow> dialectTable() {
  return table;
}

std::span<const ClMark> clMarks() {
  return marks;
}

std::optional<ClEvidence> looksLikeCl(std::string_view text) {
  constexpr std::size_t most = 65536;  // bytes; a CAM system names itself at the beginning
  std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  while (at < std::min(text.size(), most)) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    const std::string_view line = text.substr(at, end - at);
    const std::string begin = beginOf(line);
    const auto mark = std::find_if(marks.begin(), marks.end(),
                                   [&](const ClMark& m) { return begin.starts_with(m.begin); });
    if (mark != marks.end()) {
      return ClEvidence{at, mark->begin};
    }
    if (isAssignment(line, begin)) {
      return std::nullopt;
    }
    at = end + 1;
  }
  return std::nullopt;
}

}  // namespace arelem::frontend
