#pragma once
#include <string>

#include "ir/diag/result.h"
#include "ir/words/words.h"
#include "runtime/geometry/shapes.h"

/// Modifiers: what they choose between several mathematical solutions.
namespace arelem::define {

/// The axis a modifier speaks of and the sense: XLARGE, POSX: 0, +1; YSMALL, NEGY: 1, -1; ...
struct Sense {
  int axis = 0;
  double sign = 1.0;
};
[[nodiscard]] Sense senseOf(Word modifier);

/// One or two solutions of a plane problem. Of a tangent position there is one.
struct Candidates {
  geometry::Vec2 first = geometry::Vec2::Zero();
  geometry::Vec2 second = geometry::Vec2::Zero();
  bool single = false;
};

/// The candidate with the larger (smaller) coordinate. Fails, naming both, when the coordinates
/// differ by no more than rounding: an answer would be a random choice.
[[nodiscard]] Result<geometry::Vec2> choose(Word modifier, const Candidates& candidates);

/// The direction or its reverse, so that the named component has the named sign. Fails on a
/// component of no more than rounding, or than `uncertainty` (the angle by which a computed
/// direction may be off).
[[nodiscard]] Result<Vec3> orient(Word modifier, const Vec3& direction, double uncertainty = 0.0);

/// "(1.5, -2, 0)": coordinates for notes.
[[nodiscard]] std::string show(const geometry::Vec2& place);
[[nodiscard]] std::string show(const Vec3& place);

/// Unit vector; fails when all components are at most tolerance::nullDirection. `what` names the
/// direction.
[[nodiscard]] Result<Vec3> unit(const Vec3& direction, std::string_view what);

}  // namespace arelem::define
