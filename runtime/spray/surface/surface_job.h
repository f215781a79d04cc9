#pragma once
#include <memory>
#include <variant>

#include "ir/space/spray_tolerance.h"
#include "runtime/spray/sprayed.h"
#include "runtime/spray/surface/mesh_surface.h"
#include "runtime/spray/surface/surface_lines.h"

namespace arelem::spray {

/// SPRAY on a surface, with every value known. Lengths mm.
struct SurfaceJob {
  Patch patch;
  std::shared_ptr<const MeshSurface> mesh;  ///< in place of the patch; lines are sections then
  Gun gun;
  double film = 0.0;
  /// Lines along u or v; sections parallel to a plane (its unit normal); or radial about an axis
  /// (a place and a unit direction).
  struct Parallel {
    Vec3 normal = Vec3::UnitX();
  };
  struct Radial {
    Vec3 place = Vec3::Zero();
    Vec3 axis = Vec3::UnitZ();
  };
  enum class Way : std::uint8_t { alongU, alongV };
  std::variant<Way, Parallel, Radial> lines = Way::alongU;
  double step = 0.0;  ///< largest distance of lines; 0: the half width of the footprint
  double chord = 0.5;
  bool checkRadius = true;  ///< and hollows, and walls before the gun
  /// Between lines the nozzle stays so far off the work; none: half the stand-off. 0: straight on.
  std::optional<double> clear;
  std::optional<GunPose> stands;  ///< where the gun comes from, if that is known; axis 0: unknown
  [[nodiscard]] double clearance() const {
    return clear.value_or(tolerance::wayClear * gun.standOff);
  }
  double past = 0.0;  ///< lines go on so far beyond the edges
  /// With `past`: the planes that end the surface, moved out by it; what they keep in place of the
  /// patch or of the mesh. Lines lie on that.
  std::vector<HalfSpace> ends;
  std::optional<Patch> widePatch;
  std::shared_ptr<const MeshSurface> wideMesh;
  /// Without planes and limits: what the gun may run into. A surface without ends of its own has
  /// none.
  std::shared_ptr<const MeshSurface> wholeMesh;
  std::optional<Patch> wholePatch;
  std::optional<double> speed;
  std::uint64_t mostPoints = arelem::Limits{}.points;
  std::uint64_t mostLines = arelem::Limits{}.passes;
};

/// Error E0375 for more lines than the limit.
[[nodiscard]] std::optional<Failure> objectionToLines(double lines, std::uint64_t most);

/// Lines, speed from the flow, curvature check. Errors: E0599, E0349, E0358, E0373 to E0376, E0379,
/// E0389.
[[nodiscard]] Result<Sprayed> spraySurface(const SurfaceJob& job);

}  // namespace arelem::spray
