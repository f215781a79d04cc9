#pragma once
#include "runtime/film/map.h"

namespace arelem::film {

/// The film on a surface, over its parameters: cells of about `cell` mm (0: 200 in the longer way,
/// or 12 in the half width of the footprint, but not more than 60 000), at the middle of each the
/// spray of all strokes summed up in short pieces. The paint flies straight from the nozzle; a
/// place farther away gets less by the square of the distance, and less by the angle under which it
/// is met; what faces away gets none. A mesh is seen along its mean normal; its statistics are
/// those of all triangles.
[[nodiscard]] Map surfaceMapOf(const spray::Sprayed& sprayed, double cell);

/// The film on a surface looked at in a few thousand places: enough to see whether it is even.
[[nodiscard]] Statistics roughStatistics(const spray::Sprayed& sprayed);

/// Where a place of the surface, with its parameters, lies in the map.
[[nodiscard]] spray::Vec2 placeInMap(const spray::Sprayed& sprayed,
                                     const Map& map,
                                     const Vec3& place,
                                     const spray::Vec2& uv);

}  // namespace arelem::film
