#pragma once
#include <optional>
#include <vector>

#include "ir/space/vector.h"

/// Where a tilted tool stands that cuts a wall with its flank (VTLAXS, WCORN of the APT360 manual,
/// 13.4). Checked against the old system's locations; angles in radians, lengths in part units.
namespace arelem::path {

/// The tool of a swarf section.
struct SwarfTool {
  double radius = 0.0;   ///< of its flank
  double corner = 0.0;   ///< radius between flank and bottom
  bool wallLeft = true;  ///< the wall lies on the left of the motion, seen from above
  bool deep = false;     ///< ZSMALL: leaning away from the wall, the edge at the wall stays level
};

struct SwarfPose {
  Vec3 toolEnd = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
};

/// The tilted tool in the place of an upright one at `upright` that moves along the level unit
/// vector `forward`. Its flank lies along the wall, which goes through the line where the upright
/// tool touches it and is tilted as the tool is; its lowest point, or with `deep` the edge at the
/// wall, keeps the height of `upright`. `tilt` is positive to the left of the motion.
[[nodiscard]] SwarfPose swarfPose(const SwarfTool& tool,
                                  const Vec3& upright,
                                  const Vec3& forward,
                                  double tilt);

/// The upright tool in the place of a tilted one: what `swarfPose` was given. `tilt` follows from
/// the axis up to its sign, which `left`, a level unit vector, decides.
[[nodiscard]] Vec3 swarfUpright(const SwarfTool& tool,
                                const SwarfPose& pose,
                                const Vec3& left,
                                double tilt);

/// An inside corner between two walls, at the upright location that touches both.
struct SwarfCorner {
  Vec3 upright = Vec3::Zero();
  Vec3 before = Vec3::UnitX(), after = Vec3::UnitX();  ///< level unit directions of motion
  double tiltBefore = 0.0, tiltAfter = 0.0;            ///< positive to the left
  double height = 0.0;                                 ///< of the walls
  int steps = 6;                                       ///< on each side
};

/// How the tool cleans a corner: on the first wall it turns from its tilt there into the line in
/// which the walls meet, on the second from there into its tilt behind it. Each location has the
/// flank along its own wall and is as near to the other one as the height of the walls allows.
struct SwarfTurn {
  std::vector<SwarfPose> before;  ///< steps + 1 locations
  std::vector<SwarfPose> after;   ///< steps more
};
/// None where the walls meet in no line that the tool can follow (80 degrees from upright or more).
[[nodiscard]] std::optional<SwarfTurn> swarfTurn(const SwarfTool& tool, const SwarfCorner& corner);

/// Largest tilt, degrees.
inline constexpr double steepestSwarf = 80.0;

}  // namespace arelem::path
