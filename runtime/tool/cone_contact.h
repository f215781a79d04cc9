#pragma once
#include <optional>

#include "runtime/geometry/kinds/cone.h"
#include "runtime/tool/section_contact.h"

/// Contact of the corner of a cutter with the outside of a cone, near the last one.
///
/// The distance from a cone is convex: a place of the cutter whose normal has all of the cutter
/// before it is the nearest. On the circle about which the corner arc goes it is found by Newton on
/// the angle, in a frame of the tool where that circle is level and nothing but the angle and the
/// way of the tool changes.
namespace arelem::tool {

/// What is kept from one contact to the next.
class ConeSearch {
 public:
  /// None where there was none before, the axis has turned, or it is not proven to be the nearest.
  [[nodiscard]] std::optional<Contact> contact(const surface::Cone& s,
                                               const Profile& cutter,
                                               const Vec3& te,
                                               const Vec3& axis);
  /// Goes on from a contact that was found otherwise; of a cutter without such a corner, or one
  /// that touches elsewhere, there is nothing to go on from.
  void goOn(const surface::Cone& s,
            const Profile& cutter,
            const Vec3& te,
            const Vec3& axis,
            const Contact& found);
  [[nodiscard]] bool isKnown() const { return known_; }
  /// The direction of the contact from the tool axis.
  [[nodiscard]] Vec3 toward() const { return cosine_ * first_ + sine_ * second_; }

 private:
  bool turnBy(double angle);
  void noteTurns(const Vec3& here, const Vec3& way, const Vec3& turns);

  bool known_ = false;
  Vec3 first_ = Vec3::UnitX(), second_ = Vec3::UnitY(), axis_ = Vec3::Zero();
  Vec3 coneAxis_ = Vec3::UnitZ();     ///< in that frame, as all that follows
  double cosine_ = 1.0, sine_ = 0.0;  ///< of the direction of the contact
  Vec3 at_ = Vec3::Zero();            ///< the tool end then, from the vertex
  Vec3 turns_ = Vec3::Zero();         ///< its turn by the way of the tool
  bool turnsKnown_ = false;
  Vec3 along_ = Vec3::Zero();   ///< the way from the contact before, and
  Vec3 change_ = Vec3::Zero();  ///< the change of the turn on it, over its square
};

}  // namespace arelem::tool
