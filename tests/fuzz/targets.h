#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What is fuzzed: any bytes must end with diagnostics, never with a crash, a hang or undefined
/// behavior.
namespace arelem::fuzz {

struct Target {
  std::string_view name;
  void (*run)(const std::string& bytes);
  /// Suffixes of the files that make the corpus.
  std::vector<std::string_view> suffixes;
  /// The output format into which part programs are compiled to make the corpus; "" for the files
  /// as they are.
  std::string_view compiledTo = "";
};

/// Every reader of the project: part programs and all files that programs and commands name.
[[nodiscard]] std::span<const Target> targets();

/// A part program as an output format of the back end; "" where it has errors.
[[nodiscard]] std::string compiled(const std::string& program, std::string_view format);

}  // namespace arelem::fuzz
