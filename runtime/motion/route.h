#pragma once
#include "runtime/motion/axis.h"
#include "runtime/motion/state.h"

namespace arelem::motion {

/// True where the motion is plane geometry: vertical tool of plain side, lines and circles as drive
/// and check surfaces on a part plane that is not vertical. Then positions are exact; elsewhere
/// they lie in the tolerance band, on the side that leaves the next chord room (spec 4.7, 4.8).
[[nodiscard]] bool isPlaneRoute(const State& state,
                                const NamedSurface& drive,
                                const NamedSurface& part,
                                const NamedSurface* check);

/// The gap at which a stop is placed in the band [-inner, outer]: 0 where exact or flat, a tenth of
/// the band inside its outer edge on convex surfaces and meshes, inside its inner edge on concave
/// ones, between them where a surface is next to level. A saddle is what it is along the unit
/// tangent `path`, where that is not zero. It depends on the place and the path there alone, not on
/// the cut vectors up to it.
[[nodiscard]] double restGap(Field& field,
                             const Vec3& toolEnd,
                             AxisRule& axis,
                             double inner,
                             double outer,
                             bool exact,
                             const Vec3& path);

/// Curvature of the field's zero surface along the unit tangent t, by a difference of contact
/// normals; positive where it bends away from the tool, 0 where it is no more than rounding.
[[nodiscard]] double curvatureAlong(
    Field& field, const Vec3& toolEnd, AxisRule& axis, const Vec3& t, double step);

/// The side (1 or -1) from which the tool end ON a surface sees its band, where it comes from the
/// side `present`: that behind a wall, as if it went through, and the upper one of what lies below.
[[nodiscard]] double sideSeenOn(const Vec3& normal, const Vec3& axis, double present);

/// The field of the tool end ON a surface, seen from the side from which it lies within
/// [-inner, outer]; where both do, as sideSeenOn says, and where it stands on a wall itself from
/// that towards which this bulges, so that the band's outer edge is the free one.
[[nodiscard]] std::unique_ptr<Field> onField(const surface::AnySurface& surface,
                                             const Vec3& toolEnd,
                                             AxisRule& axis,
                                             double inner,
                                             double outer);

/// The part surface in force: PSIS, a startup, AUTOPS, or the XY plane.
[[nodiscard]] NamedSurface partSurface(const State& state);
[[nodiscard]] Result<NamedSurface> named(const EntityPtr& entity);
[[nodiscard]] const tool::Profile* cutterFor(const State& state, Role role);

/// The point from which the side of a surface is judged: on the axis at half the cutter's height.
[[nodiscard]] Vec3 sidePoint(const State& state, const Vec3& toolEnd, const Vec3& axis);

}  // namespace arelem::motion
