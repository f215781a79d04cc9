#pragma once
#include "runtime/define/choice.h"

/// Constructions in the xy plane that several forms share.
namespace arelem::define {

/// Line through two places; normal to the right of first -> second.
[[nodiscard]] Result<geometry::Line> lineThrough(const geometry::Vec2& first,
                                                 const geometry::Vec2& second);
/// Line through a place with this unit direction's left normal.
[[nodiscard]] geometry::Line lineAlong(const geometry::Vec2& place, double cosine, double sine);
/// Line through a place with this unit normal.
[[nodiscard]] geometry::Line lineWithNormal(const geometry::Vec2& place,
                                            const geometry::Vec2& normal);
/// The line moved by `distance` towards the modifier; its normal then points there.
[[nodiscard]] Result<geometry::Line> offset(const geometry::Line& line,
                                            Word modifier,
                                            double distance);

/// Common place of two lines.
[[nodiscard]] Result<geometry::Vec2> meet(const geometry::Line& first,
                                          const geometry::Line& second);
/// Common places of a line and a circle. Nearer to tangency than tolerance::coincidence: one place,
/// on the line.
[[nodiscard]] Result<Candidates> meet(const geometry::Line& line,
                                      const geometry::Vec2& center,
                                      double radius);
/// Common places of two circles, of tangent ones (within tolerance::coincidence) one.
[[nodiscard]] Result<Candidates> meet(const geometry::Vec2& center1,
                                      double radius1,
                                      const geometry::Vec2& center2,
                                      double radius2);

[[nodiscard]] Result<double> positiveRadius(double radius);

}  // namespace arelem::define
