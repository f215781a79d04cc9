#include "backend/g97/divide.h"

#include "ir/diag/robot.h"

namespace arelem::g97 {

namespace {
constexpr std::size_t highestProgram = 9999;  // O and four digits
}  // namespace

Result<std::vector<Program>> divided(std::vector<Step> steps, const robot::G97Style& style) {
  const std::size_t head = style.s63.empty() ? 0 : 1;
  const auto room = static_cast<std::size_t>(style.blocks) - head;
  std::vector<Program> programs;
  std::size_t first = 0;
  while (first < steps.size()) {
    std::size_t end = steps.size();
    if (end - first > room) {
      end = first + room;
      while (end > first && (steps[end].block.straight || steps[end].spraying)) {
        --end;
      }
      if (end == first) {
        std::size_t pass = 1;
        while (first + pass < steps.size() &&
               (steps[first + pass].block.straight || steps[first + pass].spraying)) {
          ++pass;
        }
        return fail(diag::G97LongPass, pass, static_cast<int>(room));
      }
    }
    Program& program = programs.emplace_back();
    const std::size_t number = static_cast<std::size_t>(style.program) + programs.size() - 1;
    if (style.programLine && number > highestProgram) {
      return fail(diag::G97Number, number, highestProgram);
    }
    program.number = style.programLine ? static_cast<int>(number) : 0;
    if (head == 1) {
      Block select = steps[first].block;
      select.straight = false;
      select.code = style.s63;
      program.blocks.push_back(std::move(select));
    }
    for (; first < end; ++first) {
      program.blocks.push_back(std::move(steps[first].block));
    }
  }
  return programs;
}

}  // namespace arelem::g97
