#pragma once
#include <vector>

#include "runtime/geometry/shapes.h"

namespace arelem::stencil {

using geometry::Vec2;

/// A run in its place in an order, forwards or backwards.
struct Visit {
  std::size_t run = 0;
  Vec2 begin = Vec2::Zero();
  Vec2 end = Vec2::Zero();
  bool backwards = false;

  [[nodiscard]] Visit turned() const { return {run, end, begin, !backwards}; }
};

/// The order, some visits turned round, in which the way between them from `start` is shorter:
/// nearest next, then exchanges until none helps. Never longer than the given order.
[[nodiscard]] std::vector<Visit> shortest(std::vector<Visit> given, const Vec2& start);

}  // namespace arelem::stencil
