// RLDSRF definitions.
#include <array>

#include <fmt/format.h>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/choice.h"
#include "runtime/define/resolve.h"
#include "runtime/geometry/ruled_surface.h"

namespace arelem::define {

using geometry::RuledSurface;
using geometry::SectionCurve;

namespace {

/// Reads surface, point, point, {point | vector} from parameter `first`. The heading is across the
/// chord: towards the third point, or along the vector.
Result<SectionCurve> readCurve(const Arguments& given, std::size_t first, int number) {
  SectionCurve curve;
  curve.surface.type = given.entity(first).type;
  curve.surface.canon = given.entity(first).canon;
  curve.start = given.point(first + 1);
  curve.finish = given.point(first + 2);
  const Vec3 chord = curve.finish - curve.start;
  if (!(chord.norm() > tolerance::ruledChord)) {
    return fail(diag::RuledEndsTooClose, number, chord.norm(), tolerance::ruledChord);
  }
  const bool isVector = given.is(first + 3, EntityType::vector);
  const Vec3 towards =
      isVector ? given.arrow(first + 3) : Vec3(given.point(first + 3) - curve.start);
  const Vec3 u = chord.normalized();
  const Vec3 across = towards - towards.dot(u) * u;
  if (!(across.norm() > tolerance::nullDirection * std::max(1.0, towards.norm()))) {
    return fail(diag::RuledPlaneUndefined, number, isVector ? "vector" : "third point",
                across.norm());
  }
  curve.heading = across.normalized();
  return curve;
}

/// The curve must exist all along its base line, and not farther from it than anything is.
Result<bool> checkCurve(const SectionCurve& curve, int number) {
  constexpr int samples = 16;
  for (int i = 0; i <= samples; ++i) {
    const double fraction = static_cast<double>(i) / samples;
    const auto place = curve.at(fraction);
    const double away = place ? (*place - curve.base(fraction)).norm() : 0.0;
    if (!place || away > tolerance::farAway) {
      return fail(diag::RuledCurveMissed, number, fraction, spell(curve.surface.type))
          .withHelp(place ? fmt::format("what it cuts is {:.6g} away; more than {:g} is too far",
                                        away, tolerance::farAway)
                          : "a plane that touches the surface, or is the surface, does not cut "
                            "it: ends that lie nearer to each other (an arc of less than half a "
                            "turn), or another vector");
    }
  }
  return true;
}

}  // namespace

Result<Resolved> ruledSurface(const Arguments& given) {
  RuledSurface surface;
  Result<SectionCurve> first = readCurve(given, 0, 1);
  if (!first) {
    return first.takeFailure();
  }
  surface.first = *std::move(first);
  if (given.count() == 5) {
    surface.second.surface.type = EntityType::point;
    surface.second.surface.canon = given.entity(4).canon;
    surface.second.start = given.point(4);
    surface.second.finish = surface.second.start;
  } else {
    Result<SectionCurve> second = readCurve(given, 4, 2);
    if (!second) {
      return second.takeFailure();
    }
    surface.second = *std::move(second);
  }
  for (const int number : {1, 2}) {
    Result<bool> exists = checkCurve(number == 1 ? surface.first : surface.second, number);
    if (!exists) {
      return exists.takeFailure();
    }
  }
  return Resolved(surface);
}

}  // namespace arelem::define
