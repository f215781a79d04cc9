#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/motion/facets/facet_task.h"
#include "runtime/tool/triangle_gap.h"

namespace arelem::motion {

/// The triangles of a mesh that may matter along a piece of a section, with what is known of the
/// gaps to them.
///
/// With a fixed axis the gap of a convex cutter to a triangle is a convex function of the tool end,
/// so that each measured one gives a tangent below it. Two lists: one for a long piece of way, from
/// the tree of boxes, and a short one of it, for the piece that is looked at.
class SectionTriangles {
 public:
  struct Measured {
    double gap = 0.0;
    Tangent tangent;
  };
  /// The last tangents of one triangle.
  struct Tangents {
    std::array<Tangent, 4> last;
    std::uint32_t count = 0;

    /// What the gap is not below.
    [[nodiscard]] double lowest(const SectionPoint& p) const {
      double most = last[0].at(p);
      for (std::uint32_t i = 1; i < count; ++i) {
        most = std::max(most, last[i].at(p));
      }
      return most;
    }
    [[nodiscard]] bool isBeyond(const SectionPoint& p, double gap) const {
      for (std::uint32_t i = 0; i < count; ++i) {
        if (last[i].at(p) >= gap) {
          return true;
        }
      }
      return false;
    }
    /// The same on a straight way.
    [[nodiscard]] bool isBeyond(const SectionPoint& a, const SectionPoint& b, double gap) const {
      for (std::uint32_t i = 0; i < count; ++i) {
        if (std::min(last[i].at(a), last[i].at(b)) >= gap) {
          return true;
        }
      }
      return false;
    }
  };
  explicit SectionTriangles(const FacetTask& task);

  /// Takes all triangles whose gap may be less than the task's low anywhere within the slab. False
  /// where there are more than `limit`.
  bool gather(const Way& way, std::size_t limit);
  /// Those of them that matter on a part of the way.
  void focus(const Way& way);
  [[nodiscard]] const std::vector<std::uint32_t>& all() const { return all_; }
  [[nodiscard]] const std::vector<std::uint32_t>& near() const { return near_; }
  [[nodiscard]] std::uint32_t triangle(std::uint32_t index) const { return facets_[index].number; }
  [[nodiscard]] const Tangents& tangents(std::uint32_t index) const { return tangents_[index]; }

  /// The gap to one of them; of one above `enough` only something below it and still above.
  Measured measure(std::uint32_t index, const SectionPoint& p, double enough);
  [[nodiscard]] const FacetTask& task() const { return task_; }

 private:
  struct Own {
    Vec3 a, b, c, up;
    std::uint32_t number = 0;
  };
  class Collect;

  [[nodiscard]] Tangent inSection(double low, const Vec3& slope, const SectionPoint& p) const {
    const double byS = slope.dot(task_.section.along);
    const double byZ = slope.dot(task_.section.up);
    return {low - byS * p.s - byZ * p.z, byS, byZ};
  }
  void note(std::uint32_t index, const Tangent& tangent) {
    Tangents& t = tangents_[index];
    t.last[3] = t.last[2];
    t.last[2] = t.last[1];
    t.last[1] = t.last[0];
    t.last[0] = tangent;
    t.count = std::min(t.count + 1, 4U);
  }
  [[nodiscard]] tool::Facet facetOf(std::size_t triangle) const;

  FacetTask task_;
  tool::Body body_;
  std::vector<Own> facets_;
  std::vector<Tangents> tangents_;
  std::vector<std::uint32_t> all_, near_;
};

}  // namespace arelem::motion
