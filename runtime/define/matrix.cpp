// MATRIX definitions, product and inverse. p_base = M p_local; the right factor of a product acts
// first.
#include <cmath>

#include <Eigen/LU>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/choice.h"
#include "runtime/define/resolve.h"
#include "runtime/geometry/angle.h"

namespace arelem::define {

using geometry::Matrix;
using geometry::SinCos;

namespace {
Matrix rotation(Word plane, double degrees) {
  const auto [s, c] = geometry::sinCosDegrees(degrees);
  Matrix result;
  if (plane == Word::XYROT) {
    result.linear << c, -s, 0, s, c, 0, 0, 0, 1;
  } else if (plane == Word::YZROT) {
    result.linear << 1, 0, 0, 0, c, -s, 0, s, c;
  } else {
    result.linear << c, 0, s, 0, 1, 0, -s, 0, c;
  }
  return result;
}

/// Reads the factor that begins at parameter `next` and moves `next` behind it.
Matrix readFactor(const Arguments& given, std::size_t& next) {
  const std::size_t first = next;
  if (given.isEntity(first)) {
    next = first + 1;
    return given.matrix(first);
  }
  if (given.is(first, Word::TRANSL)) {
    const bool hasZ = given.isScalar(first + 3);
    next = first + (hasZ ? 4 : 3);
    return {
        Eigen::Matrix3d::Identity(),
        {given.scalar(first + 1), given.scalar(first + 2), hasZ ? given.scalar(first + 3) : 0.0}};
  }
  next = first + 2;
  if (given.is(first, Word::SCALE)) {
    return {Eigen::Matrix3d::Identity() * given.scalar(first + 1), Vec3::Zero()};
  }
  return rotation(given.word(first), given.scalar(first + 1));
}

/// x' = x - 2 n (n.x - d)
Matrix mirror(const Vec3& normal, double distance) {
  return {Eigen::Matrix3d::Identity() - 2.0 * normal * normal.transpose(), 2.0 * distance * normal};
}

Result<Matrix> inverseOf(const Matrix& matrix) {
  const double determinant = matrix.linear.determinant();
  const double size = matrix.linear.rowwise().norm().prod();
  if (!(std::abs(determinant) > tolerance::rounding * size)) {
    return fail(diag::NoInverse, determinant);
  }
  const Eigen::Matrix3d inverse = matrix.linear.inverse();
  return Matrix{inverse, -(inverse * matrix.translation)};
}
}  // namespace

Result<Resolved> matrixOfCoefficients(const Arguments& given) {
  geometry::Canon canon;
  for (std::size_t i = 0; i < given.count(); ++i) {
    canon.push_back(given.scalar(i));
  }
  return Resolved(std::move(canon));
}

Result<Resolved> matrixOfFactors(const Arguments& given) {
  std::size_t next = 0;
  Matrix result = readFactor(given, next);
  while (next < given.count()) {
    result = result * readFactor(given, next);
  }
  return Resolved(result);
}

Result<Resolved> matrixInTimeOrder(const Arguments& given) {
  std::size_t next = 0;
  const Matrix first = readFactor(given, next);
  const Matrix second = readFactor(given, next);
  return Resolved(second * first);
}

Result<Resolved> matrixInverse(const Arguments& given) {
  Result<Matrix> result = inverseOf(given.matrix(1));
  if (!result) {
    return result.takeFailure();
  }
  return Resolved(*result);
}

Result<Resolved> matrixOfPlanes(const Arguments& given) {
  Matrix result;
  for (int i = 0; i < 3; ++i) {
    const geometry::Plane plane = given.plane(static_cast<std::size_t>(i));
    for (int j = 0; j < i; ++j) {
      const double cosine = result.linear.col(j).dot(plane.normal);
      if (std::abs(cosine) > tolerance::perpendicular) {
        return fail(diag::NotPerpendicular, j + 1, i + 1, cosine);
      }
    }
    result.linear.col(i) = plane.normal;
    result.translation += plane.distance * plane.normal;
  }
  return Resolved(result);
}

Result<Resolved> matrixOfVectors(const Arguments& given) {
  Result<Vec3> x = unit(given.arrow(1), "the first vector");
  if (!x) {
    return x.takeFailure();
  }
  Result<Vec3> side = unit(given.arrow(2), "the second vector");
  if (!side) {
    return side.takeFailure();
  }
  const Vec3 normal = x->cross(*side);
  if (normal.norm() <= tolerance::singular) {
    return fail(diag::Parallel, "the vectors", normal.norm(), "plane");
  }
  const Vec3 z = normal.normalized();
  Matrix result;
  result.linear.col(0) = *x;
  result.linear.col(1) = z.cross(*x);
  result.linear.col(2) = z;
  result.translation = given.point(0);
  return Resolved(result);
}

Result<Resolved> matrixMirrorInCoordinatePlanes(const Arguments& given) {
  Matrix result;
  for (std::size_t i = 1; i < given.count(); ++i) {
    const int axis = given.is(i, Word::XYPLAN) ? 2 : given.is(i, Word::YZPLAN) ? 0 : 1;
    result.linear(axis, axis) = -result.linear(axis, axis);
  }
  return Resolved(result);
}

Result<Resolved> matrixMirror(const Arguments& given) {
  const geometry::Plane plane = given.plane(1);
  return Resolved(mirror(plane.normal, plane.distance));
}

std::vector<double> product(std::span<const double, 12> left, std::span<const double, 12> right) {
  return (Matrix::of(left) * Matrix::of(right)).canon();
}

Result<std::vector<double>> inverse(std::span<const double, 12> matrix) {
  Result<Matrix> result = inverseOf(Matrix::of(matrix));
  if (!result) {
    return result.takeFailure();
  }
  return result->canon();
}

}  // namespace arelem::define
