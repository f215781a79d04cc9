#pragma once
#include "runtime/motion/facets/facet_task.h"
#include "runtime/tool/upright_touch.h"

namespace arelem::motion {

/// What any normal tells of the heights at which an upright cutter touches triangles: they are not
/// above a line in the section, by how far corners and cutter reach along the normal.
class UprightBounds {
 public:
  struct Line {
    double base = 0.0, slope = 0.0;

    [[nodiscard]] double at(double s) const { return base + slope * s; }
    [[nodiscard]] bool isBelow(const Way& way) const {
      return at(way.from.s) < way.from.z - way.slab && at(way.to.s) < way.to.z - way.slab;
    }
  };
  /// The part of a way on which no line shows that a triangle is below its slab.
  class Doubt {
   public:
    explicit Doubt(const Way& way)
        : from_(way.from.s),
          to_(way.to.s),
          slope_((way.to.z - way.from.z) / (way.to.s - way.from.s)),
          base_(way.from.z - way.slab - slope_ * way.from.s) {}

    /// Whether a line leaves the middle of the way: others, for normals from elsewhere, will too.
    [[nodiscard]] bool isInMiddle(const Line& line, double middle) const {
      return line.at(middle) >= base_ + slope_ * middle;
    }
    /// True where nothing is left.
    bool isSettled(const Line& line) {
      const double steeper = line.slope - slope_;
      const double ahead = line.base - base_;  // above the slab at s = 0
      if (steeper > 0.0) {
        from_ = std::max(from_, -ahead / steeper);
      } else if (steeper < 0.0) {
        to_ = std::min(to_, -ahead / steeper);
      } else if (ahead < 0.0) {
        return true;
      }
      return from_ > to_;
    }

   private:
    double from_, to_, slope_, base_;
  };
  /// A unit normal with how far it leans.
  struct Normal {
    Vec3 n = Vec3::UnitZ();
    double nxy = 0.0;

    static Normal of(const Vec3& n) { return {n, std::sqrt(n.x() * n.x() + n.y() * n.y())}; }
  };
  /// The s from which a triangle is beside the cutter no more, and from which it is so again.
  struct Range {
    double first = 0.0, last = 0.0;
  };
  /// Own normals of triangles that are nearer to level tell little.
  static constexpr double usefulRise = 0.05;

  /// `radius`: that of the cutter.
  UprightBounds(const tool::UprightProfile& profile, double radius);

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] const tool::UprightProfile& profile() const { return profile_; }
  /// True for a rim without an arc.
  [[nodiscard]] bool isSharp() const { return flattest_ <= 0.0; }
  /// The normal with which the cutter would touch a place there, seen from its axis.
  [[nodiscard]] Normal normalTowards(double x, double y) const;
  /// The same, to bound a triangle with the normal `up`: a rim bounds its neighbors best by how
  /// they rise outwards.
  [[nodiscard]] Normal normalTowards(double x, double y, const Vec3& up) const;
  /// `most`: how far places reach along the normal.
  [[nodiscard]] Line lineOf(double most, const Normal& normal) const {
    const double rise = 1.0 / normal.n.z();
    return {(most + profile_.support(normal.n.z(), normal.nxy)) * rise, -normal.n.x() * rise};
  }
  [[nodiscard]] Line lineOf(const tool::UprightFacet& facet, const Normal& normal) const {
    return lineOf(greatest(facet, normal.n), normal);
  }
  [[nodiscard]] static double greatest(const tool::UprightFacet& f, const Vec3& n) {
    return std::max({n.dot(f.corners[0]), n.dot(f.corners[1]), n.dot(f.corners[2])});
  }
  /// True where the cutter, anywhere between middle - half and middle + half, has all corners
  /// beside it, as far as one line seen from above shows that.
  [[nodiscard]] bool isBeside(const tool::UprightFacet& facet, double middle, double half) const;
  /// True where it has none of them beside it anywhere there.
  [[nodiscard]] bool covers(const tool::UprightFacet& facet, double middle, double half) const;
  [[nodiscard]] Range rangeOf(const tool::UprightFacet& facet) const;

 private:
  tool::UprightProfile profile_;
  double radius_, flattest_;
};

}  // namespace arelem::motion
