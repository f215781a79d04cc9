#include "runtime/motion/route.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/geometry/title.h"

namespace arelem::motion {

namespace {
/// Share of the band that stays between a stop and the band's edge (the old system's 10 %).
constexpr double edgeShare = 0.1;
/// Curvature that gaps tell is measured over so many times the distance.
constexpr double gapProbe = 4.0;

bool isVertical(const Vec3& axis) {
  return std::abs(axis.z()) >= 1.0 - tolerance::rounding;
}

/// A vertical plane or a vertical circular cylinder.
bool isUpright(const NamedSurface& s) {
  if (const auto* plane = std::get_if<surface::Plane>(&s.surface)) {
    return std::abs(plane->normal.z()) <= tolerance::nullDirection;
  }
  const auto* cylinder = std::get_if<surface::Cylinder>(&s.surface);
  return cylinder != nullptr && isVertical(cylinder->axis);
}
}  // namespace

bool isPlaneRoute(const State& state,
                  const NamedSurface& drive,
                  const NamedSurface& part,
                  const NamedSurface* check) {
  const auto* plane = std::get_if<surface::Plane>(&part.surface);
  const bool stock = check != nullptr
                         ? state.thick[checkRole] != 0.0
                         : state.thick[partRole] != 0.0 || state.thick[driveRole] != 0.0;
  return !stock && !state.multax && !state.alwaysIterate && isVertical(state.axis) &&
         (!state.cutter || state.cutter->beta == 0.0) && plane != nullptr &&
         std::abs(plane->normal.z()) > tolerance::nullDirection && isUpright(drive) &&
         (check == nullptr || isUpright(*check));
}

namespace {
/// Where the surface does not curve (a leaning cylinder met by the shank, a plane by a tool whose
/// axis follows it) rounding must not choose the edge of the band: contact normals that turn by
/// less than this over the probe do not turn.
constexpr double levelTurn = 1e-9;

double unlessLevel(double curvature, double step) {
  return std::abs(curvature) <= levelTurn / step ? 0.0 : curvature;
}

/// Gaps around a place. The contact may jump round the cutter as the axis turns, and its normal
/// with it; at the vertex of a cone the normal is any: gaps tell how the surface that the tool end
/// keeps to lies and bends, over a way that rounding leaves enough of. The axis of each place is
/// found from that in the middle, whatever others were looked at before.
class GapsAround {
 public:
  GapsAround(Field& field, const Vec3& toolEnd, AxisRule& axis, double step)
      : field_(field),
        toolEnd_(toolEnd),
        axis_(axis),
        step_(step),
        way_(gapProbe * step),
        middle_(axis.at(toolEnd)) {
    axis_.mark();
    gap_ = field_.at(toolEnd_, middle_).gap;
  }

  [[nodiscard]] double curvature(const Vec3& t) {
    return unlessLevel((gap(way_ * t) - 2.0 * gap_ + gap(-way_ * t)) / (way_ * way_), step_);
  }
  /// Square to where the gap keeps its size.
  [[nodiscard]] Vec3 normal() {
    const tool::Contact contact = field_.at(toolEnd_, middle_);
    if (axis_.isFixed()) {
      return contact.normal;
    }
    Vec3 rise;
    for (int i = 0; i < 3; ++i) {
      const Vec3 shift = way_ * Vec3::Unit(i);
      rise[i] = (gap(shift) - gap(-shift)) / (2.0 * way_);
    }
    return rise.norm() > tolerance::nullDirection ? Vec3(rise.normalized()) : contact.normal;
  }

 private:
  [[nodiscard]] double gap(const Vec3& shift) {
    const Vec3 place = toolEnd_ + shift;
    axis_.back(toolEnd_, middle_);
    return field_.at(place, axis_.at(place)).gap;
  }

