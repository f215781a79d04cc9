#include "backend/g97/block.h"

namespace arelem::g97 {

std::string textOf(const std::vector<Program>& programs, const robot::G97Style& style) {
  constexpr std::string_view end = "\r\n";
  std::string text;
  for (const Program& program : programs) {
    if (program.number > 0) {
      text += fmt::format("O{:04}{}", program.number, end);
    }
    for (std::size_t i = 0; i < program.blocks.size(); ++i) {
      const Block& b = program.blocks[i];
      text += fmt::format("N{:04} {} F{:04}M G97,{},{},{},{},{}{}", i + 1, b.straight ? 'L' : 'P',
                          b.speed, style.flipped ? 'F' : 'N', style.back ? 'B' : 'F',
                          style.turns[0], style.turns[1], style.turns[2], end);
      text += fmt::format("      X {:.2f} Y {:.2f} Z {:.2f}{}", b.pose.point.x(), b.pose.point.y(),
                          b.pose.point.z(), end);
      text += fmt::format("      P {:.2f} Q {:.2f} R {:.2f}{}", b.pose.angles.p, b.pose.angles.q,
                          b.pose.angles.r, end);
      text += fmt::format("      {}{}{}{}", b.code, b.code.empty() ? "" : " ",
                          i + 1 == program.blocks.size() ? "PE" : "BE", end);
    }
  }
  return text;
}

}  // namespace arelem::g97
