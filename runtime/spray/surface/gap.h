#pragma once
#include <optional>
#include <utility>
#include <vector>

namespace arelem::spray {

/// The middle of the widest part of a circle (degrees) that no arc covers; none where they cover
/// all of it, to a quarter of a degree. An arc runs the short way from its first angle to its
/// second.
[[nodiscard]] std::optional<double> middleOfGap(const std::vector<std::pair<double, double>>& arcs);

}  // namespace arelem::spray
