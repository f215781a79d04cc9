// LCONIC definitions. The conics through four places (a tangency counts twice) are the pencil
// L1 L2 + k L3 L4 = 0 of line pairs through them; the remaining place fixes k. Which place that is,
// and the form of the lines, follow routine ALFTCN, so that the coefficients are the old ones.
#include <array>
#include <cmath>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/planar.h"
#include "runtime/define/resolve.h"
#include "runtime/geometry/angle.h"

namespace arelem::define {

using geometry::Line;
using geometry::Vec2;

namespace {
/// The product of two lines, times `factor`, as canonical numbers a b c d f g h p q r.
geometry::Canon pairOf(const Line& l, const Line& m, double factor) {
  const Vec2 u = l.normal;
  const Vec2 v = m.normal;
  return {factor * u.x() * v.x(),
          factor * u.y() * v.y(),
          0.0,
          factor * l.distance * m.distance,
          0.0,
          0.0,
          factor * (u.x() * v.y() + u.y() * v.x()) / 2.0,
          -factor * (u.x() * m.distance + v.x() * l.distance) / 2.0,
          -factor * (u.y() * m.distance + v.y() * l.distance) / 2.0,
          0.0};
}

struct Pencil {
  Line l1, l2, l3, l4;
};

/// The factor that brings a line with unit normal to the old system's form: y with coefficient -1
/// where the line is flatter than 45 degrees, else a unit normal that points down, or to the right
/// for a line upwards (routine ALFTCN).
double slopeForm(const Line& line) {
  const double y = line.normal.y();
  if (std::abs(y) <= tolerance::coincidence) {
    return -1.0;
  }
  return std::abs(line.normal.x()) <= std::abs(y) ? -1.0 / y : -std::copysign(1.0, y);
}

/// The conic of the pencil through `place`. A place on one of the lines makes the conic fall apart.
/// The coefficients are scaled by the form that the old system gives to the first two lines.
Result<Resolved> conicThrough(const Pencil& pencil, const Vec2& place, int number) {
  for (const Line& line : {pencil.l1, pencil.l2, pencil.l3, pencil.l4}) {
    const double off = std::abs(line.height(place));
    if (off <= tolerance::coincidence) {
      return fail(diag::BadConic, "the given places",
                  fmt::format("point {} lies on a line through two of the others or on a tangent "
                              "({:.3g} off)",
                              number, off));
    }
  }
  const double k = -(pencil.l1.height(place) * pencil.l2.height(place)) /
                   (pencil.l3.height(place) * pencil.l4.height(place));
  const double scale = slopeForm(pencil.l1) * slopeForm(pencil.l2);
  geometry::Canon canon = pairOf(pencil.l1, pencil.l2, scale);
  const geometry::Canon second = pairOf(pencil.l3, pencil.l4, scale * k);
  for (std::size_t i = 0; i < canon.size(); ++i) {
    canon[i] += second[i];
  }
  return Resolved(std::move(canon));
}

/// The line with this slope through a place.
Line tangentAt(const Vec2& place, double slope) {
  const auto [s, c] = geometry::sinCosOfTangent(slope);
  return lineAlong(place, c, s);
}

/// The line through two places that are known to be apart.
Line joining(const Vec2& first, const Vec2& second) {
  const Vec2 u = (second - first).normalized();
  return lineAlong(first, u.x(), u.y());
}

/// Fails when two of the places coincide, or three lie on one line: then the conic is a pair of
/// lines.
Result<bool> spread(const std::vector<Vec2>& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = i + 1; j < places.size(); ++j) {
      const double apart = (places[j] - places[i]).norm();
      if (apart <= tolerance::coincidence) {
        return fail(diag::BadConic, "the given places",
                    fmt::format("points {} and {} coincide ({:.3g} apart)", i + 1, j + 1, apart));
      }
      const Line chord = joining(places[i], places[j]);
      for (std::size_t k = j + 1; k < places.size(); ++k) {
        const double off = std::abs(chord.height(places[k]));
        if (off <= tolerance::coincidence) {
          return fail(diag::BadConic, "the given places",
                      fmt::format("point {} lies on the line of points {} and {} ({:.3g} off)",
                                  k + 1, i + 1, j + 1, off));
        }
      }
    }
  }
  return true;
}

/// Fails when a place other than `touched` lies on the tangent there: the conic is a pair of lines.
Result<bool> offTangent(const std::vector<Vec2>& places, std::size_t touched, double slope) {
  const Line tangent = tangentAt(places[touched], slope);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double off = std::abs(tangent.height(places[i]));
    if (i != touched && off <= tolerance::coincidence) {
      return fail(diag::BadConic, "the given places",
                  fmt::format("point {} lies on the tangent at point {} ({:.3g} off)", i + 1,
                              touched + 1, off));
    }
  }
  return true;
}

Result<Resolved> fivePoints(const std::vector<Vec2>& p) {
  Result<bool> apart = spread(p);
  if (!apart) {
    return apart.takeFailure();
  }
  return conicThrough(
      {joining(p[0], p[1]), joining(p[3], p[4]), joining(p[0], p[3]), joining(p[1], p[4])}, p[2],
      3);
}

/// The conic touches the tangent at p0 and passes p1, p2, p3; p1 fixes it.
Result<Resolved> fourPoints(const std::vector<Vec2>& p, double slope) {
  for (Result<bool> good : std::array{spread(p), offTangent(p, 0, slope)}) {
    if (!good) {
      return good.takeFailure();
    }
  }
  return conicThrough(
      {tangentAt(p[0], slope), joining(p[2], p[3]), joining(p[0], p[2]), joining(p[0], p[3])}, p[1],
      2);
}

/// The conic touches the tangents at p0 and p1 and passes p2.
Result<Resolved> threePoints(const std::vector<Vec2>& p, double slope0, double slope1) {
  for (Result<bool> good :
       std::array{spread(p), offTangent(p, 0, slope0), offTangent(p, 1, slope1)}) {
    if (!good) {
      return good.takeFailure();
    }
  }
  const Line chord = joining(p[0], p[1]);
  return conicThrough({tangentAt(p[0], slope0), tangentAt(p[1], slope1), chord, chord}, p[2], 3);
}
}  // namespace

Result<Resolved> conicOfFiveCoordinatePairs(const Arguments& given) {
  return fivePoints({given.pair(1), given.pair(3), given.pair(5), given.pair(7), given.pair(9)});
}

Result<Resolved> conicOfFivePoints(const Arguments& given) {
  return fivePoints({given.pointInXy(1), given.pointInXy(2), given.pointInXy(3), given.pointInXy(4),
                     given.pointInXy(5)});
}

Result<Resolved> conicOfFourCoordinatePairs(const Arguments& given) {
  return fourPoints({given.pair(1), given.pair(4), given.pair(6), given.pair(8)}, given.scalar(3));
}

Result<Resolved> conicOfFourPoints(const Arguments& given) {
  return fourPoints(
      {given.pointInXy(1), given.pointInXy(3), given.pointInXy(4), given.pointInXy(5)},
      given.scalar(2));
}

Result<Resolved> conicOfThreeCoordinatePairs(const Arguments& given) {
  return threePoints({given.pair(1), given.pair(4), given.pair(7)}, given.scalar(3),
                     given.scalar(6));
}

Result<Resolved> conicOfThreePoints(const Arguments& given) {
  return threePoints({given.pointInXy(1), given.pointInXy(3), given.pointInXy(5)}, given.scalar(2),
                     given.scalar(4));
}

}  // namespace arelem::define
