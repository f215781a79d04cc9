#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ir/diag/result.h"
#include "ir/limits.h"
#include "runtime/region/region.h"

/// Drawings in DXF (ASCII, R12 and later): only what bounds a region.
namespace arelem::region {

using spray::Vec2;

/// A curve of a drawing as points, chorded; a closed one does not repeat its first point.
struct Curve {
  std::vector<Vec2> points;
  bool closed = false;
  double height = 0.0;  ///< z
  std::string useless = {};  ///< why it bounds nothing, behind its name; "" where it bounds
};

struct DrawingRules {
  std::string layer;   ///< "" for all
  double chord = 0.0;  ///< largest distance of a chord from its curve, units of the part program
  double unit = 1.0;   ///< millimeters in a unit of the part program
  std::uint64_t mostPoints = arelem::Limits{}.corners;
};

struct Drawing {
  /// Entities of one kind: how many, and the line of the first.
  struct Kind {
    std::size_t count = 0;
    std::size_t line = 0;
  };
  using Kinds = std::map<std::string, Kind>;
  std::vector<Curve> curves;        ///< of the layer, in units of the part program
  double height = 0.0;              ///< their z
  Kinds useless;                    ///< of the layer, that bound nothing: left out
  Kinds hidden;                     ///< of the layer, that the drawing does not show: left out
  std::vector<std::string> layers;  ///< of all entities, sorted
};

/// Reads LINE, ARC, CIRCLE, LWPOLYLINE and POLYLINE (with bulges), ELLIPSE, SPLINE, and these in
/// blocks that INSERT places (scaled, turned, in rows and columns, one in another). Lengths are
/// converted where the drawing states its units ($INSUNITS). Curves that lie in no plane parallel
/// to xy, or in another than the first, are useless. What lies on a layer that is off or frozen,
/// but for the layer of the rules, in paper space, or is invisible, is hidden. `name` is used in
/// messages. Errors: E0367, E0393.
[[nodiscard]] Result<Drawing> readDrawing(std::string_view text,
                                          std::string_view name,
                                          const DrawingRules& rules);

/// Chains curves to closed loops by their ends. Errors: E0369 open, E0371 more than two ends meet.
[[nodiscard]] Result<std::vector<spray::Loop>> chained(std::vector<Curve> curves,
                                                       std::string_view name,
                                                       double joint);

/// Points of a circular arc from its start angle, counterclockwise for a positive sweep (radians),
/// both ends included. An arc that needs more than `most` chords has some more than that: it is
/// refused by their number.
[[nodiscard]] std::vector<Vec2> arcPoints(
    const Vec2& center, double radius, double start, double sweep, double chord, std::size_t most);

}  // namespace arelem::region
