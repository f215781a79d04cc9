#pragma once
#include <string>
#include <string_view>

/// Text of the part program on its way into an output: what must not get through is replaced here.
namespace arelem::backend {

/// Printable ASCII only: controls (also newlines and ESC) become blanks, each other character one
/// `?`.
[[nodiscard]] std::string printableAscii(std::string_view text);

/// The text of PARTNO, PPRINT or INSERT in CL text, where all to the end of the line is text: letters
/// of any script stay, controls become blanks, bytes that are not UTF-8 `?`, and each `$` at the end,
/// which would join the next line, `#`. No blanks at the end.
[[nodiscard]] std::string restOfLine(std::string_view text);

/// For a statement of CL text: printable ASCII, and `$`, which would continue the line or start a
/// comment, becomes `#`. No blanks at the end.
[[nodiscard]] std::string statementText(std::string_view text);

/// Appends a JSON string with its quotes. Bytes that are not UTF-8 become U+FFFD.
void appendJsonString(std::string& out, std::string_view text);

/// Escapes text for XML content and attributes; controls and bytes that are not UTF-8 become
/// U+FFFD.
[[nodiscard]] std::string xmlText(std::string_view text);

/// Without blanks and NULs at the end.
[[nodiscard]] std::string_view trimmedRight(std::string_view text);
[[nodiscard]] std::string_view trimmed(std::string_view text);

}  // namespace arelem::backend
