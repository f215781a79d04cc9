#include "app/verify_vplus.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/verify_hole.h"

#include "backend/robot/pose.h"
#include "backend/text/clean.h"
#include "backend/vplus/reader.h"
#include "ir/diag/render_text.h"
#include "ir/diag/robot.h"
#include "ir/diag/verify.h"
#include "ir/space/robot_tolerance.h"

namespace arelem::app {

namespace {
/// What three decimals, and the steps of a tilt axis, take away: half a digit of each coordinate
/// and angle.
Allowed rounding(const Allowed& given, double millimeters, const robot::Machine& machine) {
  const double step = machine.tilt ? 0.5 * machine.tilt->step : 0.0;
  return {std::max(given.distance, tolerance::writtenDigit / millimeters),
          std::max(given.degrees, 2.0 * tolerance::writtenDigit + 1.001 * step)};
}

double degreesOf(const robot::Matrix3& turn) {
  return Eigen::AngleAxisd(turn).angle() * 180.0 / std::numbers::pi;
}

robot::Matrix3 turnOf(double yaw, double pitch, double roll) {
  return robot::matrixOf({yaw, pitch, roll});
}

/// Whether the program's coordinates lie where the machine file has them, or at the base of the
/// robot, and its tool is that of the machine file.
bool standsAsMachine(const robot::Machine& machine,
                     const vplus::ProgramText& program,
                     const std::string& name,
                     DiagnosticLog& log) {
  constexpr double allowed = 2.0 * tolerance::writtenDigit;  // three numbers
  const robot::Frame& frame = machine.frame;
  const auto& angles = frame.angles;
  const double far = (program.frameShift - frame.shift).norm();
  const double degrees =
      degreesOf(turnOf(angles[0], angles[1], angles[2]).transpose() * program.frameTurn);
  if (far > allowed || degrees > allowed) {
    const Vec3& at = program.frameShift;
    log.accept(fail(diag::VplusFrame, name, far, degrees, at.x(), at.y(), at.z()));
    return false;
  }
  const auto& base = program.base;
  if (std::any_of(base.begin(), base.end(), [](double value) { return value != 0.0; })) {
    log.accept(fail(diag::VplusBase, name, base[0], base[1], base[2], base[3]));
    return false;
  }
  if (!machine.vplus.tool) {
    if (program.toolShift) {
      log.accept(fail(diag::VplusTool, name,
                      std::string("it sets TOOL, the machine file has no tool in [vplus]")));
    }
    return !program.toolShift;
  }
  if (!program.toolShift) {
    log.accept(
        fail(diag::VplusTool, name, std::string("it does not set the TOOL of the machine file")));
    return false;
  }
  const auto& tool = *machine.vplus.tool;
  const double off = (*program.toolShift - Vec3(tool.data())).norm();
  const double turned = degreesOf(turnOf(tool[3], tool[4], tool[5]).transpose() * program.toolTurn);
  if (off > allowed || turned > allowed) {
    log.accept(fail(diag::VplusTool, name,
                    fmt::format("its TOOL lies {:.6g} mm and {:.6g} degrees from that of the "
                                "machine file",
                                off, turned)));
    return false;
  }
  return true;
}

/// The moves in the part unit, with the outputs that are on behind each.
std::vector<Location> locationsOf(const vplus::ProgramText& program, double millimeters) {
  std::vector<Location> all;
  for (const vplus::Move& move : program.moves) {
    all.push_back({move.pose.point / millimeters,
                   move.pose.axis,
                   move.pose.side,
                   nowhere,
                   {},
                   move.speed,
                   move.wait});
  }
  std::set<int> on;
  auto signal = program.signals.begin();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (; signal != program.signals.end() && signal->afterMoves <= i + 1; ++signal) {
      signal->on ? void(on.insert(signal->output)) : void(on.erase(signal->output));
    }
    all[i].on = on;
  }
  return all;
}

/// One location against the moves that are left; how many of them are its own.
std::size_t compared(const Location& wanted,
                     std::span<const Location> found,
                     std::size_t number,
                     const std::string& name,
                     const Allowed& allowed,
                     DiagnosticLog& log) {
  const auto differs = [&](Diagnostic diagnostic) {
    log.accept(std::move(diagnostic));
    return std::size_t{0};
  };
  std::size_t moves = 1;
  if (wanted.hole) {
    const HoleRead hole = readHole(wanted, found, allowed);
    if (!hole.fault.empty()) {
      return differs(diagnose(wanted.origin, diag::HoleDiffers, number, name, hole.fault));
    }
    moves = hole.moves;
  } else {
    if (auto other = difference(wanted, found[0], number, name, allowed)) {
      return differs(*std::move(other));
    }
    const bool told = wanted.speed > 0.0 && number > 1;  // the first is reached by the joints
    if (told && std::abs(found[0].speed - wanted.speed) > tolerance::writtenSpeed) {
      return differs(
          diagnose(wanted.origin, diag::SpeedDiffers, number, name, found[0].speed, wanted.speed));
    }
  }
  const Location& last = found[moves - 1];
  if (std::abs(last.wait - wanted.wait) > tolerance::writtenTime) {
    return differs(
        diagnose(wanted.origin, diag::WaitDiffers, number, name, last.wait, wanted.wait));
  }
  if (last.on != wanted.on) {
    return differs(diagnose(wanted.origin, diag::SwitchDiffers, number, name, listed(last.on),
                            listed(wanted.on)));
  }
  return moves;
}

/// What the program does against what the one does that compile writes.
bool sameEvents(const vplus::ProgramText& program,
                const std::string& rewritten,
                const std::string& name,
                const robot::Machine& machine,
                DiagnosticLog& log) {
  const robot::TiltAxis* tilt = machine.tilt ? &*machine.tilt : nullptr;
  auto wanted = vplus::readProgram(rewritten, name, tilt);
  if (!wanted) {
    log.accept(wanted.takeFailure());
    return false;
  }
  // Both end with RETURN: where one is a part of the other, that differs.
  const std::size_t count = std::min(program.events.size(), wanted->events.size());
  for (std::size_t i = 0; i < count; ++i) {
    const vplus::Event& found = program.events[i];
    if (const auto differs = vplus::difference(found, wanted->events[i])) {
      log.accept(
          diagnose(nowhere, diag::EventDiffers, name, found.line, differs->found, differs->wanted));
      return false;
    }
  }
  if (program.events.size() != wanted->events.size()) {
    const vplus::Event& behind = program.events[std::min(count, program.events.size() - 1)];
    log.accept(
        diagnose(nowhere, diag::EventDiffers, name, behind.line, vplus::shown(behind), "its end"));
    return false;
  }
  if (program.programs > 1) {
    log.accept(diagnose(nowhere, diag::ProgramsDiffer, name, program.programs));
  }
  return program.programs == 1;
}

/// The lines of a text without the ends that differ from machine to machine.
std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    line.remove_suffix(line.ends_with('\r') ? 1 : 0);
    lines.push_back(line);
    begin = end + 1;
  }
  return lines;
}

