#pragma once
#include <vector>

#include "backend/joints/kinematics.h"

namespace arelem::joints {

/// What the joints do, at an even interval of time.
struct Row {
  double time = 0.0;  ///< s
  State tool;
  JointState joints;
};

struct Table {
  std::vector<Row> rows;
  double interval = 0.0;
  double paintingTime = 0.0;  ///< s with the gun open
};

/// Whether the arm can take the tool along the knots; what hinders it goes to the sink: E0681
/// places outside the reach (how many, the worst and by how much), E0682 a straight move through
/// the axis, E0683 a turn beyond its range, E0666 the fastest move above the largest speed of the
/// tool point (mm/s; 0: any).
[[nodiscard]] bool canFollow(const Arm& arm,
                             const std::vector<Knot>& knots,
                             double mostSpeed,
                             DiagnosticSink& sink);

/// The motion along reachable knots. Speeds and accelerations of joints above their limits are told
/// to the sink, each joint's worst with what slower way would do: E0684, E0685; a table
/// of more than `mostRows` rows: E0686; a gun that is open longer than the program has it: W0684.
inline constexpr double mostRows = 2e6;
[[nodiscard]] Table tableOf(const Arm& arm,
                            const std::vector<Knot>& knots,
                            const robot::Machine& machine,
                            DiagnosticSink& sink);

}  // namespace arelem::joints
