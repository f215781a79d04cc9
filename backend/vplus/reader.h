#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "backend/robot/pose.h"
#include "backend/vplus/event.h"
#include "ir/diag/result.h"

namespace arelem::vplus {

/// A move of a program to a place that its text gives.
struct Move {
  robot::Pose pose;  ///< seen from the frame that the program sets first, mm
  std::size_t line = 0;
  bool straight = false;
  double speed = 0.0;  ///< mm/s in force, 0: in percent or none
  double wait = 0.0;   ///< of a DELAY behind it, s
};

/// A switch of outputs: where in the sequence of moves, which, on or off. An output that changes
/// while a move is under way does so as that begins, behind the moves before it.
struct Switched {
  std::size_t afterMoves = 0;
  int output = 0;
  bool on = false;
};

/// What keeps the moves from being known, or takes the tool where no move of the path goes.
struct Stray {
  std::size_t line = 0;
  std::string what;
};

struct ProgramText {
  std::string name;
  /// The location that the program sets first: its coordinates are seen from there.
  Vec3 frameShift = Vec3::Zero();
  robot::Matrix3 frameTurn = robot::Matrix3::Identity();
  /// From the flange to the tool point, where the program sets it; what BASE moves.
  std::optional<Vec3> toolShift;
  robot::Matrix3 toolTurn = robot::Matrix3::Identity();
  std::array<double, 4> base{};  ///< mm, and degrees about z
  std::vector<Stray> strays;
  std::vector<Move> moves;
  std::vector<Switched> signals;
  std::vector<Event> events;      ///< what the program does, in order; RETURN is the last
  std::size_t programs = 1;       ///< of the file
  std::vector<Failure> warnings;  ///< W0631 long lines, W0632 names that are read but never set
  bool straightLine = true;       ///< no IF, FOR, WHILE or CALL: the moves are those of a run
};

/// Whether V+ has this output: 1 to 512, 2001 to 2512 (software), 3001 to 4999.
[[nodiscard]] bool isOutput(double number);

/// Reads a file of V+ programs strictly; moves and signals are those of the first. What the grammar
/// of docs/manual/vplus.md does not have is an error (E0630 with line and column). `tilt` tells how
/// BITS of its output lean the tool; may be null.
[[nodiscard]] Result<ProgramText> readProgram(std::string_view text,
                                              std::string_view file,
                                              const robot::TiltAxis* tilt);

}  // namespace arelem::vplus
