#include "runtime/motion/facets/section_triangles.h"

#include "runtime/tool/mesh_contact.h"

namespace arelem::motion {

SectionTriangles::SectionTriangles(const FacetTask& task) : task_(task), body_(*task_.cutter) {}

tool::Facet SectionTriangles::facetOf(std::size_t triangle) const {
  const surface::MeshShape& shape = task_.mesh->shape();
  const auto& t = shape.mesh.triangles[triangle];
  const auto& v = shape.mesh.vertices;
  return {v[t[0]], v[t[1]], v[t[2]], shape.normals[triangle]};
}

/// Takes the triangles that a tangent from one measured distance does not exclude.
class SectionTriangles::Collect {
 public:
  Collect(SectionTriangles& list, const Way& way, std::size_t limit)
      : list_(list),
        way_(way),
        middle_{0.5 * (way.from.s + way.to.s), 0.5 * (way.from.z + way.to.z)},
        ceiling_(list.task_.low + way.slab),
        limit_(limit),
        body_(list.body_, list.task_.section.at(middle_), list.task_.axis),
        boxes_(list.body_,
               body_.te(),
               list.task_.axis,
               0.5 * (list.task_.section.at(way.to) - list.task_.section.at(way.from))) {}

  bool enters(const Vec3& center, const Vec3& half) {
    return !full && boxes_.mayReach(center, half, ceiling_);
  }
  void visit(std::size_t i) {
    if (full) {
      return;
    }
    const tool::Facet f = list_.facetOf(i);
    const tool::GapTangent below = tool::tangentBelow(body_, f);
    const Tangent tangent = list_.inSection(below.low, below.slope, middle_);
    if (std::min(tangent.at(way_.from), tangent.at(way_.to)) < ceiling_) {
      list_.all_.push_back(static_cast<std::uint32_t>(list_.facets_.size()));
      list_.facets_.push_back({f.a, f.b, f.c, f.up, static_cast<std::uint32_t>(i)});
      list_.tangents_.push_back({{tangent}, 1});
      full = list_.facets_.size() >= limit_;
    }
  }

 private:
  SectionTriangles& list_;
  const Way& way_;
  SectionPoint middle_;
  double ceiling_;
  std::size_t limit_;
  tool::PlacedBody body_;
  tool::TriangleCutter boxes_;

 public:
  bool full = false;
};

bool SectionTriangles::gather(const Way& way, std::size_t limit) {
  facets_.clear();
  tangents_.clear();
  all_.clear();
  near_.clear();
  Collect search(*this, way, limit);
  task_.mesh->shape().tree.search(search);
  return !search.full;
}

void SectionTriangles::focus(const Way& way) {
  const SectionPoint middle{0.5 * (way.from.s + way.to.s), 0.5 * (way.from.z + way.to.z)};
  const tool::PlacedBody body(body_, task_.section.at(middle), task_.axis);
  const double ceiling = task_.low + way.slab;
  near_.clear();
  for (const std::uint32_t i : all_) {
    if (tangents_[i].isBeyond(way.from, way.to, ceiling)) {
      continue;
    }
    const Own& f = facets_[i];
    const tool::GapTangent below = tool::tangentBelow(body, {f.a, f.b, f.c, f.up});
    const Tangent tangent = inSection(below.low, below.slope, middle);
    note(i, tangent);
    if (std::min(tangent.at(way.from), tangent.at(way.to)) < ceiling) {
      near_.push_back(i);
    }
  }
}

SectionTriangles::Measured SectionTriangles::measure(std::uint32_t index,
                                                     const SectionPoint& p,
                                                     double enough) {
  const Own& f = facets_[index];
  const tool::PlacedBody body(body_, task_.section.at(p), task_.axis);
  const tool::Facet facet{f.a, f.b, f.c, f.up};
  if (!task_.cutter->isBall()) {
    // One distance is often enough, and far quicker.
    const tool::GapTangent below = tool::tangentBelow(body, facet);
    if (below.low > enough) {
      const Measured m{below.low, inSection(below.low, below.slope, p)};
      note(index, m.tangent);
      return m;
    }
  }
  const tool::TriangleGap gap = tool::gapOf(body, facet, enough);
  const Measured m{gap.gap, inSection(gap.low, gap.slope, p)};
  note(index, m.tangent);
  return m;
}

}  // namespace arelem::motion
