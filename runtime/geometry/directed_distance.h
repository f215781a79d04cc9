#pragma once
#include <optional>

#include "runtime/geometry/shapes.h"
#include "runtime/geometry/tabulated_cylinder.h"

/// Directed distances: the s for which from + s direction lies on a surface, and unit normals of
/// surfaces. Source: Galbiati and Trumpy, "APT III section 2" (1970), routines DDPLAN, DDSPHR,
/// DDCYLN, DDCON, DDQUAD, DDTABC, QUAD and UNPLAN ... UNCON, with the corrections listed in
/// docs/differences.md. Units: s is in multiples of |direction|; with a unit direction it is a
/// length.
namespace arelem::geometry {

/// Which of several crossings is meant (the report's FIOP).
enum class Crossing : std::uint8_t {
  nearest,          ///< FIOP 0: least |s|; of two equal ones the later
  ahead,            ///< FIOP 1: least s >= 0
  aheadElseNearest  ///< FIOP -1: least s >= 0, else least |s|
};

/// Collects crossings and keeps the one that is meant.
class CrossingChoice {
 public:
  explicit CrossingChoice(Crossing which) : which_(which) {}
  void consider(double s);
  [[nodiscard]] std::optional<double> result() const;

 private:
  Crossing which_;
  std::optional<double> nearest_, ahead_;
};

/// Roots of a s^2 + 2 b s + c = 0 under the report's zero tests, `a` being of size one: |a| <= 1e-7
/// is linear, a discriminant of at most 1e-13 a^2 a double root, |s| <= 1e-7 is 0. Considers the
/// smaller root first.
void considerQuadratic(double a, double b, double c, CrossingChoice& choice);

[[nodiscard]] std::optional<double> directedDistance(const Plane& plane,
                                                     const Vec3& from,
                                                     const Vec3& direction,
                                                     Crossing which);
[[nodiscard]] std::optional<double> directedDistance(const Sphere& sphere,
                                                     const Vec3& from,
                                                     const Vec3& direction,
                                                     Crossing which);
[[nodiscard]] std::optional<double> directedDistance(const Cylinder& cylinder,
                                                     const Vec3& from,
                                                     const Vec3& direction,
                                                     Crossing which);
/// Only the nappe on the side of the axis counts.
[[nodiscard]] std::optional<double> directedDistance(const Cone& cone,
                                                     const Vec3& from,
                                                     const Vec3& direction,
                                                     Crossing which);
[[nodiscard]] std::optional<double> directedDistance(const Quadric& quadric,
                                                     const Vec3& from,
                                                     const Vec3& direction,
                                                     Crossing which);
/// Looks at all intervals, the straight ones included.
[[nodiscard]] std::optional<double> directedDistance(const TabulatedCylinder& surface,
                                                     const Vec3& from,
                                                     const Vec3& direction,
                                                     Crossing which);
[[nodiscard]] std::optional<double> directedDistance(const Torus& torus,
                                                     const Vec3& from,
                                                     const Vec3& direction,
                                                     Crossing which);

/// Unit normals at a place of the surface: outward of closed surfaces, of the cone away from its
/// axis, of a quadric along the gradient, of a tabulated cylinder to the left of the curve. None
/// where it is not defined (axis, vertex).
[[nodiscard]] Vec3 unitNormal(const Plane& plane, const Vec3& place);
[[nodiscard]] std::optional<Vec3> unitNormal(const Sphere& sphere, const Vec3& place);
[[nodiscard]] std::optional<Vec3> unitNormal(const Cylinder& cylinder, const Vec3& place);
[[nodiscard]] std::optional<Vec3> unitNormal(const Cone& cone, const Vec3& place);
[[nodiscard]] std::optional<Vec3> unitNormal(const Quadric& quadric, const Vec3& place);
[[nodiscard]] std::optional<Vec3> unitNormal(const TabulatedCylinder& surface, const Vec3& place);
[[nodiscard]] std::optional<Vec3> unitNormal(const Torus& torus, const Vec3& place);

/// The same for an entity, by its type. None also for types that are no surface (POINT, VECTOR,
/// MATRIX, PATERN, POLCON) and for RLDSRF, which needs an iteration of its own.
[[nodiscard]] std::optional<double> directedDistance(const Entity& surface,
                                                     const Vec3& from,
                                                     const Vec3& direction,
                                                     Crossing which);
[[nodiscard]] std::optional<Vec3> unitNormal(const Entity& surface, const Vec3& place);

}  // namespace arelem::geometry
