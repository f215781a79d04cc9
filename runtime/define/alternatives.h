#pragma once
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ir/space/vector.h"
#include "runtime/define/define.h"

/// What else a definition could have meant: its results with other modifiers, or next to other
/// places of a curve.
namespace arelem::define {

struct Alternative {
  /// The parameters (0 based) whose words differ, with the word in their place.
  std::vector<std::pair<std::size_t, Word>> words;
  /// The near point that leads to it, where the form chooses by one; else nothing.
  std::optional<Vec3> near;
  Result<Entity> result;
};

struct Alternatives {
  FormId form = FormId::count;
  Entity chosen;
  /// Each other result once, with the fewest changed words that lead to it; combinations without a
  /// result last, one for each reason.
  std::vector<Alternative> others;
  std::size_t tried = 0;
  bool all = true;  ///< false: there were more than `mostAlternatives` combinations
};

inline constexpr std::size_t mostAlternatives = 512;

/// Computes the definition again with every word in the places where its form has a choice, and
/// with near points along the tabulated cylinder where it has one; the other places of a path
/// spline where the distance to a point has a least value are results too. Fails as the definition
/// itself.
[[nodiscard]] Result<Alternatives> alternatives(EntityType type,
                                                std::span<const Parameter> parameters,
                                                const Context& context);

}  // namespace arelem::define
