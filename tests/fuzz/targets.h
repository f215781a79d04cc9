#pragma once
#include <string>

/// What is fuzzed: any bytes must end with diagnostics, never with a crash, a hang or undefined
/// behavior.
namespace arelem::fuzz {

/// Cards, columns, tokens, parser and checks of the frontend. The dialect follows from the length.
void readText(const std::string& text);
/// The same, then Section 1 with small limits.
void wholeProgram(const std::string& text);

}  // namespace arelem::fuzz
