#pragma once
#include <memory>

#include <Eigen/Dense>

#include "runtime/motion/axis_source.h"

namespace arelem::motion {

/// How the tool axis follows from the tool position: fixed, or from a source.
class AxisRule {
 public:
  AxisRule() = default;
  explicit AxisRule(const Vec3& fixed) : fixed_(fixed) {}
  explicit AxisRule(std::unique_ptr<AxisSource> source) : source_(std::move(source)) {}

  [[nodiscard]] bool isFixed() const { return source_ == nullptr; }
  [[nodiscard]] Vec3 at(const Vec3& toolEnd) { return isFixed() ? fixed_ : source_->at(toolEnd); }
  /// Why there is no axis with the tool end there.
  [[nodiscard]] std::optional<Failure> fault(const Vec3& toolEnd) {
    if (isFixed()) {
      return std::nullopt;
    }
    (void)source_->at(toolEnd);
    return source_->fault();
  }
  /// The same where a step ended: what the step found counts, whatever was looked at behind it.
  [[nodiscard]] std::optional<Failure> faultAt(const Vec3& toolEnd, const Vec3& axis) {
    if (isFixed()) {
      return std::nullopt;
    }
    source_->back(toolEnd, axis);
    return source_->fault();
  }
  /// The tool may come to where the axis was asked for last.
  void mark() {
    if (!isFixed()) {
      source_->mark();
    }
  }
  /// As it was where a place was marked.
  void back(const Vec3& toolEnd, const Vec3& axis) {
    if (!isFixed()) {
      source_->back(toolEnd, axis);
    }
  }
  /// Of axes that have a choice, from there on that which they make there.
  void hold(const Vec3& toolEnd) {
    if (!isFixed()) {
      source_->hold(toolEnd);
    }
  }
  /// The tool has come there; what was looked at elsewhere is forgotten.
  void stand(const Vec3& toolEnd, const Vec3& axis) {
    if (!isFixed()) {
      source_->stand(toolEnd, axis);
    }
  }
  /// Forgets all places.
  void startAnew() {
    if (!isFixed()) {
      source_->startAnew();
    }
  }
  /// Why a motion may not get on from there.
  [[nodiscard]] std::optional<Failure> jump(const Vec3& toolEnd) {
    (void)at(toolEnd);
    return isFixed() ? std::nullopt : source_->jump();
  }
  /// False where the axis that it was asked for last is one of many that turn into each other.
  [[nodiscard]] bool settles() const { return isFixed() || source_->settles(); }
  /// Change of the axis with the tool end, d axis / d tool end, by central differences; none where
  /// the axis does not settle next to it.
  [[nodiscard]] Eigen::Matrix3d change(const Vec3& toolEnd);

 private:
  Vec3 fixed_ = Vec3::UnitZ();
  std::unique_ptr<AxisSource> source_;
};

/// Change of a gap with the tool axis: d gap / d axis. The contact point turns with the cutter.
[[nodiscard]] inline Vec3 changeWithAxis(const tool::Contact& contact,
                                         const Vec3& toolEnd,
                                         const Vec3& axis) {
  const Vec3 arm = contact.point - toolEnd;
  return contact.normal * axis.dot(arm) - arm * contact.normal.dot(axis);
}

/// Turn of the axis per length of a straight path from one axis to another: a rotation vector whose
/// cross product with an arm is the arm's velocity.
[[nodiscard]] inline Vec3 spin(const Vec3& from, const Vec3& to, double length) {
  return length > 0.0 ? Vec3(from.cross(to) / length) : Vec3(Vec3::Zero());
}

/// Change of a gap per length of path along `direction` while the axis turns by `spin`.
[[nodiscard]] inline double slopeAlong(const tool::Contact& contact,
                                       const Vec3& toolEnd,
                                       const Vec3& direction,
                                       const Vec3& spin) {
  return contact.normal.dot(direction + spin.cross(contact.point - toolEnd));
}

}  // namespace arelem::motion
