#include "runtime/geometry/ruled_surface.h"

#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::geometry {

std::optional<Vec3> SectionCurve::at(double fraction) const {
  if (isPoint()) {
    return start;
  }
  // End points are typed with few digits: begin a little below the base line so that a place of the
  // surface at the base line itself counts as ahead.
  const double slack = 100.0 * tolerance::coincidence;
  const Vec3 from = base(fraction) - slack * heading;
  const std::optional<double> s =
      directedDistance(surface, from, heading, Crossing::aheadElseNearest);
  return s ? std::optional<Vec3>(from + *s * heading) : std::nullopt;
}

std::optional<Vec3> SectionCurve::derivative(const Vec3& place) const {
  if (isPoint()) {
    return Vec3::Zero();
  }
  // place = base + s heading stays on the surface: n.(base' + s' heading) = 0
  const std::optional<Vec3> normal = unitNormal(surface, place);
  if (!normal || std::abs(normal->dot(heading)) <= tolerance::symmetric) {
    return std::nullopt;
  }
  const Vec3 chord = finish - start;
  return chord - normal->dot(chord) / normal->dot(heading) * heading;
}

std::optional<RuledPoint> RuledSurface::at(double f, double g) const {
  const std::optional<Vec3> one = first.at(f);
  const std::optional<Vec3> two = second.at(f);
  if (!one || !two) {
    return std::nullopt;
  }
  const std::optional<Vec3> oneByF = first.derivative(*one);
  const std::optional<Vec3> twoByF = second.derivative(*two);
  if (!oneByF || !twoByF) {
    return std::nullopt;
  }
  return RuledPoint{(1.0 - g) * *one + g * *two, (1.0 - g) * *oneByF + g * *twoByF, *two - *one,
                    *twoByF - *oneByF};
}

std::optional<Vec3> RuledSurface::normal(double f, double g) const {
  const std::optional<RuledPoint> point = at(f, g);
  if (!point) {
    return std::nullopt;
  }
  const Vec3 across = point->byF.cross(point->byG);
  const double length = across.norm();
  return length > 0.0 ? std::optional<Vec3>(across / length) : std::nullopt;
}

namespace {
void append(Canon& to, EntityType type, const Canon& values) {
  to.push_back(static_cast<double>(type));
  to.push_back(static_cast<double>(values.size()));
  to.insert(to.end(), values.begin(), values.end());
}

void append(Canon& to, const SectionCurve& curve) {
  if (curve.isPoint()) {
    append(to, EntityType::point, Point{curve.start}.canon());
    return;
  }
  append(to, curve.surface.type, curve.surface.canon);
  append(to, EntityType::point, Point{curve.start}.canon());
  append(to, EntityType::point, Point{curve.finish}.canon());
  append(to, EntityType::vector, Direction{curve.heading}.canon());
}

SectionCurve readCurve(std::span<const double> canon, std::size_t& next) {
  const auto triple = [&] {
    const std::optional<SubForm> form = readSubForm(canon, next);
    return form ? Direction::of(form->canon).components : Vec3(Vec3::Zero());
  };
  SectionCurve curve;
  const std::size_t begin = next;
  if (const std::optional<SubForm> form = readSubForm(canon, next)) {
    curve.surface.type = form->type;
    curve.surface.canon = form->canon;
  }
  if (curve.isPoint()) {
    next = begin;
    curve.start = triple();
    curve.finish = curve.start;
    return curve;
  }
  curve.start = triple();
  curve.finish = triple();
  curve.heading = triple();
  return curve;
}
}  // namespace

std::optional<SubForm> readSubForm(std::span<const double> canon, std::size_t& next) {
  if (next + 2 > canon.size() || !(canon[next] >= 1.0 && canon[next] < 64.0) ||
      !(canon[next + 1] >= 0.0)) {
    return std::nullopt;
  }
  const auto type = static_cast<EntityType>(canon[next]);
  if (canon[next + 1] > static_cast<double>(canon.size() - next - 2)) {
    return std::nullopt;
  }
  const auto count = static_cast<std::size_t>(canon[next + 1]);
  const int wanted = canonicalCount(type);
  if (wanted != 0 && count != static_cast<std::size_t>(wanted)) {
    return std::nullopt;
  }
  const auto values = canon.subspan(next + 2, count);
  next += 2 + count;
  return SubForm{type, Canon(values.begin(), values.end())};
}

RuledSurface RuledSurface::of(std::span<const double> canon) {
  std::size_t next = 0;
  RuledSurface result;
  result.first = readCurve(canon, next);
  result.second = readCurve(canon, next);
  return result;
}

Canon RuledSurface::canon() const {
  Canon result;
  append(result, first);
  append(result, second);
  return result;
}

}  // namespace arelem::geometry
