// An entity seen from another reference system: p' = A p + t.
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/define.h"
#include "runtime/geometry/built.h"
#include "runtime/geometry/shapes.h"
#include "runtime/region/region.h"
#include "runtime/geometry/triangle_mesh.h"

namespace arelem::define {

using geometry::Matrix;

namespace {

using Form = std::pair<EntityType, geometry::Canon>;

/// The factor by which a similarity (rotation, mirror, uniform scale) enlarges lengths.
Result<double> scaleOf(const Matrix& m, EntityType type) {
  const Eigen::Matrix3d gram = m.linear.transpose() * m.linear;
  const double mean = gram.trace() / 3.0;
  const Eigen::Matrix3d rest = gram - mean * Eigen::Matrix3d::Identity();
  if (!(mean > 0.0) || rest.cwiseAbs().maxCoeff() > tolerance::similarity * mean) {
    const Vec3 squares = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(gram).eigenvalues();
    return fail(diag::NotSimilar, spell(type), std::sqrt(std::max(squares(0), 0.0)),
                std::sqrt(std::max(squares(2), 0.0)));
  }
  return std::sqrt(mean);
}

Result<Eigen::Matrix3d> inverseLinear(const Matrix& m) {
  const double determinant = m.linear.determinant();
  if (!(std::abs(determinant) > tolerance::rounding * m.linear.rowwise().norm().prod())) {
    return fail(diag::NoInverse, determinant);
  }
  return Eigen::Matrix3d(m.linear.inverse());
}

/// n.p = d and p = B (p' - t) with B the inverse of A: (B' n).p' = d + (B' n).t
Result<Form> movePlane(const Entity& entity, const Matrix& m) {
  Result<Eigen::Matrix3d> inverse = inverseLinear(m);
  if (!inverse) {
    return inverse.takeFailure();
  }
  const geometry::Plane plane = geometry::Plane::of(entity.canon);
  const Vec3 raw = inverse->transpose() * plane.normal;
  const double length = raw.norm();
  geometry::Plane moved{raw / length, (plane.distance + raw.dot(m.translation)) / length};
  const bool vertical = std::abs(moved.normal.z()) <= tolerance::symmetric;
  if (entity.type == EntityType::line && vertical) {
    return Form{EntityType::line,
                geometry::Line{moved.normal.head<2>().normalized(), moved.distance}.canon()};
  }
  return Form{EntityType::plane, moved.canon()};
}

Result<Form> moveCylinder(const Entity& entity, const Matrix& m) {
  Result<double> scale = scaleOf(m, entity.type);
  if (!scale) {
    return scale.takeFailure();
  }
  const auto cylinder = geometry::Cylinder::of(entity.canon);
  const Vec3 axis = (m.linear * cylinder.axis) / *scale;
  const Vec3 point = m.apply(cylinder.point);
  const double radius = *scale * cylinder.radius;
  if (entity.type == EntityType::circle && axis.head<2>().norm() <= tolerance::symmetric) {
    return Form{EntityType::circle, geometry::Circle{point, radius}.canon()};
  }
  return Form{EntityType::cylinder, geometry::Cylinder{point, axis.normalized(), radius}.canon()};
}

Result<Form> moveCone(const Entity& entity, const Matrix& m) {
  Result<double> scale = scaleOf(m, entity.type);
  if (!scale) {
    return scale.takeFailure();
  }
  const auto cone = geometry::Cone::of(entity.canon);
  const Vec3 axis = (m.linear * cone.axis).normalized();
  return Form{entity.type, geometry::Cone{m.apply(cone.vertex), axis, cone.cosine}.canon()};
}

Result<Form> moveSphere(const Entity& entity, const Matrix& m) {
  Result<double> scale = scaleOf(m, entity.type);
  if (!scale) {
    return scale.takeFailure();
  }
  const auto sphere = geometry::Sphere::of(entity.canon);
  return Form{entity.type,
              geometry::Sphere{m.apply(sphere.center), *scale * sphere.radius}.canon()};
}

Result<Form> moveTorus(const Entity& entity, const Matrix& m) {
  Result<double> scale = scaleOf(m, entity.type);
  if (!scale) {
    return scale.takeFailure();
  }
  const auto torus = geometry::Torus::of(entity.canon);
  const Vec3 axis = (m.linear * torus.axis).normalized();
  return Form{entity.type, geometry::Torus{m.apply(torus.center), axis, *scale * torus.major,
                                           *scale * torus.minor}
                               .canon()};
}

/// Q' = M^-T Q M^-1. A conic that is no longer a cylinder along z becomes a QADRIC.
Result<Form> moveQuadric(const Entity& entity, const Matrix& m) {
  Result<Eigen::Matrix3d> inverse = inverseLinear(m);
  if (!inverse) {
    return inverse.takeFailure();
  }
  Eigen::Matrix4d back = Eigen::Matrix4d::Identity();
  back.topLeftCorner<3, 3>() = *inverse;
  back.topRightCorner<3, 1>() = -(*inverse * m.translation);
  geometry::Quadric quadric = geometry::Quadric::of(entity.canon);
  quadric.matrix = back.transpose() * quadric.matrix * back;
  const double size = quadric.matrix.topLeftCorner<3, 3>().cwiseAbs().maxCoeff();
  const bool alongZ =
      m.linear.col(2).head<2>().norm() <= tolerance::symmetric * m.linear.col(2).norm();
  if (entity.type != EntityType::quadric && alongZ && size > 0.0) {
    quadric.matrix.row(2).setZero();
    quadric.matrix.col(2).setZero();
    return Form{entity.type, quadric.canon()};
  }
  return Form{EntityType::quadric, quadric.canon()};
}

Form movePoints(const Entity& entity, const Matrix& m) {
  geometry::Canon canon;
  for (std::size_t i = 0; i + 2 < entity.canon.size(); i += 3) {
    const Vec3 moved = m.apply({entity.canon[i], entity.canon[i + 1], entity.canon[i + 2]});
    canon.insert(canon.end(), moved.begin(), moved.end());
  }
  return {entity.type, std::move(canon)};
}

/// The normal is turned as a plane's is, every corner moves.
Result<Form> moveRegion(const Entity& entity, const Matrix& m) {
  Result<Eigen::Matrix3d> inverse = inverseLinear(m);
  if (!inverse) {
    return inverse.takeFailure();
  }
  region::Region moved = region::Region::of(entity.canon);
  moved.normal = (inverse->transpose() * moved.normal).normalized();
  for (region::Corners& loop : moved.loops) {
    for (Vec3& corner : loop) {
      corner = m.apply(corner);
    }
  }
  return Form{entity.type, moved.canon()};
}

/// A matrix that mirrors turns the triangles over, so that their normals keep their side.
Form moveMesh(const Entity& entity, const Matrix& m) {
  geometry::TriangleMesh mesh = geometry::TriangleMesh::of(entity.canon);
  for (Vec3& v : mesh.vertices) {
    v = m.apply(v);
  }
  if (m.linear.determinant() < 0.0) {
    for (auto& t : mesh.triangles) {
      std::swap(t[1], t[2]);
    }
  }
  return {entity.type, mesh.canon()};
}

/// The knots stay, the control points move.
Form moveSpline(const Entity& entity, const Matrix& m) {
  geometry::Canon canon = entity.canon;
  const auto points = static_cast<std::size_t>(canon[1]);
  for (std::size_t i = canon.size() - 3 * points; i + 2 < canon.size(); i += 3) {
    const Vec3 moved = m.apply({canon[i], canon[i + 1], canon[i + 2]});
    std::copy(moved.begin(), moved.end(), canon.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return {entity.type, std::move(canon)};
}

Failure refuse(EntityType type) {
  return fail(diag::NotTransformable, spell(type),
              type == EntityType::tabulatedCylinder
                  ? "give TRFORM in its definition"
                  : "define it in the system in which it is used");
}

Result<Form> move(const Entity& entity, const Matrix& m) {
  switch (entity.type) {
    case EntityType::point:
    case EntityType::pattern:
      return movePoints(entity, m);
    case EntityType::vector:
      return Form{
          entity.type,
          geometry::Direction{m.linear * geometry::Direction::of(entity.canon).components}.canon()};
    case EntityType::line:
    case EntityType::plane:
      return movePlane(entity, m);
    case EntityType::circle:
    case EntityType::cylinder:
      return moveCylinder(entity, m);
    case EntityType::cone:
      return moveCone(entity, m);
    case EntityType::sphere:
      return moveSphere(entity, m);
    case EntityType::torus:
      return moveTorus(entity, m);
    case EntityType::ellipse:
    case EntityType::hyperbola:
    case EntityType::gconic:
    case EntityType::lconic:
    case EntityType::quadric:
      return moveQuadric(entity, m);
    case EntityType::gun:
      return Form{entity.type, entity.canon};  // a gun has a size and no place
    case EntityType::region:
      return moveRegion(entity, m);
    case EntityType::mesh:
      return moveMesh(entity, m);
    case EntityType::pathSpline:
      return moveSpline(entity, m);
    case EntityType::matrix:
    case EntityType::polyconic:
    case EntityType::tabulatedCylinder:
    case EntityType::revolved:
    case EntityType::ruledSurface:
      break;
  }
  return refuse(entity.type);
}

}  // namespace

Result<Entity> transformed(const Entity& entity, std::span<const double, 12> matrix) {
  Result<Form> form = move(entity, Matrix::of(matrix));
  if (!form) {
    return form.takeFailure();
  }
  Entity result = entity;
  result.type = form->first;
  result.canon = std::move(form->second);
  result.built = surface::builtOf(result.type, result.canon);
  return result;
}

}  // namespace arelem::define
