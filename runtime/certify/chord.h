#pragma once
#include <cmath>

#include "ir/space/vector.h"

namespace arelem::certify {

/// One cut vector as the machine moves along it: the tool end goes straight, the axis turns evenly
/// in the plane of its two directions. `s` runs from 0 to 1.
class Chord {
 public:
  Chord() = default;
  Chord(const Vec3& from, const Vec3& to, const Vec3& axisFrom, const Vec3& axisTo)
      : from_(from), to_(to), axisFrom_(axisFrom), axisTo_(axisTo), step_(to - from) {
    const Vec3 across = axisFrom.cross(axisTo);
    const double sine = across.norm();
    turn_ = std::atan2(sine, axisFrom.dot(axisTo));
    pole_ = poleOf(sine > 0.0 ? Vec3(across / sine) : across, axisFrom);
  }

  [[nodiscard]] Vec3 toolEnd(double s) const { return s == 1.0 ? to_ : Vec3(from_ + s * step_); }
  [[nodiscard]] Vec3 axis(double s) const {
    if (turn_ == 0.0 || s == 0.0 || s == 1.0) {
      return s == 1.0 ? axisTo_ : axisFrom_;
    }
    return std::cos(s * turn_) * axisFrom_ + std::sin(s * turn_) * pole_.cross(axisFrom_);
  }
  /// d toolEnd / ds.
  [[nodiscard]] const Vec3& step() const { return step_; }
  /// Velocity, by s, of a point of the tool that is at `offset` from the tool end.
  [[nodiscard]] Vec3 velocity(const Vec3& offset) const {
    return turn_ == 0.0 ? step_ : Vec3(step_ + turn_ * pole_.cross(offset));
  }
  [[nodiscard]] double length() const { return step_.norm(); }
  /// Angle between the axes at the two ends. Radians.
  [[nodiscard]] double turn() const { return turn_; }
  /// Unit, square to the axis at all places, which turns about it if it does.
  [[nodiscard]] const Vec3& pole() const { return pole_; }

 private:
  /// Of axes that differ by rounding alone the product is rounding of any direction; the pole is
  /// square to the axis all the same.
  static Vec3 poleOf(const Vec3& across, const Vec3& axis) {
    constexpr double most = 0.1;
    const double along = across.dot(axis);
    return across.isZero(0.0) || std::abs(along) > most
               ? Vec3(axis.unitOrthogonal())
               : Vec3((across - along * axis).normalized());
  }

  Vec3 from_ = Vec3::Zero(), to_ = Vec3::Zero();
  Vec3 axisFrom_ = Vec3::UnitZ(), axisTo_ = Vec3::UnitZ();
  Vec3 step_ = Vec3::Zero();
  Vec3 pole_ = Vec3::UnitX();
  double turn_ = 0.0;
};

}  // namespace arelem::certify
