#pragma once

#include "runtime/geometry/kinds.h"
#include "runtime/tool/cone_contact.h"
#include "runtime/tool/near_triangles.h"
#include "runtime/tool/profile.h"
#include "runtime/tool/section_contact.h"

/// Contact of a cutter with one side of a surface.
///
/// The gap g(te) is the least signed distance of any cutter point to the surface, counted positive
/// on the given side: 0 where the cutter touches, negative where it gouges. Whatever surface and
/// cutter, g is 1-Lipschitz in the tool end te and its gradient is the unit surface normal at the
/// contact, so g is the signed distance field of the surface on which the tool end runs.
namespace arelem::tool {

/// Where the last contact was: starts the next search.
template <class Hint>
struct LastContact {
  Hint hint{};
  bool valid = false;
  bool convex = false;              ///< side * distance is a convex function of the place
  Vec3 convexAt = Vec3::Zero();     ///< or was looked at here, and is one all over a cutter whose
  double convexWay = 0.0;           ///< middle is as near, or is not as near as minus that
  Vec3 toward = Vec3::UnitX();      ///< direction of the contact about the axis, when the
  Vec3 towardAt = Vec3::Zero();     ///< tool was there, and
  Vec3 towardTurns = Vec3::Zero();  ///< its turn about the axis by the way of the tool
  Vec3 turnsAlong = Vec3::Zero();   ///< the way there from the contact before, and
  Vec3 turnsChange = Vec3::Zero();  ///< the change of the turn on it, over its square
  bool onDisc = false;              ///< it was inside a level bottom, with the foot there:
  Vec3 discFoot = Vec3::Zero();
  double bound = 0.0, boundRadius = -1.0;  ///< of the bend towards the cutter, around:
  Vec3 boundAt = Vec3::Zero();
  double clearance = -1.0;  ///< of the upper shank beyond the gap, when the tool was there:
  Vec3 clearAt = Vec3::Zero(), clearAxis = Vec3::Zero();
  /// Half the lead of the contact over all places of a survey not beside it, and the gap behind it,
  /// when the tool was there:
  double lead = -1.0, leadGap = 0.0;
  Vec3 leadAt = Vec3::Zero(), leadAxis = Vec3::Zero();
};

template <surface::Surface S>
struct Search : LastContact<typename S::Hint> {};

template <>
struct Search<surface::TabulatedCylinder> : LastContact<surface::TabulatedCylinder::Hint> {
  SectionSearch section;
};

template <>
struct Search<surface::Cone> : LastContact<surface::Cone::Hint> {
  ConeSearch corner;
};

/// With a mesh: the last foot or nearest triangle, and what is near on the way.
template <>
struct Search<surface::Mesh> {
  surface::Mesh::Hint hint{};
  NearTriangles near;
};

/// The tool end alone: relation ON.
template <surface::Surface S>
[[nodiscard]] Contact pointContact(const S& s,
                                   double side,
                                   const Vec3& te,
                                   typename S::Hint& hint) {
  const surface::Foot foot = s.foot(te, hint);
  return {side * foot.distance, side * foot.normal, te};
}

/// `side` is +1 or -1, the side of the surface on which the cutter is; `axis` the unit tool axis.
template <surface::Surface S>
[[nodiscard]] Contact contact(const S& s,
                              double side,
                              const Profile& cutter,
                              const Vec3& te,
                              const Vec3& axis,
                              Search<S>& search);

}  // namespace arelem::tool
