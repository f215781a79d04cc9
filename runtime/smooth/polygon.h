#pragma once
#include <span>
#include <string>
#include <vector>

#include "ir/space/vector.h"

/// The control polygon as the source's algorithm sees it: which points move, and whither.
/// Source: Naseath, sections 3.5 and 3.6; spatial as his section 5.1.2 proposes: two points lie on
/// one side of a leg when their distance vectors from its line point into one half space, which in
/// a plane is his test of signs.
namespace arelem::smooth {

enum class Category : char { end = 'E', ripple = 'R', smooth = 'S' };

/// A run of smooth points, first and last included; indices of a closed polygon may pass its end.
struct Group {
  std::size_t first = 0;
  std::size_t last = 0;
  [[nodiscard]] std::size_t size() const { return last - first + 1; }
};

struct Categories {
  std::vector<Category> of;
  std::vector<Group> groups;  ///< of three points or more
  [[nodiscard]] std::string letters() const;
};

[[nodiscard]] Categories categories(std::span<const Vec3> polygon, bool closed);

/// Unit or null direction of each point. `original` is the polygon before the first iteration: ends
/// move across its first and last leg.
[[nodiscard]] std::vector<Vec3> directions(std::span<const Vec3> polygon,
                                           std::span<const Vec3> original,
                                           const Categories& categories,
                                           bool closed);

/// Moves that change the curve equally: d (1/S_i) / max (1/S_j), eqs. 3-42 to 3-46. A sensitivity
/// of 0 counts as 1.
[[nodiscard]] std::vector<double> moves(std::span<const double> sensitivity, double distance);

}  // namespace arelem::smooth
