#include "app/verify_g97.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/messages.h"
#include "app/verify_g97_text.h"

#include "backend/g97/block.h"
#include "ir/diag/render_text.h"
#include "ir/diag/verify.h"

namespace arelem::app {

namespace {
/// What two decimals take away: half a digit of three coordinates or angles, and as much again
/// where the machine file has a lever from the taught tool point to the nozzle.
Allowed rounding(const Allowed& given, const robot::Machine& machine, double millimeters) {
  constexpr double digit = 0.01;
  constexpr double radian = 0.0174533;
  const double lever = machine.g97.tool.norm() * digit * radian;
  return {std::max(given.distance, (digit + lever) / millimeters),
          std::max(given.degrees, 1.5 * digit)};
}

struct Found {
  Location location;
  bool straight = false;  ///< L, else P
  int speed = 0;
  bool surplus = false;  ///< may stand for a code alone
};

void switchBy(const std::string& code, std::set<int>& on) {
  const bool rises = code.rfind("RON,", 0) == 0;
  if (!rises && code.rfind("ROF,", 0) != 0) {
    return;
  }
  int output = 0;
  std::from_chars(code.data() + 4, code.data() + code.size(), output);
  rises ? void(on.insert(output)) : void(on.erase(output));
}

bool sameTarget(const g97::Block& a, const g97::Block& b) {
  return a.pose == b.pose && a.speed == b.speed;
}

/// Whether a program begins with a block of its own: a P move to where the program before ended, or
/// to its first location with the code for S63.
bool isLed(const g97::Program& program, const g97::Program* before, const std::string& s63) {
  const std::vector<g97::Block>& blocks = program.blocks;
  if (blocks.size() < 2 || blocks[0].straight || blocks[0].code != s63) {
    return false;
  }
  return (blocks[1].straight && before != nullptr &&
          sameTarget(blocks[0], before->blocks.back())) ||
         (!s63.empty() && sameTarget(blocks[0], blocks[1]));
}

std::vector<Found> locationsOf(const std::vector<g97::Program>& programs,
                               const robot::Machine& machine,
                               double millimeters) {
  std::vector<Found> all;
  std::set<int> on;
  const g97::Program* programBefore = nullptr;
  const g97::Block* before = nullptr;  // codes of one location may be divided too
  for (const g97::Program& program : programs) {
    const bool led = isLed(program, programBefore, machine.g97.s63);
    programBefore = &program;
    for (std::size_t i = led ? 1 : 0; i < program.blocks.size(); ++i) {
      const g97::Block& block = program.blocks[i];
      const robot::Pose pose = g97::poseOf(machine, block.pose);
      const bool repeats = before != nullptr && sameTarget(*before, block) &&
                           before->straight == block.straight && !before->code.empty() &&
                           !block.code.empty();
      before = &block;
      switchBy(block.code, on);
      Found& found = all.emplace_back();
      found.location.point = pose.point / millimeters;
      found.location.axis = pose.axis;
      found.location.side = pose.side;
      found.location.on = on;
      found.straight = block.straight;
      found.speed = block.speed;
      found.surplus = repeats;
    }
  }
  return all;
}

/// How the move to a location differs: L or P, or its speed. The first location is a traverse.
std::optional<Diagnostic> differentWay(const Location& wanted,
                                       const Found& found,
                                       std::size_t number,
                                       const std::string& name,
                                       const robot::Machine& machine) {
  const auto moveName = [](bool straight) {
    return straight ? "straight move (L)" : "move of the joints (P)";
  };
  const bool traverse = wanted.rapid || number == 1;
  if (found.straight == traverse) {
    return diagnose(wanted.origin, diag::MoveDiffers, number, name, moveName(found.straight),
                    moveName(!traverse));
  }
  const double speed = traverse ? machine.rapid : wanted.speed;
  if (std::round(speed) != found.speed) {
    return diagnose(wanted.origin, diag::SpeedDiffers, number, name, double(found.speed), speed);
  }
  return std::nullopt;
}

/// The controller's outputs of the program's.
std::set<int> mapped(const std::set<int>& on, const robot::Machine& machine) {
  std::set<int> result;
  for (const int output : on) {
    const auto place = static_cast<std::size_t>(output) - 1;
    result.insert(place < machine.g97.outputs.size() ? machine.g97.outputs[place] : output);
  }
  return result;
}

/// The axis that the source's formulas give in place of the program's.
Location asWritten(Location location, const robot::Machine& machine) {
  if (machine.g97.robopaint && location.axis) {
    const g97::Angles angles = g97::robopaintAngles(location.axis->normalized());
    location.axis = g97::matrixOf(machine.g97, angles).col(2);
    location.side = std::nullopt;
  }
  return location;
}

/// Location by location, but for what the digits take away. How many there are.
std::optional<std::size_t> agreeing(const std::vector<Found>& found,
                                    const std::string& name,
                                    const robot::Machine& machine,
                                    const Path& wanted,
                                    const Allowed& allowed,
                                    DiagnosticLog& log) {
  std::size_t i = 0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const bool over = i == wanted.locations.size();
    std::optional<Diagnostic> differs =
        over ? diagnose(nowhere, diag::PathLength, name, found.size(), wanted.locations.size())
             : difference(asWritten(wanted.locations[i], machine), found[k].location, i + 1, name,
                          allowed);
    if (!differs) {
      differs = differentWay(wanted.locations[i], found[k], i + 1, name, machine);
    }
    if (differs && !found[k].surplus) {
      log.accept(*std::move(differs));
      return std::nullopt;
    }
    i += differs ? 0 : 1;
    const bool stays = k + 1 < found.size() && found[k + 1].surplus;
    const std::set<int> on = i > 0 ? mapped(wanted.locations[i - 1].on, machine) : std::set<int>{};
    const bool offAtEnd = k + 1 == found.size() && found[k].location.on.empty();
    if (!stays && !offAtEnd && found[k].location.on != on) {
      log.accept(diagnose(i > 0 ? wanted.locations[i - 1].origin : nowhere, diag::SwitchDiffers, i,
                          name, listed(found[k].location.on), listed(on)));
      return std::nullopt;
    }
  }
  if (i < wanted.locations.size()) {
    log.accept(diagnose(nowhere, diag::PathLength, name, i, wanted.locations.size()));
    return std::nullopt;
  }
  return i;
}
}  // namespace

std::optional<std::size_t> verifyG97(std::string_view text,
                                     const std::string& name,
                                     const robot::Machine& machine,
                                     const Path& wanted,
                                     const Rewritten& rewritten,
                                     const Allowed& given,
                                     DiagnosticLog& log) {
  auto programs = g97::readPrograms(text, machine.g97, name);
  if (!programs) {
    log.accept(programs.takeFailure());
    return std::nullopt;
  }
  const auto count = agreeing(locationsOf(*programs, machine, wanted.millimeters), name, machine,
                              wanted, rounding(given, machine, wanted.millimeters), log);
  if (!count || !isWritten(rewritten, log)) {
    return std::nullopt;
  }
  auto again = g97::readPrograms(rewritten.text(), machine.g97, name);
  if (!again) {
    log.accept(again.takeFailure());
    return std::nullopt;
  }
  if (auto differs =
          firstDifference(*programs, *again, name, given.distance * wanted.millimeters)) {
    log.accept(*std::move(differs));
    return std::nullopt;
  }
  return count;
}

}  // namespace arelem::app
