// POINT, LINE and CIRCLE definitions that refer to a TABCYL.
#include <cmath>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/planar.h"
#include "runtime/define/resolve.h"
#include "runtime/define/tabcyl_place.h"

namespace arelem::define {

using geometry::Line;
using geometry::Vec2;

namespace {

Failure nothingFound(const CurveInXy& curve, std::string_view condition, const Vec2& nearPoint) {
  Vec2 closest = curve.intervals().front().start;
  for (const auto& interval : curve.intervals()) {
    if ((interval.start - nearPoint).norm() < (closest - nearPoint).norm()) {
      closest = interval.start;
    }
  }
  return fail(diag::NoPlaceOnCurve, "TABCYL", condition, show(closest))
      .note("near point " + show(nearPoint));
}

/// The line from a place to a place of the curve. Where they coincide it has the direction
/// `otherwise`.
Result<Resolved> joinedLine(const Vec2& from, const Vec2& to, const Vec2& otherwise) {
  const Vec2 step = to - from;
  const Vec2 u = (step.norm() > tolerance::coincidence ? step : otherwise).normalized();
  return Resolved(lineWithNormal(from, {u.y(), -u.x()}));
}

}  // namespace

Result<Resolved> pointOfLineAndTabcyl(const Arguments& given) {
  Result<CurveInXy> curve = CurveInXy::of(given.entity(2));
  if (!curve) {
    return curve.takeFailure();
  }
  const std::optional<CurvePlace> place =
      curve->select(curve->onLine(given.line(1)), given.pointInXy(3));
  if (!place) {
    return nothingFound(*curve, "lies on the line", given.pointInXy(3));
  }
  return Resolved(geometry::Point{given.onZsurf(place->at.place)});
}

Result<Resolved> lineTangentToTabcyl(const Arguments& given) {
  Result<CurveInXy> curve = CurveInXy::of(given.entity(2));
  if (!curve) {
    return curve.takeFailure();
  }
  const Vec2 from = given.pointInXy(0);
  const Vec2 nearPoint = given.count() == 4 ? given.pointInXy(3) : from;
  const std::optional<CurvePlace> place = curve->select(curve->tangentThrough(from), nearPoint);
  if (!place) {
    return nothingFound(*curve, "has a tangent through the point", nearPoint);
  }
  return joinedLine(from, place->at.place, place->at.tangent);
}

Result<Resolved> lineNormalToTabcyl(const Arguments& given) {
  Result<CurveInXy> curve = CurveInXy::of(given.entity(2));
  if (!curve) {
    return curve.takeFailure();
  }
  const Vec2 from = given.pointInXy(0);
  const std::optional<CurvePlace> place =
      curve->select(curve->normalThrough(from), given.pointInXy(3));
  if (!place) {
    return nothingFound(*curve, "has a normal through the point", given.pointInXy(3));
  }
  const Vec2 tangent = place->at.tangent;
  return joinedLine(from, place->at.place, {-tangent.y(), tangent.x()});
}

namespace {
/// The places of the curve whose offset by `radius` to the left (side +1) or right lies on the line
/// of centers, with the displacement on the modifier's side. The offset of a cubic is no
/// polynomial: sign changes of the height over equal parts of the interval are bisected.
class OffsetSearch {
 public:
  OffsetSearch(const CurveInXy& curve, const Line& centers, double radius, Sense sense)
      : curve_(curve), centers_(centers), radius_(radius), sense_(sense) {}

  std::vector<CurvePlace> run() {
    for (std::size_t i = 0; i < curve_.intervals().size(); ++i) {
      for (const double side : {1.0, -1.0}) {
        search(i, side);
      }
    }
    return std::move(found_);
  }

  [[nodiscard]] static Vec2 leftNormal(const CurvePlace& place) {
    const Vec2 u = place.at.tangent.normalized();
    return {-u.y(), u.x()};
  }
  /// The normal on the modifier's side.
  [[nodiscard]] Vec2 sidedNormal(const CurvePlace& place) const {
    const Vec2 n = leftNormal(place);
    return sense_.sign * n(sense_.axis) >= 0.0 ? n : Vec2(-n);
  }

 private:
  [[nodiscard]] double height(std::size_t interval, double t, double side) const {
    const CurvePlace place = curve_.place(interval, t);
    return centers_.height(place.at.place + side * radius_ * leftNormal(place));
  }

  void search(std::size_t interval, double side) {
    constexpr int parts = 64;
    const double length = curve_.intervals()[interval].length;
    double low = 0.0;
    double atLow = height(interval, low, side);
    for (int k = 1; k <= parts; ++k) {
      const double high = length * k / parts;
      const double atHigh = height(interval, high, side);
      if ((atLow < 0.0) != (atHigh < 0.0)) {
        keep(interval, refine(interval, side, low, high, atLow < 0.0), side);
      }
      low = high;
      atLow = atHigh;
    }
  }

  [[nodiscard]] double refine(
      std::size_t interval, double side, double low, double high, bool rising) const {
    for (int step = 0; step < 100; ++step) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) {
        break;
      }
      ((height(interval, middle, side) < 0.0) == rising ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  void keep(std::size_t interval, double t, double side) {
    const CurvePlace place = curve_.place(interval, t);
    if (side * sense_.sign * leftNormal(place)(sense_.axis) > tolerance::symmetric) {
      found_.push_back(place);
    }
  }

  const CurveInXy& curve_;
  const Line& centers_;
  double radius_;
  Sense sense_;
  std::vector<CurvePlace> found_;
};
}  // namespace

Result<Resolved> circleTangentToLineAndTabcyl(const Arguments& given) {
  Result<double> radius = positiveRadius(given.scalar(7));
  if (!radius) {
    return radius.takeFailure();
  }
  Result<CurveInXy> curve = CurveInXy::of(given.entity(3));
  if (!curve) {
    return curve.takeFailure();
  }
  Result<Line> centers = offset(given.line(1), given.word(2), *radius);
  if (!centers) {
    return centers.takeFailure();
  }
  OffsetSearch search(*curve, *centers, *radius, senseOf(given.word(4)));
  const std::optional<CurvePlace> place = curve->select(search.run(), given.pointInXy(5));
  if (!place) {
    return nothingFound(
        *curve,
        fmt::format("is {:.9g} from a center on the {} side that is as far from the line", *radius,
                    spell(given.word(4))),
        given.pointInXy(5));
  }
  const Vec2 center = place->at.place + *radius * search.sidedNormal(*place);
  return Resolved(geometry::Circle{{center.x(), center.y(), 0.0}, *radius});
}

}  // namespace arelem::define
