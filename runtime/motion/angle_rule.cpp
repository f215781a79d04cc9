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

bool AngleRule::liesFlat(const Vec3& axis, double nearly) const {
  const bool isFree = !tilt_.across && tilt_.lead.value_or(0.0) == 0.0 && tilt_.alpha != 0.0;
  return isFree && !other_.on && (last_.other.normal - axis).norm() <= nearly;
}

std::optional<AngleRule::Aside> AngleRule::aside(const Vec3& toolEnd, Vec3 near) {
  constexpr int most = 20;
  for (int repeats = 0; repeats < most; ++repeats) {
    const AngleTouch there = touch(toolEnd, near);
    const auto next = axisOf({there.control.normal, near});
    if (!next) {
      return std::nullopt;
    }
    const double moved = (*next - near).norm();
    near = *next;
    if (moved <= tolerance::rounding) {
      last_ = there;
      const Vec3 arm = withinPlane(near, there.other.point - toolEnd);
      if (arm.norm() <= tolerance::sameSide) {
        return std::nullopt;  // at its tip a tool has no side
      }
      const double distance = turning(near).dot(arm);
      return Aside{near, std::abs(distance) <= tolerance::rounding * arm.norm() ? 0.0 : distance};
    }
  }
  return std::nullopt;
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
