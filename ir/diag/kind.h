#pragma once
#include <cstdint>
#include <string_view>

namespace arelem {

enum class Severity : std::uint8_t { note, warning, error };

/// One row of diagnostics.def. The argument types make a wrong report() fail to compile.
template <class... Args>
struct DiagKind {
  std::uint16_t row;
  Severity severity;
  std::string_view code;    ///< "E0312"
  std::string_view legacy;  ///< number of the same message in the old system, or empty
  std::string_view text;
};

/// A row without its argument types, for tables and `arelem explain`.
struct DiagRow {
  std::string_view name;
  Severity severity;
  std::string_view code;
  std::string_view legacy;
  std::string_view text;
};

namespace diag {
enum class Row : std::uint16_t {
#define ARELEM_DIAG(name, code, severity, legacy, text, ...) name,
#include "ir/diag/diagnostics.def"
#undef ARELEM_DIAG
  count
};
#define ARELEM_DIAG(name, code, severity, legacy, text, ...)                              \
  inline constexpr DiagKind<__VA_ARGS__> name{static_cast<std::uint16_t>(Row::name),      \
                                              Severity::severity, code, legacy, text};
#include "ir/diag/diagnostics.def"
#undef ARELEM_DIAG
}  // namespace diag

}  // namespace arelem