bool sameLines(std::string_view text,
               const std::string& rewritten,
               const std::string& name,
               DiagnosticLog& log) {
  const std::vector<std::string_view> found = linesOf(text);
  const std::vector<std::string_view> wanted = linesOf(rewritten);
  for (std::size_t i = 0; i < std::max(found.size(), wanted.size()); ++i) {
    const auto shown = [&](const std::vector<std::string_view>& lines) {
      return i < lines.size() ? fmt::format("`{}`", backend::printableAscii(lines[i]))
                              : std::string("the end");
    };
    if (i >= found.size() || i >= wanted.size() || found[i] != wanted[i]) {
      log.accept(diagnose(nowhere, diag::EventDiffers, name, i + 1, shown(found), shown(wanted)));
      return false;
    }
  }
  return true;
}
}  // namespace

std::optional<std::size_t> verifyVplus(std::string_view text,
                                       const std::string& name,
                                       const robot::Machine& machine,
                                       const Path& wanted,
                                       const Rewritten& rewritten,
                                       const Allowed& given,
                                       DiagnosticLog& log) {
  if (machine.vplus.format != robot::VplusStyle::Format::program) {
    return isWritten(rewritten, log) && sameLines(text, rewritten.text(), name, log)
               ? std::optional(wanted.locations.size())
               : std::nullopt;
  }
  auto program = vplus::readProgram(text, name, machine.tilt ? &*machine.tilt : nullptr);
  if (!program) {
    log.accept(program.takeFailure());
    return std::nullopt;
  }
  for (Failure& warning : program->warnings) {
    log.accept(std::move(warning));
  }
  if (!program->straightLine) {
    log.accept(fail(diag::VplusBranches, name));
    return std::nullopt;
  }
  for (const vplus::Stray& stray : program->strays) {
    log.accept(fail(diag::VplusStray, name, stray.line, stray.what));
  }
  if (!program->strays.empty() || !standsAsMachine(machine, *program, name, log)) {
    return std::nullopt;
  }
  const Allowed allowed = rounding(given, wanted.millimeters, machine);
  const std::vector<Location> moves = locationsOf(*program, wanted.millimeters);
  std::span<const Location> left = moves;
  for (std::size_t i = 0; i < wanted.locations.size(); ++i) {
    if (left.empty()) {
      log.accept(diagnose(nowhere, diag::PathLength, name, i, wanted.locations.size()));
      return std::nullopt;
    }
    const std::size_t own = compared(wanted.locations[i], left, i + 1, name, allowed, log);
    if (own == 0) {
      return std::nullopt;
    }
    left = left.subspan(own);
  }
  if (!left.empty()) {
    log.accept(diagnose(nowhere, diag::PathLength, name, wanted.locations.size() + left.size(),
                        wanted.locations.size()));
    return std::nullopt;
  }
  if (!isWritten(rewritten, log) || !sameEvents(*program, rewritten.text(), name, machine, log)) {
    return std::nullopt;
  }
  return wanted.locations.size();
}

}  // namespace arelem::app
