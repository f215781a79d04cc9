#pragma once
#include <string>
#include <vector>

#include "backend/g97/pose.h"

namespace arelem::g97 {

/// One block: a motion to a pose, then one sequence code.
struct Block {
  bool straight = false;  ///< L, else P
  int speed = 0;          ///< mm/s, four digits
  BlockPose pose;
  std::string code;      ///< "RON,1"; "" for none
  std::size_t line = 0;  ///< where it was read
};

struct Program {
  int number = 0;  ///< of the O line; 0 without
  std::vector<Block> blocks;
};

/// The text of programs one after another, with CR LF. Four lines a block:
///   N0001 L F0100M G97,N,F,0,0,0
///         X 400.00 Y 350.00 Z 200.00
///         P 30.00 Q 25.00 R 0.00
///         RON,1 BE
[[nodiscard]] std::string textOf(const std::vector<Program>& programs,
                                 const robot::G97Style& style);

/// Reads it again, to the letter: exact columns, numbers with two decimals in their ranges, N from
/// 0001 in steps of 1, BE in every block but the last, PE in that, no output switched twice or left
/// on. Error E0645 with the line.
[[nodiscard]] Result<std::vector<Program>> readPrograms(std::string_view text,
                                                        const robot::G97Style& style,
                                                        std::string_view file);

}  // namespace arelem::g97
