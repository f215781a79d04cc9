#pragma once
#include <optional>
#include <string>

#include "ir/space/tolerance.h"
#include "runtime/motion/axis_source.h"
#include "runtime/motion/tilt.h"

namespace arelem::motion {

/// The normals from which the axis follows.
struct AngleNormals {
  Vec3 control = Vec3::UnitZ(), other = Vec3::UnitX();

  [[nodiscard]] AngleNormals towards(const AngleNormals& to, double share) const {
    return {(control + share * (to.control - control)).normalized(),
            (other + share * (to.other - other)).normalized()};
  }
  [[nodiscard]] double from(const AngleNormals& n) const {
    return (control - n.control).norm() + (other - n.other).norm();
  }
};

/// Where a tool with some axis touches both surfaces. The normal of the controlling one is on the
/// side of the axis.
struct AngleTouch {
  tool::Contact control, other;

  [[nodiscard]] AngleNormals normals() const { return {control.normal, other.normal}; }
};

/// One half of ATANGL each: the contacts that follow from an axis, and the axis that follows from
/// their normals.
class AngleRule {
 public:
  AngleRule(const Tilt& tilt, AngleSide control, AngleSide other, const Vec3& forward)
      : tilt_(tilt), control_(std::move(control)), other_(std::move(other)), forward_(forward) {}

  [[nodiscard]] AngleTouch touch(const Vec3& toolEnd, const Vec3& axis);
  [[nodiscard]] std::optional<Vec3> axisOf(const AngleNormals& n);
  /// The axis that follows from the contacts with another one.
  [[nodiscard]] std::optional<Vec3> step(const Vec3& toolEnd, const Vec3& from) {
    last_ = touch(toolEnd, from);
    return axisOf(last_.normals());
  }
  /// Where an axis that the last step gave back is the other normal, the tool lies on that surface
  /// with its level bottom, and every axis at the angle with which it does gives itself back.
  /// Nearly so, beside the edge of the bottom, it hardly turns either.
  [[nodiscard]] bool liesFlat(const Vec3& axis, double nearly = tolerance::symmetric) const;
  /// An axis at the angle, near one, and how far aside of it and the controlling normal the tool
  /// touches the other surface. With any but a level bottom the axis of the rule is that with which
  /// it does not. None where the angle is not to be had.
  struct Aside {
    Vec3 axis;
    double distance = 0.0;
  };
  [[nodiscard]] std::optional<Aside> aside(const Vec3& toolEnd, Vec3 near);
  /// The way in which axes turn that keep the angle of that one.
  [[nodiscard]] Vec3 turning(const Vec3& axis) const {
    return last_.control.normal.cross(axis).normalized();
  }
  /// Without an angle any place of a level bottom is the contact for the axis along its normal: of
  /// these axes the one whose contact is the tool end, if that is the contact.
  [[nodiscard]] std::optional<Vec3> onToolEnd(const Vec3& toolEnd, const Vec3& near);
  /// Where the normal with an axis leaves no other one: an axis whose normal leaves one, of those
  /// that follow from the nearest angles. None where these lead to none.
  [[nodiscard]] std::optional<Vec3> possible(const Vec3& toolEnd, Vec3 axis);
  /// Four axes: keeps to the side of the normal on which this one is.
  void hold(const Vec3& toolEnd, const Vec3& axis);
  /// The side that is kept, told from the normal there.
  void keep(const Vec3& toolEnd, const Vec3& axis);
  /// As it was held.
  void startAnew() { tilt_ = held_.value_or(tilt_); }

  /// The sense of the motion, which axes that lead follow.
  [[nodiscard]] const Vec3& forward() const { return forward_; }
  void setForward(const Vec3& forward) { forward_ = forward; }

  [[nodiscard]] const Tilt& tilt() const { return tilt_; }
  [[nodiscard]] const std::string& controlName() const { return control_.name; }
  /// Why `axisOf` had no axis.
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  Tilt tilt_;
  std::optional<Tilt> held_;
  AngleSide control_, other_;
  Vec3 forward_;
  AngleTouch last_;  ///< of the last step
  std::string reason_;
};

}  // namespace arelem::motion
