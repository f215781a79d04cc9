#pragma once
#include <span>
#include <string_view>

/// The blocks and the inclusion of later systems, which are no words of the vocabulary: for the
/// manual, `arelem language` and messages.
namespace arelem::frontend {

struct BlockForm {
  std::string_view syntax;
  std::string_view meaning;
};
[[nodiscard]] std::span<const BlockForm> blockForms();
/// The form of DO.
[[nodiscard]] std::string_view doForm();

}  // namespace arelem::frontend
