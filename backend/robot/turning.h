#pragma once
#include <array>
#include <optional>
#include <vector>

#include "ir/diag/result.h"
#include "ir/space/vector.h"

/// Machines with two turning axes. Lengths in mm, angles in degrees.
namespace arelem::robot {

/// One turning axis. In a table it carries the part and `point` is seen from the zero of the
/// program, in a head it carries the tool and `point` is seen from the tool end, all with both
/// angles 0. The angle is positive when what the axis carries turns with the right hand about
/// `direction`.
struct TurningAxis {
  char letter = 'A';
  Vec3 direction = Vec3::UnitX();
  Vec3 point = Vec3::Zero();
  double low = -99999.0;
  double high = 99999.0;
};

/// Two turning axes: both in the table, both in the head, or one in each. In one chain the first
/// carries the second; of head and table the first is the head's.
struct Turning {
  enum class Kind { tableTable, headHead, headTable };
  Kind kind = Kind::tableTable;
  std::array<TurningAxis, 2> axes;
  /// The control itself keeps the tool end on the path: its words are those of the part program.
  bool toolPoint = false;
  double tolerance = 0.005;      ///< between two locations the tool end keeps to the straight line
  double angleTolerance = 0.05;  ///< and the tool axis to the shortest turn
};

using Angles = std::array<double, 2>;

/// Both solutions for a tool axis, a unit vector seen from the part; one or none where the axes of
/// the machine are not square to each other and do not reach it. An angle that does not matter is
/// taken from `before`. Source: subproblem 2 of Paden and Kahan.
[[nodiscard]] std::vector<Angles> anglesFor(const Turning& turning,
                                            const Vec3& toolAxis,
                                            const Angles& before);

/// The solution next to `before` whose angles are in their ranges, whole turns added or taken away.
/// Errors: no solution (E0677), none in the ranges (E0678).
[[nodiscard]] Result<Angles> nextAngles(const Turning& turning,
                                        const Vec3& toolAxis,
                                        const Angles& before);

/// A pose of the tool seen from the part.
struct ToolPose {
  Vec3 end = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
};
/// Where the linear axes stand (the tool end as it would be with both angles 0), and back.
[[nodiscard]] Vec3 linearAxes(const Turning& turning, const Vec3& toolEnd, const Angles& angles);
[[nodiscard]] ToolPose toolPose(const Turning& turning, const Vec3& linear, const Angles& angles);

}  // namespace arelem::robot
