#pragma once
#include <algorithm>
#include <cmath>

#include "runtime/tool/contact.h"

/// The general contact: minimizes side * distance over the cutter, piece by piece. Private to
/// runtime/tool.
namespace arelem::tool {

template <surface::Surface S>
class ContactSearch {
 public:
  ContactSearch(const S& s,
                double side,
                const Profile& cutter,
                const Vec3& te,
                const Vec3& axis,
                Search<S>& search)
      : surface_(s), side_(side), cutter_(cutter), te_(te), axis_(axis), search_(search) {
    e1_ = axis.unitOrthogonal();
    e2_ = axis.cross(e1_);
  }

  Contact run() {
    aim();
    Contact best = nearestPiece();
    if (cutter_.ring) {
      return best;
    }
    // A surface that is hollow on this side may touch the cutter elsewhere too: look from the far
    // side of the axis and at the upper end, unless the distances there prove that it does not.
    if (hollow(best)) {
      const double c = search_.cosTheta;
      const double s = search_.sinTheta;
      const bool reachable =
          sample(te_ + cutter_.f * axis_).distance() - cutter_.e - cutter_.r < best.gap;
      if (cutter_.maxRadius() > 0.0 && reachable) {
        takeBetter(best, [&] { return opposite(c, s); });
      }
      const ProfilePoint top = cutter_.sideEnd;
      if (sample(te_ + top.z * axis_).distance() - top.rho < best.gap) {
        takeBetter(best, [&] { return alongCircle(top, 0.0); });
      }
    }
    return best;
  }

 private:
  static constexpr int limit = 50;
  static constexpr double smallTurn = 1e-15;
  /// Curvatures above minus this count as not hollow. Per part unit.
  static constexpr double flatness = 1e-9;

  struct Sample {
    Vec3 at;
    surface::Foot foot;
    Vec3 gradient;  ///< of side * distance
    double side;
    [[nodiscard]] double distance() const { return side * foot.distance; }
  };

  Contact nearestPiece() {
    Contact best = alongCircle({cutter_.e, cutter_.f}, cutter_.r);
    if (cutter_.ring) {
      return best;
    }
    const double nz = best.normal.dot(axis_);
    if (cutter_.alpha == 0.0 && cutter_.e > 0.0 && nz > 0.0 && best.normal.dot(radial()) > 0.0) {
      best = onDisc(best);
    } else if (nz > cutter_.cosAlpha) {
      best = onLine({0.0, 0.0}, cutter_.bottomEnd);
    } else if (nz < cutter_.sinBeta) {
      best = onLine(cutter_.sideStart, cutter_.sideEnd);
    }
    return best;
  }

  /// True where the distance may fall again away from the contact: the surface bends towards the
  /// cutter.
  bool hollow(const Contact& best) {
    const Sample s = sample(best.point);
    const Vec3 t = best.normal.unitOrthogonal();
    return bend(s, t) < -flatness || bend(s, best.normal.cross(t)) < -flatness;
  }

  Contact opposite(double cosTheta, double sinTheta) {
    search_.cosTheta = -cosTheta;
    search_.sinTheta = -sinTheta;
    return nearestPiece();
  }

  /// Keeps the search where the better contact is.
  template <class Find>
  void takeBetter(Contact& best, Find find) {
    const double c = search_.cosTheta;
    const double s = search_.sinTheta;
    const auto hint = search_.hint;
    const Contact other = find();
    if (other.gap < best.gap) {
      best = other;
    } else {
      search_.cosTheta = c;
      search_.sinTheta = s;
      search_.hint = hint;
    }
  }

  Sample sample(const Vec3& at) {
    const surface::Foot foot = surface_.foot(at, search_.hint);
    return {at, foot, side_ * foot.normal, side_};
  }
  double bend(const Sample& s, const Vec3& t) {
    return side_ * surface_.bend(s.at, s.foot, t, search_.hint);
  }
  double bend(const Sample& s, const Vec3& a, const Vec3& b) {
    return 0.25 * (bend(s, a + b) - bend(s, a - b));
  }
  [[nodiscard]] Vec3 radial() const { return search_.cosTheta * e1_ + search_.sinTheta * e2_; }
  [[nodiscard]] Vec3 around() const { return -search_.sinTheta * e1_ + search_.cosTheta * e2_; }
  [[nodiscard]] Vec3 place(ProfilePoint q) const { return te_ + q.rho * radial() + q.z * axis_; }

  /// Turns the search towards the surface: against the gradient at the corner's height.
  void aim() {
    const Sample s = sample(te_ + cutter_.f * axis_);
    const double x = -s.gradient.dot(e1_);
    const double y = -s.gradient.dot(e2_);
    const double length = std::hypot(x, y);
    if (!search_.valid && length > 0.0) {
      search_.cosTheta = x / length;
      search_.sinTheta = y / length;
    }
    search_.valid = true;
  }

