#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace arelem {

enum class Severity : std::uint8_t { note, warning, error };

/// One row of a room's table without its argument types: for lists and `arelem explain`.
struct DiagRow {
  std::string_view name;
  Severity severity;
  std::string_view code;    ///< "E0312"
  std::string_view legacy;  ///< number of the same message in the old system, or empty
  std::string_view text;
};

/// One row of a room's table. The argument types make a wrong report() fail to compile.
/// Each room has a header of its own (ir/diag/motion.h), so that a new row recompiles that room
/// only.
template <class... Args>
struct DiagKind {
  const DiagRow* row;
};

}  // namespace arelem

/// Defines `Name` from a row; a room's header includes its table with ARELEM_DIAG set to this.
#define ARELEM_DIAG_KIND(name, code, severity, legacy, text, ...)                    \
  inline constexpr DiagRow name##Row{#name, Severity::severity, code, legacy, text}; \
  inline constexpr DiagKind<__VA_ARGS__> name{&name##Row};
