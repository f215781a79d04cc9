#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "runtime/geometry/kinds.h"

// TABCYL against what a pencil gives.
namespace arelem::surface {
namespace {

/// y = x^2 / 20 - x / 2 over the chord from x = 0 to 10, between its tangents.
TabulatedCylinder parabola() {
  const auto tangent = [](double u, double slope, bool start) {
    const double norm = std::hypot(1.0, slope);
    TabulatedCylinder::Piece p{};
    p.dirU = 1.0 / norm;
    p.dirV = slope / norm;
    p.u = start ? u - p.dirU : u;
    p.v = start ? -p.dirV : 0.0;
    p.length = 1.0;
    p.openStart = start;
    p.openEnd = !start;
    return p;
  };
  TabulatedCylinder::Piece arch{};
  arch.dirU = 1.0;
  arch.length = 10.0;
  arch.b = 0.05;
  arch.c = -0.5;
  arch.lowY = -1.25;
  auto curve = std::make_shared<TabulatedCylinder::Curve>();
  curve->pieces = {tangent(0, -0.5, true), arch, tangent(10, 0.5, false)};
  return TabulatedCylinder(curve);
}

TEST(TabulatedCylinder, NormalsNextToTheSurfaceKeepTheirFigures) {
  const TabulatedCylinder s = parabola();
  TabulatedCylinder::Hint hint;
  for (double x = 0.7; x < 9.5; x += 0.37) {
    const double slope = 0.1 * x - 0.5;
    const Vec3 normal = Vec3(-slope, 1, 0).normalized();
    for (const double off : {-1e-4, -1e-6, -1e-8, 0.0, 1e-9, 1e-7, 1e-5}) {
      const Foot foot = s.foot(Vec3(x, 0.05 * x * x - 0.5 * x, 3) + off * normal, hint);
      EXPECT_LE((foot.normal - normal).norm(), 1e-9) << x << ' ' << off;
      EXPECT_NEAR(foot.distance, off, 1e-13) << x;
    }
  }
}

}  // namespace
}  // namespace arelem::surface
