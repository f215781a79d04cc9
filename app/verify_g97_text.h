#pragma once
#include <optional>
#include <string>
#include <vector>

#include "backend/g97/block.h"
#include "ir/diag/diagnostic.h"

namespace arelem::app {

/// The first word of G97 programs that is not what compile writes: O, X to R, L or P, F, codes,
/// numbers of blocks and programs. X, Y and Z may differ by `millimeters`.
[[nodiscard]] std::optional<Diagnostic> firstDifference(const std::vector<g97::Program>& found,
                                                        const std::vector<g97::Program>& wanted,
                                                        const std::string& name,
                                                        double millimeters);

}  // namespace arelem::app
