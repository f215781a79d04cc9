// Places where a path spline stops and leads back.
#include <array>
#include <optional>

#include "runtime/spline/cubic.h"

namespace arelem::spline {

namespace {

/// A place is found to this power of a half of its knot interval.
constexpr int deepest = 40;

using Hodograph = std::array<Vec3, 3>;

/// Derivatives that all lie on one side of a plane have no 0 among them.
bool goesOn(const Hodograph& q) {
  const Vec3 mean = q[0] + q[1] + q[2];
  return q[0].dot(mean) > 0.0 && q[1].dot(mean) > 0.0 && q[2].dot(mean) > 0.0;
}

/// Where the derivative comes to 0 in a part of a piece.
std::optional<double> zeroIn(const Hodograph& q, double begin, double end, int depth) {
  if (goesOn(q)) {
    return std::nullopt;
  }
  const double middle = 0.5 * (begin + end);
  if (depth == 0) {
    return middle;
  }
  const Vec3 a = 0.5 * (q[0] + q[1]);
  const Vec3 b = 0.5 * (q[1] + q[2]);
  const Vec3 c = 0.5 * (a + b);
  const auto left = zeroIn({q[0], a, c}, begin, middle, depth - 1);
  return left ? left : zeroIn({c, b, q[2]}, middle, end, depth - 1);
}

}  // namespace

std::optional<double> cuspOf(const CubicSpline& curve) {
  for (std::size_t span = 0; span < curve.spans(); ++span) {
    const Bezier piece = curve.piece(span);
    const auto& p = piece.control;
    const auto zero =
        zeroIn({p[1] - p[0], p[2] - p[1], p[3] - p[2]}, piece.begin, piece.end, deepest);
    if (zero) {
      return zero;
    }
  }
  return std::nullopt;
}

}  // namespace arelem::spline
