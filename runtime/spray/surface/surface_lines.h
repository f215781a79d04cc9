#pragma once
#include <vector>

#include "ir/limits.h"
#include "runtime/spray/lines.h"
#include "runtime/spray/outline.h"
#include "runtime/spray/surface/patch.h"

namespace arelem::spray {

/// A place of a line on a surface, with the normal there and the parameters of the patch (of a
/// mesh 0).
struct LinePoint {
  Vec3 place = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
  Vec2 uv = Vec2::Zero();
};
using SurfaceLine = std::vector<LinePoint>;

/// How lines lie on a patch.
struct Layout {
  bool alongU = true;   ///< lines of constant v
  double widest = 0.0;  ///< largest distance of neighboring lines, mm
  double chord = 0.5;   ///< largest distance of a chord from its line, mm
  std::uint64_t mostPoints = arelem::Limits{}.points;
};

struct LineSet {
  std::vector<SurfaceLine> lines;
  LineCount count;       ///< intervals and their length where the lines are farthest apart
  bool complete = true;  ///< false: more points than the layout allows; lines are missing
};

/// About how many points the lines need, by how much they bend. Sampled: a corner may hide.
[[nodiscard]] double pointsNeeded(const Patch& patch, const Layout& layout);

/// Lines at equal parameter steps, so many that they are nowhere farther apart than asked for:
/// intervals = ceil(L / r), L the longest way across. The last line of a closed turn is left out.
/// Points follow each other by the chord tolerance. Lines run to and fro, over the whole range of
/// the parameters: planes that cut the patch off do not cut them. Source: Sen 3.1, 5.2.
[[nodiscard]] LineSet linesOn(const Patch& patch, const Layout& layout);

/// Leaves out points whose places lie within the chord tolerance, and whose normals lie within
/// 0.02 rad, of what is straight between those that stay (Douglas and Peucker).
[[nodiscard]] SurfaceLine thinned(const SurfaceLine& line, double chord);
/// Adds a line, begun at the end that is nearer to where the one before ended.
void appendToAndFro(std::vector<SurfaceLine>& lines, SurfaceLine line);

/// Whether the surface comes back to where it began along u (or v).
[[nodiscard]] bool closesAlong(const Patch& patch, bool alongU);
/// Area of the patch, mm2.
[[nodiscard]] double areaOf(const Patch& patch);
/// Longest way along u (or v), mm.
[[nodiscard]] double longestWay(const Patch& patch, bool alongU);

}  // namespace arelem::spray
