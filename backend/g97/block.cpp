#include "backend/g97/block.h"

#include <cmath>

#include <fmt/format.h>

namespace arelem::backend::g97 {

std::string hundredths(double value) {
  const double rounded = std::round(value * 100.0) / 100.0;
  return fmt::format("{:.2f}", rounded == 0.0 ? 0.0 : rounded);
}

std::string textOf(const Block& b, int number, bool last) {
  const Configuration& c = b.configuration;
  std::string text =
      fmt::format("N{:04} {} F{:04}M G97,{},{},{},{},{}\r\n", number, b.linear ? 'L' : 'P', b.speed,
                  c.wrist, c.arm, c.turns[0], c.turns[1], c.turns[2]);
  text += fmt::format("      X {} Y {} Z {}\r\n", hundredths(b.place.x()), hundredths(b.place.y()),
                      hundredths(b.place.z()));
  text += fmt::format("      P {} Q {} R {}\r\n      ", hundredths(b.angles.p),
                      hundredths(b.angles.q), hundredths(b.angles.r));
  if (b.change) {
    text += fmt::format("{},{} ", b.change->on ? "RON" : "ROF", b.change->output);
  }
  return text + (last ? "PE\r\n" : "BE\r\n");
}

}  // namespace arelem::backend::g97
