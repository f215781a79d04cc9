#include "backend/ngc/arc.h"

#include <cmath>
#include <numbers>

#include "ir/space/tolerance.h"

namespace arelem::backend::ngc {

namespace {

/// An arc ends before half a turn: its center is then well fixed by its ends.
constexpr double mostSweep = 170.0 * std::numbers::pi / 180.0;
constexpr double mostStep = std::numbers::pi / 2.0;

std::optional<int> coordinateAxis(const Vec3& direction) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(std::abs(direction(k)) - 1.0) <= tolerance::symmetric) {
      return k;
    }
  }
  return std::nullopt;
}

/// Places round the axis: angle from the start, radius, height.
class Cylinder {
 public:
  Cylinder(int axis, const Vec3& center, const Vec3& start)
      : u_((axis + 1) % 3), v_((axis + 2) % 3), w_(axis), center_(center) {
    from_ = radial(start);
  }
  [[nodiscard]] double radius(const Vec3& p) const { return radial(p).norm(); }
  [[nodiscard]] double height(const Vec3& p) const { return p(w_); }
  [[nodiscard]] double angle(const Vec3& a, const Vec3& b) const {
    const Eigen::Vector2d p = radial(a);
    const Eigen::Vector2d q = radial(b);
    return std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q));
  }

 private:
  [[nodiscard]] Eigen::Vector2d radial(const Vec3& p) const {
    return {p(u_) - center_(u_), p(v_) - center_(v_)};
  }
  int u_, v_, w_;
  Vec3 center_;
  Eigen::Vector2d from_;
};

}  // namespace

std::optional<Arc> arcThrough(const cl::SurfaceValue& surface,
                              const Vec3& start,
                              std::span<const Vec3> points,
                              double tolerance,
                              double band) {
  if (surface.canon.size() != 7) {
    return std::nullopt;
  }
  const Vec3 center(surface.canon.data());
  const std::optional<int> axis = coordinateAxis(Vec3(&surface.canon[3]));
  if (!axis) {
    return std::nullopt;
  }
  const Cylinder round(*axis, center, start);
  const double radius = round.radius(start);
  const double rise0 = round.height(start);
  std::vector<double> sweeps;
  double sweep = 0.0;
  const Vec3* before = &start;
  for (const Vec3& p : points) {
    const double step = round.angle(*before, p);
    const bool turnsBack = sweep != 0.0 && (step > 0.0) != (sweep > 0.0);
    const double sagitta = radius * (1.0 - std::cos(0.5 * step));
    if (turnsBack || step == 0.0 || std::abs(step) > mostStep ||
        std::abs(sweep + step) > mostSweep || std::abs(round.radius(p) - radius) > tolerance ||
        sagitta > band + tolerance) {
      break;
    }
    sweep += step;
    sweeps.push_back(sweep);
    before = &p;
  }
  // A helix rises in proportion to its turn: give back points until it does.
  for (std::size_t n = sweeps.size(); n >= 2; --n) {
    const double rise = (round.height(points[n - 1]) - rise0) / sweeps[n - 1];
    bool even = true;
    for (std::size_t i = 0; i < n && even; ++i) {
      even = std::abs(round.height(points[i]) - rise0 - rise * sweeps[i]) <= tolerance;
    }
    if (even) {
      Arc arc{*axis, sweeps[0] > 0.0, points[n - 1], center, n};
      arc.center(*axis) = rise0;
      return arc;
    }
  }
  return std::nullopt;
}

}  // namespace arelem::backend::ngc
