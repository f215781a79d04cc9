#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "ir/diag/result.h"
#include "runtime/certify/modal.h"

namespace arelem::certify {

/// What POCKET asks of its path, told by the statement and by what is in force before it.
struct PocketTask {
  /// A side of the bottom: the tool end x keeps `inward`.x >= `least`.
  struct Wall {
    Vec3 inward = Vec3::Zero();  ///< unit
    double least = 0.0;          ///< part unit
    std::size_t point = 0;       ///< of the statement, from 0: where the side begins
  };
  Vec3 normal = Vec3::UnitZ();  ///< of the bottom, unit
  double offset = 0.0;          ///< the bottom is where `normal`.x is this
  double warp = 0.0;            ///< how far the points of the statement are out of it, part unit
  std::vector<Wall> walls;
  std::vector<Vec3> corners;    ///< of the places that the walls leave to the tool end
  std::optional<double> reach;  ///< Re; none with o = 1, where material may stay
};

/// Errors: E0915 for points that bound nothing convex, an axis along the bottom, a part surface
/// that is no plane, a cutter without radius, walls that leave no place to the tool.
[[nodiscard]] Result<PocketTask> pocketTask(const runtime::Pocket& pocket, const Modal& modal);

/// True where the path ends with the whole outline of the places that the walls leave, each corner
/// within `slack`: with it POCKET ends.
[[nodiscard]] bool endsWithOutline(const PocketTask& task,
                                   const std::vector<Vec3>& path,
                                   double slack);

/// The location that is farthest from where it may be.
struct PocketStray {
  std::size_t location = 0;
  double away = 0.0;  ///< part unit; not above 0: nowhere
};
[[nodiscard]] PocketStray offBottom(const PocketTask& task, const std::vector<Vec3>& path);
/// The wall that is come too near to is `point`, from 0. Since the places are a convex set, cut
/// vectors between places in it stay in it.
struct WallStray : PocketStray {
  std::size_t point = 0;
};
[[nodiscard]] WallStray beyondWalls(const PocketTask& task, const std::vector<Vec3>& path);

/// A place of the bottom that no cut vector comes near enough to.
struct Uncleared {
  Vec3 place = Vec3::Zero();
  double away = 0.0;  ///< of the nearest cut vector, part unit
  bool certain = true;
};
/// Whether all places that the walls leave to the tool end are within `reach` + `slack` of a cut
/// vector. The strip beside a cut vector is taken away from them, again and again; what is at the
/// ends of cut vectors is halved. A convex piece whose corners are near one cut vector is, since
/// the distance of a segment is convex, near it everywhere; one whose middle is near none refutes.
/// Undecided (not `certain`) after `mostCells`.
inline constexpr std::uint64_t mostCells = 4'000'000;
[[nodiscard]] std::optional<Uncleared> uncleared(const PocketTask& task,
                                                 const std::vector<Vec3>& path,
                                                 double slack);

}  // namespace arelem::certify
