#pragma once
#include <array>
#include <optional>
#include <string>

#include "backend/g97/angles.h"

namespace arelem::backend::g97 {

/// What stands in every block behind G97: wrist N or F, arm F or B, the turns of three angles.
struct Configuration {
  char wrist = 'N';
  char arm = 'F';
  std::array<int, 3> turns{};
  bool operator==(const Configuration&) const = default;
};

/// One block of a program: where the robot goes, how, and what it switches there.
struct Block {
  bool linear = true;  ///< L, else P
  int speed = 0;       ///< mm/s, 1 to 9999
  Configuration configuration;
  Vec3 place = Vec3::Zero();  ///< mm
  Angles angles;
  struct Switch {
    int output = 1;
    bool on = true;
    bool operator==(const Switch&) const = default;
  };
  std::optional<Switch> change;
};

inline constexpr int mostBlocks = 9999;
inline constexpr double largestPlace = 9999.99;

/// The four lines of a block, each ended by CR LF. `number` from 1; the last block of a program
/// ends it.
[[nodiscard]] std::string textOf(const Block& block, int number, bool last);
/// Two decimals, never "-0.00".
[[nodiscard]] std::string hundredths(double value);

}  // namespace arelem::backend::g97
