#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ir/space/vector.h"
#include "ir/text/span.h"
#include "runtime/spray/gun.h"
#include "runtime/spray/gun_pose.h"
#include "runtime/spray/inset.h"
#include "runtime/spray/overlap.h"
#include "runtime/spray/search.h"

namespace arelem::spray {

struct Patch;
class MeshSurface;

/// Where the spray falls while the gun moves straight from one place to the next. Places lie on the
/// work, mm; normals point to the gun.
struct Stroke {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  Vec3 normalFrom = Vec3::UnitZ(), normalTo = Vec3::UnitZ();
  double speed = 0.0;  ///< mm/s on the work
  bool painting = true;
  bool newPass = false;                             ///< the gun goes to `from` by a traverse
  Vec2 uvFrom = Vec2::Zero(), uvTo = Vec2::Zero();  ///< parameters of the patch; 0 elsewhere
};

/// What one SPRAY statement amounts to. Lengths mm, areas mm2, flows mm3/s, times s.
struct Sprayed {
  Span origin;
  int isn = 0;
  std::string work;  ///< name of the region or surface, "" when nested
  [[nodiscard]] std::string label() const {
    return !work.empty() ? work : planar ? "the region" : "the surface";
  }
  bool planar = true;
  Gun gun;            ///< with the footprint and stand-off that are used
  double film = 0.0;  ///< wanted
  double overlap = 0.0;
  double insetRatio = 0.0;  ///< c / b
  Uniformity uniformity;
  EdgeFilm edge;
  double area = 0.0;
  double shortestTime = 0.0;  ///< T_min
  std::size_t holes = 0;
  std::size_t boundaries = 1;
  bool priced = false;          ///< MINCST was given
  Trial chosen;                 ///< size, angle, lengths, speed, flow and cost
  std::vector<Trial> trials;    ///< all that the search looked at
  std::vector<Stroke> strokes;  ///< in order, traverses left out
  /// On a bent surface the nozzle goes a longer or shorter way than its spray; mm/s.
  [[nodiscard]] double nozzleSpeed(const Stroke& stroke) const;
  /// Where the gun is when a stroke that begins a pass is reached: before it, where the gun is
  /// switched on early.
  [[nodiscard]] GunPose beginOf(const Stroke& stroke) const;
  [[nodiscard]] GunPose endOf(const Stroke& stroke) const;

  /// Of a region: its plane and its outline, for the film map.
  Vec3 origin3 = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), normal = Vec3::UnitZ();
  Outline outline;
  double sharpest = PassRules::mitreLimit;  ///< of the corners of the offset curve

  /// Of a surface: how it was divided, and its smallest radii of curvature (0: flat) along and
  /// across the lines.
  std::optional<double> radiusAlong, radiusAcross;
  std::string advice;  ///< which direction suits better, "" when the lines run that way
  std::size_t lines = 0;
  std::size_t leftOut = 0;     ///< lines too short to be sprayed
  double shortest = HUGE_VAL;  ///< the length of the shortest of them
  double step = 0.0;
  double clearance = 0.0;      ///< of traverses, 0: not looked at
  std::size_t traverses = 0;   ///< from line to line
  std::size_t unclear = 0;     ///< that find no way round and go straight on
  std::vector<WayRound> ways;  ///< that do not go straight, by stroke; to the first line too
  double past = 0.0;           ///< how far lines go on beyond the edges
  std::shared_ptr<const Patch> patch;       ///< of a surface that is no mesh, else null
  std::shared_ptr<const MeshSurface> mesh;  ///< of a mesh, else null
};

}  // namespace arelem::spray
