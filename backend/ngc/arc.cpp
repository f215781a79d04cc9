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
  Cylinder(int axis, const Vec3& center)
      : u_((axis + 1) % 3), v_((axis + 2) % 3), w_(axis), center_(center) {}
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
};

/// The center moved along the chord in the plane of the arc until it is as far from one end as from
/// the other: cut vectors end inside their tolerance, not on the circle.
Vec3 equidistant(const Vec3& center, const Vec3& a, const Vec3& b, int axis) {
  Vec3 chord = b - a;
  Vec3 off = center - 0.5 * (a + b);
  chord(axis) = off(axis) = 0.0;
  const double square = chord.squaredNorm();
  return square > 0.0 ? Vec3(center - off.dot(chord) / square * chord) : center;
}

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
  const Cylinder round(*axis, center);
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
  // Give back points until the rest lies on one helix whose ends are equally far from its center.
  for (std::size_t n = sweeps.size(); n >= 2; --n) {
    const double rise = (round.height(points[n - 1]) - rise0) / sweeps[n - 1];
    const Vec3 moved = equidistant(center, start, points[n - 1], *axis);
    const Cylinder own(*axis, moved);
    bool good = true;
    for (std::size_t i = 0; i < n && good; ++i) {
      good = std::abs(own.height(points[i]) - rise0 - rise * sweeps[i]) <= tolerance &&
             std::abs(own.radius(points[i]) - own.radius(start)) <= tolerance;
    }
    if (good) {
      Arc arc{*axis, sweeps[0] > 0.0, points[n - 1], moved, n};
      arc.center(*axis) = rise0;
      return arc;
    }
  }
  return std::nullopt;
}

}  // namespace arelem::backend::ngc
