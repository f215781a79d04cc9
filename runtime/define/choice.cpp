#include "runtime/define/choice.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"

namespace arelem::define {

Sense senseOf(Word modifier) {
  switch (modifier) {
    case Word::XLARGE:
    case Word::POSX:
      return {0, 1.0};
    case Word::XSMALL:
    case Word::NEGX:
      return {0, -1.0};
    case Word::YLARGE:
    case Word::POSY:
      return {1, 1.0};
    case Word::YSMALL:
    case Word::NEGY:
      return {1, -1.0};
    case Word::ZSMALL:
    case Word::NEGZ:
      return {2, -1.0};
    default:  // ZLARGE, POSZ: the patterns admit no other word
      return {2, 1.0};
  }
}

namespace {
std::string_view axisName(int axis) {
  return std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1);
}
}  // namespace

Result<geometry::Vec2> choose(Word modifier, const Candidates& candidates) {
  if (candidates.single) {
    return candidates.first;
  }
  const Sense sense = senseOf(modifier);
  const geometry::Vec2 apart = candidates.second - candidates.first;
  const double difference = apart(sense.axis);
  // Far from the origin the rounding of the coordinates decides nothing either.
  const double size = std::max(candidates.first.norm(), candidates.second.norm());
  if (std::abs(difference) <=
      std::max(tolerance::symmetric * apart.norm(), tolerance::rounding * size)) {
    return fail(diag::Undecided, spell(modifier), axisName(sense.axis), std::abs(difference))
        .note("one result is at " + show(candidates.first))
        .note("the other is at " + show(candidates.second));
  }
  return sense.sign * difference > 0.0 ? candidates.second : candidates.first;
}

Result<Vec3> orient(Word modifier, const Vec3& direction, double uncertainty) {
  const Sense sense = senseOf(modifier);
  const double component = direction(sense.axis);
  if (std::abs(component) <= std::max(tolerance::symmetric, uncertainty) * direction.norm()) {
    return fail(diag::NoSense, spell(modifier), axisName(sense.axis), component)
        .note("the direction is " + show(direction) + " or its reverse");
  }
  return sense.sign * component > 0.0 ? direction : Vec3(-direction);
}

std::string show(const geometry::Vec2& place) {
  return fmt::format("({:.9g}, {:.9g})", place.x(), place.y());
}

std::string show(const Vec3& place) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", place.x(), place.y(), place.z());
}

Result<Vec3> unit(const Vec3& direction, std::string_view what) {
  const double largest = direction.cwiseAbs().maxCoeff();
  if (!(largest > tolerance::nullDirection)) {
    return fail(diag::NullDirection, what, largest, tolerance::nullDirection);
  }
  return Vec3(direction / direction.norm());
}

}  // namespace arelem::define
