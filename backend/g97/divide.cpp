#include "backend/g97/divide.h"

#include "ir/diag/robot.h"

namespace arelem::g97 {

namespace {
constexpr std::size_t highestProgram = 9999;  // O and four digits

/// Behind the blocks from `first` that make a program of at most `most`: at the last traverse, else
/// at the last straight move, that the gun makes switched off. `first` where there is none.
std::size_t endOf(const std::vector<Step>& steps, std::size_t first, std::size_t most) {
  if (steps.size() - first <= most) {
    return steps.size();
  }
  std::size_t anyOff = first;
  for (std::size_t end = first + most; end > first; --end) {
    if (steps[end].spraying) {
      continue;
    }
    if (!steps[end].block.straight) {
      return end;
    }
    anyOff = anyOff == first ? end : anyOff;
  }
  return anyOff;
}

/// The number of blocks before the gun is off again.
std::size_t passAt(const std::vector<Step>& steps, std::size_t first) {
  std::size_t pass = 1;
  while (first + pass < steps.size() && steps[first + pass].spraying) {
    ++pass;
  }
  return pass;
}
}  // namespace

Result<std::vector<Program>> divided(std::vector<Step> steps, const robot::G97Style& style) {
  const auto room = static_cast<std::size_t>(style.blocks);
  std::vector<Program> programs;
  Block last;  // of the program before
  std::size_t first = 0;
  while (first < steps.size()) {
    const bool led = !style.s63.empty() || steps[first].block.straight;
    const std::size_t most = led ? room - 1 : room;
    const std::size_t end = endOf(steps, first, most);
    if (end == first) {
      return fail(diag::G97LongPass, passAt(steps, first), static_cast<int>(most));
    }
    Program& program = programs.emplace_back();
    const std::size_t number = static_cast<std::size_t>(style.program) + programs.size() - 1;
    if (style.programLine && number > highestProgram) {
      return fail(diag::G97Number, number, highestProgram);
    }
    program.number = style.programLine ? static_cast<int>(number) : 0;
    if (led) {
      // Where the program begins in the middle of a path, at its last location: the straight move
      // from there stays one.
      Block& lead = program.blocks.emplace_back(
          steps[first].block.straight && first > 0 ? last : steps[first].block);
      lead.straight = false;
      lead.code = style.s63;
    }
    last = steps[end - 1].block;
    for (; first < end; ++first) {
      program.blocks.push_back(std::move(steps[first].block));
    }
  }
  return programs;
}

}  // namespace arelem::g97
