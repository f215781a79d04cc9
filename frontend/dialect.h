#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

/// Dialects of the language: one table says what differs (dialects.def).
namespace arelem::frontend {

enum class Dialect : std::uint8_t {
  automatic,  ///< cl if the text looks like it, else native with what legacy programs need
  apt360,     ///< strict: six-character names, no extension words
  apt4,
  cl,  ///< CL text of CAM systems: free width, unknown words pass
  native
};
inline constexpr std::size_t dialectCount = 5;

[[nodiscard]] std::string_view spell(Dialect dialect);  ///< "auto", "apt360", ...

/// What becomes of something that not every dialect has.
enum class Leave : std::uint8_t { refused, warned, taken };

/// The rules of one dialect: a member a row of dialects.def.
struct DialectRules {
#define ARELEM_DIALECT_RULE(member, what, ...) Leave member = Leave::refused;
#define ARELEM_CL_MARK(begin, writer)
#include "frontend/dialects.def"
#undef ARELEM_DIALECT_RULE
#undef ARELEM_CL_MARK
};
[[nodiscard]] const DialectRules& rulesOf(Dialect dialect);

/// A row of the table, for the manual.
struct DialectRow {
  std::string_view what;
  Leave leave[dialectCount];  ///< by dialect
};
[[nodiscard]] std::span<const DialectRow> dialectTable();

/// A line that tells CL text of a CAM system, for the manual.
struct ClMark {
  std::string_view begin;   ///< of a line, in upper case without blanks
  std::string_view writer;  ///< "NX"
};
[[nodiscard]] std::span<const ClMark> clMarks();

/// Why a text is taken for CL text.
struct ClEvidence {
  std::size_t offset = 0;  ///< of the line
  std::string_view mark;   ///< its begin, as in the table
};

/// Looks at the first lines of a text. CL text has a line of the table and no statement `name =`
/// before it. Time: linear in what is looked at, at most 64 kB.
[[nodiscard]] std::optional<ClEvidence> looksLikeCl(std::string_view text);

}  // namespace arelem::frontend
