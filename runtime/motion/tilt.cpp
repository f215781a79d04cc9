#include "runtime/motion/tilt.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "ir/space/tolerance.h"

namespace arelem::motion {

namespace {
/// Two cones about perpendicular lines: the third component of the axis.
std::optional<Vec3> inSpace(const Tilt& tilt,
                            const Vec3& normal,
                            const Vec3& side,
                            const Vec3& forward) {
  const double up = std::cos(tilt.alpha);
  const double ahead = tilt.lead ? std::sin(*tilt.lead) : 0.0;
  const double rest = 1.0 - up * up - ahead * ahead;
  if (rest < -tolerance::symmetric) {
    return std::nullopt;
  }
  const double aside = std::copysign(std::sqrt(std::max(rest, 0.0)), tilt.alpha);
  return Vec3(up * normal + ahead * forward + aside * side).normalized();
}

/// Cosine of an angle that is taken for a right one when a side is chosen.
constexpr double square = 1e-4;

/// A cone about the normal and a plane.
std::optional<Vec3> inPlane(const Tilt& tilt,
                            const Vec3& normal,
                            const Vec3& side,
                            const Vec3& forward) {
  const Vec3& across = *tilt.across;
  const Vec3 within = withinPlane(across, normal);
  const double length = within.norm();
  const double cosine = std::cos(tilt.alpha);
  if (length <= tolerance::symmetric || std::abs(cosine) > length * (1.0 + tolerance::symmetric)) {
    return std::nullopt;
  }
  const Vec3 first = within / length;
  const Vec3 second = across.cross(first);
  // Where the angle is that at which the normal leans out of the plane, there is one axis; what is
  // left of the sine is the root of rounding.
  const double ratio = cosine / length;
  const double c = 1.0 - ratio <= tolerance::rounding ? 1.0 : ratio;
  const double toSide = second.dot(side);
  const double sense = std::abs(toSide) > square ? toSide : second.dot(forward);
  const double turn = first.dot(tilt.turnedFrom) < 0.0 ? -tilt.turn : tilt.turn;
  const double s =
      std::copysign(std::sqrt(std::max(0.0, 1.0 - c * c)), turn != 0.0 ? turn : tilt.alpha * sense);
  return Vec3(c * first + s * second);
}
}  // namespace

std::optional<Vec3> tilted(const Tilt& tilt,
                           const Vec3& normal,
                           const Vec3& other,
                           const Vec3& forward) {
  const Vec3 aside = other - other.dot(normal) * normal;
  const double length = aside.norm();
  if (length <= tolerance::symmetric) {
    return std::nullopt;
  }
  const Vec3 side = aside / length;
  const Vec3 along = forward - forward.dot(normal) * normal - forward.dot(side) * side;
  const Vec3 ahead = along.norm() > 0.0 ? Vec3(along.normalized()) : Vec3(normal.cross(side));
  return tilt.across ? inPlane(tilt, normal, side, ahead) : inSpace(tilt, normal, side, ahead);
}

double turnAbout(const Vec3& across, const Vec3& normal, const Vec3& axis) {
  const double sine = across.dot(normal.cross(axis));
  return std::abs(sine) <= tolerance::symmetric ? 0.0 : std::copysign(1.0, sine);
}

std::string whyNotTilted(const Tilt& tilt, const Vec3& normal, const Vec3& other) {
  constexpr double degrees = 180.0 / std::numbers::pi;
  if (normal.cross(other).norm() <= tolerance::symmetric) {
    return "the normals of the part and the drive surface are parallel there";
  }
  if (tilt.across) {
    const double out = std::asin(std::clamp(normal.dot(*tilt.across), -1.0, 1.0));
    return fmt::format("the normal leans {:.6g} degrees out of the plane square to the vector",
                       std::abs(out) * degrees);
  }
  const double lead = tilt.lead.value_or(0.0);
  return fmt::format("the {} of {:.6g} degrees is more than that", lead < 0.0 ? "lag" : "lead",
                     std::abs(lead) * degrees);
}

}  // namespace arelem::motion
