#pragma once
#include <algorithm>
#include <cmath>
#include <utility>

#include "ir/space/tolerance.h"
#include "runtime/certify/piece.h"
#include "runtime/certify/probe.h"

namespace arelem::certify {

/// Planes that support a convex solid outside of which a cutter is. They bound the gap of the
/// cutter from below, and that with its top face is a convex function of the tool end.
template <surface::Surface S>
class SupportPlanes {
 public:
  SupportPlanes(const S& surface, const tool::Profile& cutter, const Relation& relation)
      : surface_(surface), cutter_(cutter), thick_(relation.thick) {}

  /// Lower bound of the gap at `there` by the plane that supports the convex solid at the foot of
  /// `of`.
  [[nodiscard]] double below(const Node& of, const Node& there) const {
    const double plane = of.foot.distance + of.normal.dot(there.toolEnd - of.point);
    return plane - tool::reach(cutter_, of.normal.dot(there.axis)) - thick_;
  }

  /// The same, of the planes that one knows at `of`, by the best of them: at the tip of a cone a
  /// mean of many, whatever place of the cutter is measured there.
  [[nodiscard]] double best(const Node& of, const Node& there) const {
    const double plane = below(of, there);
    if constexpr (std::is_same_v<S, surface::Cone>) {
      // All of them pass through the vertex, and so do those that touch it alone.
      return std::max(plane, byMean(of.support, there));
    }
    return plane;
  }

  /// Lower bound of the gap at `there` by the plane square to the normal of `of` that supports the
  /// convex hull of a torus; it says all where a level bottom lies on the torus.
  [[nodiscard]] double belowHull(
      const Node& of, const Node& there) const requires std::is_same_v<S, surface::Torus> {
    const Vec3& n = of.normal;
    const double along = n.dot(surface_.axis);
    const double across = std::sqrt(std::max(0.0, 1.0 - along * along));
    return n.dot(there.toolEnd - surface_.center) - tool::reach(cutter_, n.dot(there.axis)) -
           surface_.major * across - surface_.minor - thick_;
  }

  /// Of a cutter that covers the tip of a cone the nearest point lies on the cone's axis, where the
  /// planes that support the cone all around meet: none of them alone says how near. Their weighted
  /// means do: any normal leaning from the axis by up to 90 degrees less the half angle, so long
  /// that its share of the axis is sin(half). What they say is a concave function of how they lean,
  /// towards the cutter's axis and aside.
  void supportAtTip(Node& n, const Chord& chord) const requires std::is_same_v<S, surface::Cone> {
    if (n.high - n.low <= tolerance::rounding) {
      return;
    }
    const Vec3 up = -surface_.axis;
    const Vec3 way = n.toolEnd + cutter_.f * n.axis - surface_.vertex;
    const Vec3 across = way - way.dot(up) * up;
    const Vec3 out = across.norm() > 0.0 ? Vec3(across.normalized()) : up.unitOrthogonal();
    const Vec3 aside = up.cross(out);
    const auto mean = [&](double outwards, double sideways) -> Vec3 {
      return surface_.sinHalf * (up + outwards * out + sideways * aside);
    };
    const auto gapBy = [&](double outwards, double sideways) {
      return byMean(mean(outwards, sideways), n);
    };
    const double most = surface_.cosHalf / surface_.sinHalf;
    const auto [straight, value] = greatest(0.0, most, [&](double t) { return gapBy(t, 0.0); });
    take(n, value, mean(straight, 0.0), chord);
    if (n.high - n.low <= tolerance::sameSide) {
      return;
    }
    const auto bestAside = [&](double outwards) {
      const double rest = std::sqrt(std::max(0.0, most * most - outwards * outwards));
      return greatest(-rest, rest, [&](double t) { return gapBy(outwards, t); });
    };
    const auto [leaning, gap] = greatest(-most, most, [&](double t) { return bestAside(t).value; });
    take(n, gap, mean(leaning, bestAside(leaning).at), chord);
  }

  /// The gap is convex where the top face, which does not cut, counts too. That face is the nearest
  /// one, by a gap of at least `low`, only where all of the solid is as high as it is with that
  /// gap: not while one of the feet lies below.
  [[nodiscard]] bool reachesBelowTop(const Node& a,
                                     const Node& b,
                                     double low,
                                     const Chord& chord) const {
    const Vec3 axis = chord.axis(0.0);
    const auto height = [&](const Node& n) {
      return (n.point - n.foot.distance * n.foot.normal - n.toolEnd).dot(axis);
    };
    const double rise = (b.s - a.s) * chord.step().dot(axis);
    const double lowest = std::min(height(a), height(b) + rise) - std::min(0.0, rise);
    return lowest < cutter_.h + std::min(0.0, low + thick_) - tolerance::sameSide;
  }

 private:
  /// Golden sections for the plane at the tip of a cone.
  static constexpr int tipSections = 60;

  /// By a mean of planes through the vertex of a cone, all of which support it.
  [[nodiscard]] double byMean(const Vec3& mean,
                              const Node& there) const requires std::is_same_v<S, surface::Cone> {
    const double length = mean.norm();
    return mean.dot(there.toolEnd - surface_.vertex) -
           length * tool::reach(cutter_, mean.dot(there.axis) / length) - thick_;
  }

  struct Greatest {
    double at, value;
  };
  /// Of a concave function between two places.
  template <class Function>
  static Greatest greatest(double low, double high, const Function& value) {
    constexpr double golden = 0.6180339887498949;
    double left = high - golden * (high - low);
    double right = low + golden * (high - low);
    double byLeft = value(left);
    double byRight = value(right);
    for (int i = 0; i < tipSections; ++i) {
      if (byLeft >= byRight) {
        high = std::exchange(right, left);
        byRight = byLeft;
        left = high - golden * (high - low);
        byLeft = value(left);
      } else {
        low = std::exchange(left, right);
        byLeft = byRight;
        right = low + golden * (high - low);
        byRight = value(right);
      }
    }
    return byLeft >= byRight ? Greatest{left, byLeft} : Greatest{right, byRight};
  }

  /// Takes what a mean of the planes at the tip of a cone says, if that is more than is known. The
  /// place of the cutter that such a plane touches is the one on the cone's axis.
  void take(Node& n, double gap, const Vec3& mean, const Chord& chord) const {
    if (gap > n.low) {
      n.low = gap;
      n.support = mean;
      const Vec3 normal = mean.normalized();
      const tool::ProfilePoint q = tool::reachPoint(cutter_, normal.dot(n.axis));
      measure(n, n.toolEnd + q.z * n.axis + q.rho * squareTo(n.axis, -normal), chord);
    }
  }

  /// Takes the gap at a place of the cutter, if that is the lowest so far.
  void measure(Node& n, const Vec3& place, const Chord& chord) const {
    typename S::Hint hint{};
    const surface::Foot foot = surface_.foot(place, hint);
    const double gap = foot.distance - thick_;
    if (gap < n.high) {
      n.point = place;
      n.foot = foot;
      n.normal = foot.normal;
      n.high = gap;
      n.slope = n.normal.dot(chord.velocity(place - n.toolEnd));
    }
  }

  const S& surface_;
  const tool::Profile& cutter_;
  double thick_;
};

}  // namespace arelem::certify