  void turn(double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double next = search_.cosTheta * c - search_.sinTheta * s;
    search_.sinTheta = search_.sinTheta * c + search_.cosTheta * s;
    search_.cosTheta = next;
    const double length = std::hypot(search_.cosTheta, search_.sinTheta);
    search_.cosTheta /= length;
    search_.sinTheta /= length;
  }

  [[nodiscard]] Contact result(const Sample& s, double ball) const {
    return {side_ * s.foot.distance - ball, s.gradient, s.at - ball * s.gradient};
  }

  /// Least distance over the circle of a profile point, by Newton on the angle.
  Contact alongCircle(ProfilePoint q, double ball) {
    Sample s = sample(place(q));
    if (q.rho == 0.0) {
      return result(s, ball);
    }
    for (int i = 0; i < limit; ++i) {
      const Vec3 tangent = around();
      const double slope = s.gradient.dot(tangent);
      const double pull = -s.gradient.dot(radial());
      const double curvature = q.rho * bend(s, tangent) + pull;
      // Away from a minimum, turn as if the surface were flat there.
      const double angle = curvature > 0.1 * std::abs(pull) && curvature > 0.0
                               ? -slope / curvature
                               : -slope / std::max(std::abs(pull) + std::abs(curvature), 1e-3);
      const double bounded = std::clamp(angle, -1.0, 1.0);
      turn(bounded);
      s = sample(place(q));
      if (std::abs(bounded) <= smallTurn) {
        break;
      }
    }
    return result(s, ball);
  }

  /// The flat bottom: Newton in its plane; on its rim the circle search has the answer already.
  Contact onDisc(const Contact& rim) {
    const double height = cutter_.f;
    Vec3 offset = cutter_.e * radial();
    Sample s = sample(place({cutter_.e, height}));
    for (int i = 0; i < limit; ++i) {
      const Eigen::Vector2d slope(s.gradient.dot(e1_), s.gradient.dot(e2_));
      Eigen::Matrix2d curvature;
      const double mixed = bend(s, e1_, e2_);
      curvature << bend(s, e1_), mixed, mixed, bend(s, e2_);
      // A flat direction has no single minimum: stay on the axis along it.
      const double ridge = 1e-9 / std::max(cutter_.e, 1e-9);
      curvature += ridge * Eigen::Matrix2d::Identity();
      const Eigen::Vector2d pulled =
          slope + ridge * Eigen::Vector2d(offset.dot(e1_), offset.dot(e2_));
      if (curvature.determinant() <= 0.0 || curvature(0, 0) <= 0.0) {
        return rim;
      }
      const Eigen::Vector2d step = curvature.inverse() * pulled;
      Vec3 next = offset - step.x() * e1_ - step.y() * e2_;
      if (next.norm() > cutter_.e) {
        next *= cutter_.e / next.norm();
      }
      const double moved = (next - offset).norm();
      offset = next;
      s = sample(te_ + offset + height * axis_);
      if (moved <= 1e-12 * (1.0 + cutter_.e)) {
        break;
      }
    }
    const Contact inner = result(s, cutter_.r);
    return inner.gap < rim.gap ? inner : rim;
  }

  /// A straight piece of the profile turned about the axis: Newton in angle and place along the
  /// line.
  Contact onLine(ProfilePoint a, ProfilePoint b) {
    const double length = std::hypot(b.rho - a.rho, b.z - a.z);
    if (length <= 0.0) {
      return alongCircle(a, 0.0);
    }
    double along = a.rho < b.rho || a.z > 0.0 ? 0.0 : 1.0;
    Contact best = alongCircle(at(a, b, along), 0.0);
    for (int i = 0; i < limit; ++i) {
      const Vec3 direction = (b.rho - a.rho) * radial() + (b.z - a.z) * axis_;
      const Sample s = sample(place(at(a, b, along)));
      const double slope = s.gradient.dot(direction);
      const double curvature = bend(s, direction);
      const double step = curvature > 1e-9 * length * std::abs(slope) ? -slope / curvature
                                                                      : (slope < 0.0 ? 1.0 : -1.0);
      const double next = slope == 0.0 ? along : std::clamp(along + step, 0.0, 1.0);
      const double moved = std::abs(next - along);
      along = next;
      best = alongCircle(at(a, b, along), 0.0);
      if (moved <= 1e-13) {
        break;
      }
    }
    return best;
  }
  static ProfilePoint at(ProfilePoint a, ProfilePoint b, double s) {
    return {a.rho + s * (b.rho - a.rho), a.z + s * (b.z - a.z)};
  }

  const S& surface_;
  double side_;
  const Profile& cutter_;
  const Vec3& te_;
  const Vec3& axis_;
  Search<S>& search_;
  Vec3 e1_, e2_;
};

}  // namespace arelem::tool
