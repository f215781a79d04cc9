#include "runtime/motion/angle_rule.h"

#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::motion {

AngleTouch AngleRule::touch(const Vec3& toolEnd, const Vec3& axis) {
  AngleTouch t{control_.field->at(toolEnd, axis), other_.field->at(toolEnd, axis)};
  if (control_.on) {
    const double up = t.control.normal.dot(axis);
    t.control.normal *=
        (std::abs(up) <= tolerance::symmetric ? control_.side : up) < 0.0 ? -1.0 : 1.0;
  }
  return t;
}

std::optional<Vec3> AngleRule::axisOf(const AngleNormals& n) {
  const Vec3 common = n.control.cross(n.other);
  const Vec3 forward = common.dot(forward_) < 0.0 ? Vec3(-common) : common;
  if (forward.norm() > tolerance::symmetric) {
    forward_ = forward.normalized();
  }
  auto axis = tilted(tilt_, n.control, n.other, forward_);
  if (!axis) {
    reason_ = whyNotTilted(tilt_, n.control, n.other);
  }
  return axis;
}

std::optional<Vec3> AngleRule::onToolEnd(const Vec3& toolEnd, const Vec3& near) {
  if (tilt_.alpha != 0.0 || tilt_.lead.value_or(0.0) != 0.0 || control_.on || !control_.under) {
    return std::nullopt;
  }
  Vec3 axis = control_.under->at(toolEnd, near).normal;
  if (tilt_.across) {
    axis = withinPlane(*tilt_.across, axis).normalized();
  }
  const Vec3 normal = control_.field->at(toolEnd, axis).normal;
  return (normal - axis).norm() <= tolerance::symmetric ? std::optional(axis) : std::nullopt;
}

std::optional<Vec3> AngleRule::possible(const Vec3& toolEnd, Vec3 axis) {
  constexpr int most = 20;
  for (int tries = 0; tilt_.across && tries < most; ++tries) {
    const AngleNormals n = touch(toolEnd, axis).normals();
    if (tries > 0 && axisOf(n)) {
      return axis;
    }
    const Vec3 within = withinPlane(*tilt_.across, n.control);
    if (within.norm() <= tolerance::symmetric) {
      return std::nullopt;
    }
    const Vec3 next = within.normalized();
    if ((next - axis).norm() <= tolerance::symmetric) {
      return std::nullopt;
    }
    axis = next;
  }
  return std::nullopt;
}

void AngleRule::hold(const Vec3& toolEnd, const Vec3& axis) {
  if (tilt_.across) {
    tilt_.turnedFrom = touch(toolEnd, axis).control.normal;
    tilt_.turn = turnAbout(*tilt_.across, tilt_.turnedFrom, axis);
    held_ = tilt_;
  }
}

void AngleRule::keep(const Vec3& toolEnd, const Vec3& axis) {
  if (tilt_.across && tilt_.turn != 0.0) {
    const Vec3 normal = touch(toolEnd, axis).control.normal;
    const Vec3 within = withinPlane(*tilt_.across, normal);
    tilt_.turn *= within.dot(tilt_.turnedFrom) < 0.0 ? -1.0 : 1.0;
    tilt_.turnedFrom = within;
  }
}

}  // namespace arelem::motion
