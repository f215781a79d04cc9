#pragma once
#include <string>
#include <string_view>

#include "frontend/check/reporter.h"

namespace arelem::frontend {

/// Looks once over the bytes of a buffer and reports, with their offset, the first NUL or other
/// control byte, the first byte that is not UTF-8, and the first character that changes the reading
/// direction or has no width. Nothing is changed: bytes that are not UTF-8 are later read as
/// Latin-1 where text is kept.
void checkEncoding(std::string_view text, BufferId buffer, Reporter& reporter);

/// Length in bytes of the UTF-8 character at `at`, or 0 when it is not valid there.
[[nodiscard]] std::size_t utf8Length(std::string_view text, std::size_t at);

/// The text as UTF-8: bytes that are not UTF-8 become the Latin-1 character of the same number,
/// control bytes other than tabs become blanks.
[[nodiscard]] std::string cleanText(std::string_view text);

}  // namespace arelem::frontend
