#pragma once
#include <istream>
#include <memory>
#include <string>

#include "ir/diag/result.h"
#include "ir/limits.h"

namespace arelem::app {

/// A file to be read bit by bit; standard input is in memory. Folders, devices and files beyond
/// `limits.bytes` are refused as `readBytes` does.
[[nodiscard]] Result<std::unique_ptr<std::istream>> openBytes(const std::string& path,
                                                              const Limits& limits);

}  // namespace arelem::app
