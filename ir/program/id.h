#pragma once
#include <compare>
#include <cstdint>

namespace arelem::ir {

/// A typed index into one of a Program's tables. Default is "none".
template <class Tag>
struct Id {
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  std::uint32_t index = none;
  auto operator<=>(const Id&) const = default;
  [[nodiscard]] bool valid() const { return index != none; }
};

using SymbolId = Id<struct SymbolTag>;
using ExprId = Id<struct ExprTag>;
using DefinitionId = Id<struct DefinitionTag>;
using BlockId = Id<struct BlockTag>;

}  // namespace arelem::ir
