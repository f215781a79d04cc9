#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "ir/diag/result.h"
#include "ir/limits.h"

namespace arelem::app {

/// Bytes of an input as they are, `-` for standard input. Folders, devices and fifos are refused,
/// sizes bounded by `limits.bytes`.
[[nodiscard]] Result<std::string> readBytes(const std::string& path, const Limits& limits);

/// Why these bytes are no text at all, or nothing. What is wrong with single characters of a text
/// is left to the front end, which knows where they stand.
[[nodiscard]] std::optional<Failure> objectionToText(const std::string& path,
                                                     std::string_view bytes);

/// How an input is called in messages.
[[nodiscard]] std::string displayName(const std::string& path);

}  // namespace arelem::app
