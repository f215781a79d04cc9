// CANON forms: canonical numbers as input, and copies of an entity with some numbers replaced.
#include "runtime/define/canonical.h"

#include <cmath>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/choice.h"
#include "runtime/define/resolve.h"
#include "runtime/geometry/polyconic.h"
#include "runtime/geometry/ruled_surface.h"
#include "runtime/geometry/tabulated_cylinder.h"
#include "runtime/geometry/triangle_mesh.h"
#include "runtime/region/region.h"
#include "runtime/spline/cubic.h"

namespace arelem::define {

using geometry::Canon;

namespace {

std::size_t expectedCount(EntityType type) {
  return type == EntityType::polyconic ? geometry::Polyconic::canonicalCount
                                       : static_cast<std::size_t>(canonicalCount(type));
}

/// The three numbers from `first` are a direction; its length need not be 1 (typed views divide by
/// it).
Result<bool> requireDirection(EntityType type, const Canon& canon, std::size_t first) {
  const Vec3 direction(canon[first], canon[first + 1], canon[first + 2]);
  const double largest = direction.cwiseAbs().maxCoeff();
  if (!(largest > tolerance::nullDirection)) {
    return fail(diag::NullDirection, spell(type), largest, tolerance::nullDirection);
  }
  return true;
}

Result<bool> require(
    EntityType type, const Canon& canon, std::size_t index, bool good, std::string_view rule) {
  if (!good) {
    return fail(diag::BadCanonicalValue, spell(type), index + 1, canon[index], rule);
  }
  return true;
}

Result<bool> checkCircle(EntityType type, const Canon& canon) {
  for (const std::size_t index : {std::size_t{3}, std::size_t{4}}) {
    Result<bool> zero =
        require(type, canon, index, canon[index] == 0.0, "0: the axis of a circle is z");
    if (!zero) {
      return zero;
    }
  }
  Result<bool> axis =
      require(type, canon, 5, std::abs(canon[5]) == 1.0, "1: the axis of a circle is z");
  return axis ? require(type, canon, 6, canon[6] > 0.0, "greater than 0") : std::move(axis);
}

/// n, k and the counts of a TABCYL agree, its frame is orthonormal, its chords have the given
/// lengths.
Result<bool> checkTabulated(const Canon& canon) {
  constexpr EntityType type = EntityType::tabulatedCylinder;
  const double n = canon[0];
  Result<bool> good = require(
      type, canon, 0, n >= 2.0 && n == std::floor(n) && n <= static_cast<double>(canon.size()),
      "a whole number from 2");
  if (!good) {
    return good;
  }
  const std::size_t count = geometry::tabulatedCylinderCount(static_cast<std::size_t>(n));
  if (canon.size() != count) {
    return fail(diag::WrongCanonicalCount, spell(type), canon.size(),
                fmt::format("{} for n = {}", count, n));
  }
  const geometry::TabulatedCylinder surface = geometry::TabulatedCylinder::of(canon);
  const Eigen::Matrix3d rest =
      surface.frame * surface.frame.transpose() - Eigen::Matrix3d::Identity();
  good = require(type, canon, 2, rest.cwiseAbs().maxCoeff() <= tolerance::perpendicular,
                 "the first number of three perpendicular unit vectors");
  for (std::size_t i = 0; good && i < surface.intervals.size(); ++i) {
    const geometry::Vec2 next =
        i + 1 < surface.intervals.size() ? surface.intervals[i + 1].start : surface.end;
    const double length = (next - surface.intervals[i].start).norm();
    good = require(type, canon, 15 + 7 * i,
                   length > 0.0 && std::abs(canon[15 + 7 * i] - length) <= tolerance::coincidence,
                   "the distance to the next point");
  }
  return good;
}

/// The sub-forms are those of one or two curves (the second may be a point), each good by itself.
Result<bool> checkRuled(const Canon& canon) {
  constexpr EntityType type = EntityType::ruledSurface;
  std::vector<EntityType> types;
  std::size_t next = 0;
  while (next < canon.size()) {
    const std::size_t begin = next;
    std::optional<geometry::SubForm> form = geometry::readSubForm(canon, next);
    if (!form || form->type == type) {
      return fail(diag::BadCanonicalValue, spell(type), begin + 1, canon[begin],
                  "the type code of a sub-form, followed by its number of values and the values");
    }
    Result<Canon> good = checkedCanon(form->type, std::move(form->canon));
    if (!good) {
      return good.takeFailure();
    }
    types.push_back(form->type);
  }
  using T = EntityType;
  const auto isCurve = [&](std::size_t i) {
    return i + 3 < types.size() && types[i] != T::point && types[i + 1] == T::point &&
           types[i + 2] == T::point && types[i + 3] == T::vector;
  };
  const bool two = types.size() == 8 && isCurve(0) && isCurve(4);
  const bool one = types.size() == 5 && isCurve(0) && types[4] == T::point;
  if (!two && !one) {
    return fail(diag::WrongCanonicalCount, spell(type), types.size(),
                "the sub-forms surface, point, point, vector and the same again or a point");
  }
  return true;
}

/// The matrix turns (or mirrors) without scaling, and the functions make a surface.
Result<bool> checkPolyconic(const Canon& canon) {
  constexpr EntityType type = EntityType::polyconic;
  Result<bool> good = require(type, canon, 0, canon[0] == 1.0 || canon[0] == 2.0,
                              "1, or 2 where there are square roots");
  good = good ? require(type, canon, 15, canon[15] > 0.0, "greater than 0") : std::move(good);
  if (!good) {
    return good;
  }
  const geometry::Polyconic surface = geometry::Polyconic::of(canon);
  const Eigen::Matrix3d rest =
      surface.rows * surface.rows.transpose() - Eigen::Matrix3d::Identity();
  good = require(type, canon, 1, rest.cwiseAbs().maxCoeff() <= tolerance::perpendicular,
                 "the first number of a matrix of three perpendicular unit vectors, each with a "
                 "shift behind it, or the first of twelve zeros");
  if (!good) {
    return good;
  }
  if (const auto fault = geometry::faultOf(surface)) {
    return fault->shoulder ? fail(diag::PolyconicShoulder, fault->value, fault->d)
                           : fail(diag::PolyconicFlat, fault->value, fault->d);
  }
  return true;
}

Result<bool> checkGun(const Canon& canon) {
  const bool sized = canon.size() >= 13 && canon.size() % 2 == 1;
  const bool sane = sized && canon[0] >= 1.0 && canon[0] <= 5.0 && canon[1] >= 0.0 &&
                    canon[2] > 0.0 && canon[5] > 0.0 && canon[5] <= 1.0 && canon[7] >= 1.0;
  if (!sane || (canon[0] == 5.0) != (canon.size() >= 17)) {
    return fail(diag::WrongCanonicalCount, "GUN", canon.size(), "the numbers of another gun");
  }
  return true;
}

Result<bool> checkRegion(const Canon& canon) {
  if (!region::Region::readable(canon)) {
    return fail(diag::WrongCanonicalCount, "REGION", canon.size(), "the numbers of another region");
  }
  return true;
}

Result<bool> checkRevolved(const Canon& canon) {
  if (canon.size() < 8 + geometry::tabulatedCylinderCount(2)) {
    return fail(diag::WrongCanonicalCount, "REVOLV", canon.size(),
                fmt::format("at least {}", 8 + geometry::tabulatedCylinderCount(2)));
  }
  return checkTabulated({canon.begin() + 8, canon.end()});
}

Result<bool> check(EntityType type, const Canon& canon) {
  Result<bool> good = true;
  switch (type) {
    case EntityType::circle:
      return checkCircle(type, canon);
    case EntityType::cylinder:
      good = require(type, canon, 6, canon[6] > 0.0, "greater than 0");
      return good ? requireDirection(type, canon, 3) : std::move(good);
    case EntityType::cone:
      good = require(type, canon, 6, canon[6] > 0.0 && canon[6] < 1.0,
                     "a cosine between 0 and 1, ends excluded");
      return good ? requireDirection(type, canon, 3) : std::move(good);
    case EntityType::sphere:
      return require(type, canon, 3, canon[3] > 0.0, "greater than 0");
    case EntityType::torus:
      good = require(type, canon, 6, canon[6] > 0.0, "greater than 0");
      good = good ? require(type, canon, 7, canon[7] > 0.0, "greater than 0") : std::move(good);
      return good ? requireDirection(type, canon, 3) : std::move(good);
    case EntityType::tabulatedCylinder:
      return checkTabulated(canon);
    case EntityType::ruledSurface:
      return checkRuled(canon);
    case EntityType::polyconic:
      return checkPolyconic(canon);
    case EntityType::gun:
      return checkGun(canon);
    case EntityType::region:
      return checkRegion(canon);
    case EntityType::revolved:
      return checkRevolved(canon);
    case EntityType::pathSpline: {
      const Result<spline::CubicSpline> curve = spline::CubicSpline::of(canon);
      return curve ? Result<bool>(true) : Result<bool>(curve.failure());
    }
    default:  // any numbers: programs also use LINE/CANON to keep four numbers
      return good;
  }
}

}  // namespace

Result<Canon> checkedCanon(EntityType type, Canon canon) {
  const std::size_t count = expectedCount(type);
  if (count != 0 && canon.size() != count) {
    return fail(diag::WrongCanonicalCount, spell(type), canon.size(), std::to_string(count));
  }
  if (type == EntityType::pattern && (canon.empty() || canon.size() % 3 != 0)) {
    return fail(diag::WrongCanonicalCount, spell(type), canon.size(), "three for each point");
  }
  if (type == EntityType::tabulatedCylinder && canon.size() < geometry::tabulatedCylinderCount(2)) {
    return fail(diag::WrongCanonicalCount, spell(type), canon.size(),
                fmt::format("at least {}", geometry::tabulatedCylinderCount(2)));
  }
  if (type == EntityType::mesh) {
    Result<geometry::TriangleMesh> mesh = geometry::meshOfCanon(canon);
    return mesh ? Result<Canon>(mesh->canon()) : Result<Canon>(mesh.takeFailure());
  }
  Result<bool> good = check(type, canon);
  if (!good) {
    return good.takeFailure();
  }
  return canon;
}

namespace {
Result<Resolved> checkedResult(const Arguments& given, Canon canon, PatternShape pattern) {
  Result<Canon> checked = checkedCanon(given.type(), std::move(canon));
  if (!checked) {
    return checked.takeFailure();
  }
  return Resolved(*std::move(checked), pattern);
}
}  // namespace

Result<Resolved> canonicalInput(const Arguments& given) {
  Canon canon;
  for (std::size_t i = 1; i < given.count(); ++i) {
    canon.push_back(given.scalar(i));
  }
  return checkedResult(given, std::move(canon), {PatternShape::Kind::random, 1});
}

Result<Resolved> canonicalCopy(const Arguments& given) {
  const Entity& original = given.entity(0);
  if (original.type != given.type()) {
    return fail(diag::WrongCanonicalType, spell(given.type()), spell(original.type));
  }
  Canon canon = original.canon;
  const std::size_t values = given.count() - 2;
  if (values > canon.size()) {
    return fail(diag::WrongCanonicalCount, spell(given.type()), values,
                std::to_string(canon.size()));
  }
  bool replaced = false;
  for (std::size_t i = 0; i < values; ++i) {
    if (given.isScalar(i + 2)) {
      canon[i] = given.scalar(i + 2);
      replaced = true;
    }
  }
  if (!replaced) {
    return Resolved(std::move(canon), original.pattern);
  }
  return checkedResult(given, std::move(canon), original.pattern);
}

}  // namespace arelem::define
