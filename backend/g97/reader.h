#pragma once
#include <string_view>
#include <vector>

#include "backend/g97/block.h"
#include "ir/diag/result.h"

namespace arelem::backend::g97 {

/// One program of a file.
struct Program {
  int number = 0;  ///< behind O; 0 where the file has none
  std::vector<Block> blocks;
};

/// Whether a text begins as a G97 program does: O and four digits, or block N0001.
[[nodiscard]] bool looksLikeProgram(std::string_view text);

/// Reads programs strictly: every column as the writer makes it, blocks counted from 1, one PE at
/// the end of each program, outputs off there, numbers inside their ranges. It shares nothing with
/// the writer but the Block. Errors: E0740 with the line.
[[nodiscard]] Result<std::vector<Program>> readPrograms(std::string_view text,
                                                        std::string_view name);

}  // namespace arelem::backend::g97
