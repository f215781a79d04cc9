#pragma once
#include <string>
#include <vector>

#include "ir/diag/result.h"
#include "ir/limits.h"

namespace arelem::app {

/// Bytes of an input as they are, `-` for standard input. Folders, devices and fifos are refused,
/// sizes bounded by `limits.bytes`.
[[nodiscard]] Result<std::string> readBytes(const std::string& path, const Limits& limits);

/// A part program made ready for the front end: valid UTF-8 without byte order mark.
struct SourceText {
  std::string text;
  std::vector<Failure> warnings;
};

/// Checks the encoding of `bytes`. Anything that is neither UTF-8 nor Windows-1252 text is refused
/// with the first bad byte. `name` is used in messages only.
[[nodiscard]] Result<SourceText> decodeSource(const std::string& name, std::string bytes);

/// How an input is called in messages.
[[nodiscard]] std::string displayName(const std::string& path);

}  // namespace arelem::app
