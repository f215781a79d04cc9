#pragma once
#include <span>
#include <string>
#include <string_view>

namespace arelem::app {

/// The candidate that a mistyped `word` most likely means, or "" when none is near: at most a third
/// of its letters wrong (insertions, deletions, replacements, swapped neighbours).
[[nodiscard]] std::string nearest(std::string_view word, std::span<const std::string> candidates);

}  // namespace arelem::app
