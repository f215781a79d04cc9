#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "backend/robot/machine.h"
#include "backend/robot/pose.h"

namespace arelem::vplus {

/// Numbers as V+ takes them: three decimals, of numbers from 10000 on seven digits; never "-0.000".
[[nodiscard]] std::string numberText(double value);
/// Speeds, mm/s: those below 1 with six decimals, so that they too have three digits.
inline constexpr double slowestSpeed = 1e-3;
[[nodiscard]] std::string speedText(double value);
/// TRANS(x, y, z, yaw, pitch, roll), roll in (-180, 180].
[[nodiscard]] std::string transText(const Vec3& point, const robot::Euler& angles);

/// The instructions of a program that is written, and what stands around them.
class ProgramLines {
 public:
  explicit ProgramLines(const robot::VplusStyle& style) : style_(style) {}

  /// An instruction. Error E0623: V+ has no way to go on with one on a further line.
  [[nodiscard]] std::optional<Failure> add(std::string text);
  /// On as many lines as the columns of the style make of it.
  void comment(std::string text);
  /// The whole program, its coordinates seen from `frame`.
  [[nodiscard]] std::string text(std::string_view name, const robot::Frame& frame) const;

 private:
  const robot::VplusStyle& style_;
  std::vector<std::string> lines_;
};

}  // namespace arelem::vplus