  Field& field_;
  Vec3 toolEnd_;
  AxisRule& axis_;
  double step_, way_;
  Vec3 middle_;
  double gap_;
};
}  // namespace

double curvatureAlong(
    Field& field, const Vec3& toolEnd, AxisRule& axis, const Vec3& t, double step) {
  if (!axis.isFixed()) {
    return GapsAround(field, toolEnd, axis, step).curvature(t);
  }
  const Vec3 ahead = toolEnd + step * t;
  const Vec3 behind = toolEnd - step * t;
  const Vec3 change =
      field.at(ahead, axis.at(ahead)).normal - field.at(behind, axis.at(behind)).normal;
  return unlessLevel(change.dot(t) / (2.0 * step), step);
}

namespace {
/// Distance over which curvature is measured: a share of the band, so that in other units it is as
/// far from knots and from where another place of the cutter touches.
double probe(double band) {
  return 0.2 * band;
}

/// Contact normals that turn towards the tool by this over a length as the band's are those of a
/// hollow; what turns less, but does, is met between both edges of the band, so that where a
/// surface goes over from the one to the other the stop does too. No length of its own: in other
/// units the stop is the same.
constexpr double hollowTurn = 6e-7;

/// The sum of both curvatures says how a surface bends, but that along the path how a saddle does:
/// chords lie on the other side of that. Where the path is next to level it is the sum again.
double restOf(double sum, double alongPath, double inner, double outer) {
  const double turn = (inner + outer) / hollowTurn;
  const double bends = std::min(std::abs(alongPath) * turn, 1.0);
  const double inwards =
      bends * (alongPath < 0.0 ? 1.0 : 0.0) + (1.0 - bends) * std::clamp(-sum * turn, 0.0, 1.0);
  return outer - (inner + outer) * (edgeShare + inwards * (1.0 - 2.0 * edgeShare));
}
}  // namespace

double restGap(Field& field,
               const Vec3& toolEnd,
               AxisRule& axis,
               double inner,
               double outer,
               bool exact,
               const Vec3& path) {
  if (exact || field.flat()) {
    return 0.0;
  }
  if (field.isFaceted()) {
    return restOf(0.0, 0.0, inner, outer);
  }
  const double step = probe(inner + outer);
  GapsAround gaps(field, toolEnd, axis, step);
  const auto along = [&](const Vec3& t) { return gaps.curvature(t); };
  const Vec3 normal = gaps.normal();
  const Vec3 t = normal.unitOrthogonal();
  return restOf(along(t) + along(normal.cross(t)), path.isZero() ? 0.0 : along(path), inner, outer);
}

double sideSeenOn(const Vec3& normal, const Vec3& axis, double present) {
  return present * normal.dot(axis) > tolerance::nullDirection ? present : -present;
}

std::unique_ptr<Field> onField(const surface::AnySurface& surface,
                               const Vec3& toolEnd,
                               AxisRule& axis,
                               double inner,
                               double outer) {
  auto plus = makeField(surface, 1.0, {});
  auto minus = makeField(surface, -1.0, {});
  const Vec3 a = axis.at(toolEnd);
  const tool::Contact c = plus->at(toolEnd, a);
  const double step = probe(inner + outer);
  const auto within = [&](double gap) {
    return gap >= -inner - tolerance::sameSide && gap <= outer + tolerance::sameSide;
  };
  if (within(c.gap) != within(-c.gap)) {
    return within(c.gap) ? std::move(plus) : std::move(minus);
  }
  const bool isUpright = std::abs(c.normal.dot(a)) <= tolerance::nullDirection;
  if (!isUpright || std::abs(c.gap) > tolerance::sameSide) {
    const double side = sideSeenOn(c.normal, a, c.gap < 0.0 ? -1.0 : 1.0);
    return side > 0.0 ? std::move(plus) : std::move(minus);
  }
  const Vec3 t = c.normal.unitOrthogonal();
  const double bend = curvatureAlong(*plus, toolEnd, axis, t, step) +
                      curvatureAlong(*plus, toolEnd, axis, c.normal.cross(t), step);
  return bend >= -levelTurn / step ? std::move(plus) : std::move(minus);
}

Result<NamedSurface> named(const EntityPtr& entity) {
  auto found = surface::surfaceOf(*entity);
  if (!found) {
    return found.takeFailure();
  }
  return NamedSurface{entity, *std::move(found), surface::titleOf(*entity)};
}

NamedSurface partSurface(const State& state) {
  if (state.part) {
    return *state.part;
  }
  NamedSurface xy;
  xy.name = "(XY plane)";
  xy.surface = surface::Plane{Vec3::UnitZ(), 0.0};
  return xy;
}

const tool::Profile* cutterFor(const State& state, Role role) {
  if (role <= driveRole && state.option[role]) {
    return &*state.option[role];
  }
  return state.cutter ? &*state.cutter : nullptr;
}

Vec3 sidePoint(const State& state, const Vec3& toolEnd, const Vec3& axis) {
  const double lift = state.cutter ? state.cutter->h / 2 : 0.0;
  return toolEnd + lift * axis;
}

}  // namespace arelem::motion
