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
  };
  /// The lower edge of a way's slab.
  class Edge {
   public:
    explicit Edge(const Way& way)
        : from_(way.from.s),
          to_(way.to.s),
          middle_(0.5 * (from_ + to_)),
          z_(way.heightAt(middle_) - way.slab),
          slope_((way.to.z - way.from.z) / (to_ - from_)),
          bow_(way.bow) {}

    [[nodiscard]] double from() const { return from_; }
    [[nodiscard]] double to() const { return to_; }
    [[nodiscard]] double middle() const { return middle_; }
    [[nodiscard]] double at(double s) const {
      return z_ + (slope_ + bow_ * (s - middle_)) * (s - middle_);
    }
    /// Not above it between two places; touches it at `s`, or at both.
    [[nodiscard]] Line below(double from, double to, double s) const {
      const double slope = bow_ > 0.0 ? slope_ + 2.0 * bow_ * (s - middle_)
                                      : slope_ + bow_ * (from + to - 2.0 * middle_);
      const double touched = bow_ > 0.0 ? s : from;
      return {at(touched) - slope * touched, slope};
    }
    /// Whether a line is below it everywhere.
    [[nodiscard]] bool isAbove(const Line& line) const {
      if (!(line.at(from_) < at(from_) && line.at(to_) < at(to_))) {
        return false;
      }
      if (bow_ <= 0.0) {
        return true;
      }
      const double s = middle_ + 0.5 * (line.slope - slope_) / bow_;  // where it is nearest
      return s <= from_ || s >= to_ || line.at(s) < at(s);
    }

   private:
    double from_, to_, middle_, z_, slope_, bow_;
  };
  /// The part of a way on which no line shows that a triangle is below its slab.
  struct Doubt {
    double from = 0.0, to = 0.0;

    [[nodiscard]] double middle() const { return 0.5 * (from + to); }
    /// Leaves what a line, good around `s`, does not show. True where nothing is left.
    bool isSettled(const Line& line, const Edge& edge, double s) {
      const Line under = edge.below(from, to, s);
      const double steeper = line.slope - under.slope;
      const double ahead = line.base - under.base;  // above the slab at s = 0
      if (steeper > 0.0) {
        from = std::max(from, -ahead / steeper);
      } else if (steeper < 0.0) {
        to = std::min(to, -ahead / steeper);
      } else if (ahead < 0.0) {
        return true;
      }
      return from > to;
    }
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
