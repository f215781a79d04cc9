#include "runtime/geometry/kinds.h"

#include <cmath>

#include <Eigen/Eigenvalues>

#include "ir/diag/geometry.h"
#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/built.h"
#include "runtime/geometry/polyconic.h"
#include "runtime/geometry/shapes.h"
#include "runtime/geometry/tabulated_cylinder.h"

namespace arelem::surface {

namespace {
Vec3 vec(const std::vector<double>& c, std::size_t i) {
  return {c[i], c[i + 1], c[i + 2]};
}

/// Positive outside: the sign is turned so that the far side of a closed or curved sheet is
/// positive.
Quadric quadricOf(const std::vector<double>& c) {
  Eigen::Matrix3d matrix;
  matrix << c[0], c[6], c[5], c[6], c[1], c[4], c[5], c[4], c[2];
  const double sign = matrix.trace() < 0.0 ? -1.0 : 1.0;
  return {sign * matrix, sign * vec(c, 7), sign * c[3]};
}

/// Eigenvalues and values at most this share of what they are made of are rounding. Dimensionless.
constexpr double nullShare = 1e-14;

/// What the places of a quadric are where that is no surface, else null. Its form p.Q p + 2 q.p + c
/// then has its least value where Q p = -q, and that is not below 0.
const char* lessThanASurface(const std::vector<double>& c) {
  const double sign = c[0] + c[1] + c[2] < 0.0 ? -1.0 : 1.0;
  const geometry::Quadric quadric = geometry::Quadric::of(c);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(sign *
                                                             quadric.matrix.topLeftCorner<3, 3>());
  const Vec3 linear = sign * (eigen.eigenvectors().transpose() * vec(c, 7));
  const double null = nullShare * eigen.eigenvalues().cwiseAbs().maxCoeff();
  double least = sign * c[3];
  double size = std::abs(least);
  int squares = 0;
  for (int i = 0; i < 3; ++i) {
    const double root = eigen.eigenvalues()[i];
    if (root < -null || (root <= null && std::abs(linear[i]) > nullShare * linear.norm())) {
      return nullptr;
    }
    if (root > null) {
      ++squares;
      least -= linear[i] * linear[i] / root;
      size += linear[i] * linear[i] / root;
    }
  }
  if (squares < 2 || least < -nullShare * size) {
    return nullptr;
  }
  return least > nullShare * size ? "no place satisfies its equation"
         : squares == 2           ? "only the places of a line satisfy its equation"
                                  : "only one place satisfies its equation";
}

/// Where the straight ends begin at one place, the curve closes there, without them.
void close(TabulatedCylinder::Curve& curve) {
  const TabulatedCylinder::Piece& first = curve.pieces.front();
  const TabulatedCylinder::Piece& last = curve.pieces.back();
  const double du = first.u + first.length * first.dirU - last.u;
  const double dv = first.v + first.length * first.dirV - last.v;
  if (curve.pieces.size() > 3 && std::hypot(du, dv) <= tolerance::coincidence) {
    curve.pieces.pop_back();
    curve.pieces.erase(curve.pieces.begin());
    curve.pieces.front().openStart = curve.pieces.back().openEnd = false;
  }
}

AnySurface tabulatedOf(const std::vector<double>& c) {
  const geometry::TabulatedCylinder view = geometry::TabulatedCylinder::of(c);
  auto curve = std::make_shared<TabulatedCylinder::Curve>();
  curve->u = view.frame.row(0).transpose();
  curve->v = view.frame.row(1).transpose();
  curve->w = view.frame.row(2).transpose();
  for (std::size_t i = 0; i < view.intervals.size(); ++i) {
    const auto& interval = view.intervals[i];
    TabulatedCylinder::Piece p{};
    p.u = interval.start.x();
    p.v = interval.start.y();
    p.length = interval.length;
    p.dirU = interval.along.x();
    p.dirV = interval.along.y();
    p.a = interval.a;
    p.b = interval.b;
    p.c = -p.length * (p.a * p.length + p.b);
    p.openStart = i == 0;
    p.openEnd = i + 1 == view.intervals.size();
    p.lowY = interval.lowest;
    p.highY = interval.highest;
    curve->pieces.push_back(p);
  }
  close(*curve);
  return TabulatedCylinder(std::move(curve));
}

/// Canonical input may give a normal or an axis of any length.
Result<AnySurface> planeOf(const Entity& entity) {
  const auto& c = entity.canon;
  const double length = vec(c, 0).norm();
  if (!(length > tolerance::nullDirection)) {
    return fail(diag::NullDirection, spell(entity.type), vec(c, 0).cwiseAbs().maxCoeff(),
                tolerance::nullDirection);
  }
  return AnySurface(Plane{vec(c, 0) / length, c[3] / length});
}

Vec3 axisOf(const std::vector<double>& c) {
  return vec(c, 3).normalized();
}

}  // namespace

std::shared_ptr<const MeshShape> builtMesh(std::span<const double> canon) {
  return std::make_shared<const MeshShape>(geometry::TriangleMesh::of(canon));
}

std::shared_ptr<const void> builtOf(EntityType type, std::span<const double> canon) {
  switch (type) {
    case EntityType::mesh:
      return builtMesh(canon);
    case EntityType::ruledSurface:
      return std::make_shared<const Ruled>(geometry::RuledSurface::of(canon));
    case EntityType::polyconic:
      return std::make_shared<const Polyconic>(geometry::Polyconic::of(canon));
    default:
      return nullptr;
  }
}

Result<AnySurface> surfaceOf(const Entity& entity) {
  const auto& c = entity.canon;
  switch (entity.type) {
    case EntityType::line:
    case EntityType::plane:
      return planeOf(entity);
    case EntityType::circle:
    case EntityType::cylinder:
      return AnySurface(Cylinder{vec(c, 0), axisOf(c), c[6]});
    case EntityType::sphere:
      return AnySurface(Sphere{vec(c, 0), c[3]});
    case EntityType::cone:
      return AnySurface(
          Cone{vec(c, 0), axisOf(c), c[6], std::sqrt(std::max(0.0, 1.0 - c[6] * c[6]))});
    case EntityType::torus:
      return AnySurface(Torus{vec(c, 0), axisOf(c), c[6], c[7]});
    case EntityType::ellipse:
    case EntityType::hyperbola:
    case EntityType::gconic:
    case EntityType::lconic:
    case EntityType::quadric:
      if (const char* why = lessThanASurface(c)) {
        return fail(diag::NotASurface, spell(entity.type)).withHelp(why);
      }
      return AnySurface(quadricOf(c));
    case EntityType::tabulatedCylinder:
      return tabulatedOf(c);
    case EntityType::mesh:
      return AnySurface(Mesh(entity.built ? std::static_pointer_cast<const MeshShape>(entity.built)
                                          : builtMesh(c)));
    case EntityType::ruledSurface:
      return AnySurface(entity.built ? *std::static_pointer_cast<const Ruled>(entity.built)
                                     : Ruled(geometry::RuledSurface::of(c)));
    case EntityType::polyconic:
      return AnySurface(entity.built ? *std::static_pointer_cast<const Polyconic>(entity.built)
                                     : Polyconic(geometry::Polyconic::of(c)));
    default:
      return fail(diag::NotASurface, spell(entity.type));
  }
}

}  // namespace arelem::surface
