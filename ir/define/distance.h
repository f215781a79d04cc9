#pragma once
#include <span>
#include <vector>

#include "ir/define/pattern.h"

/// How far parameters are from a pattern: the cheapest changes that would make them fit.
namespace arelem::define {

/// One change of the parameters.
struct Edit {
  enum class Kind : std::uint8_t { replace, missing, surplus };
  Kind kind = Kind::replace;
  std::size_t position = 0;  ///< 0-based place in the parameters
  Expectation expected;      ///< what belongs there (not of surplus)
};

struct EditPath {
  int cost = 0;             ///< replacing like by like 2, a surplus word 4, other changes 3
  std::vector<Edit> edits;  ///< from left to right; empty: the parameters fit
};

/// The cheapest changes (a shortest path over parameters x nodes). Only the first `editLimit`
/// parameters are looked at, each one beyond costs as one surplus.
[[nodiscard]] EditPath editPath(const Pattern& pattern, std::span<const Symbol> parameters);
inline constexpr std::size_t editLimit = 600;

/// Everything the pattern would accept in place of (or, for a missing parameter, before)
/// `edit.position` so that all the rest fits.
[[nodiscard]] std::vector<Expectation> oneChange(const Pattern& pattern,
                                                 std::span<const Symbol> parameters,
                                                 const Edit& edit);

}  // namespace arelem::define
