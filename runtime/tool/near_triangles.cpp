#include "runtime/tool/near_triangles.h"

#include <algorithm>
#include <cmath>

#include "runtime/tool/gap_above.h"

namespace arelem::tool {

namespace {
/// Lists longer than `most` are not made; pieces of way are made longer or shorter until lists are
/// between `few` and `many`.
constexpr std::size_t few = 60;
constexpr std::size_t many = 160;
constexpr std::size_t most = 1000;
constexpr double growth = 1.5;
/// Lists reach this much beyond the gap, as a share of the length of the piece of way.
constexpr double margin = 1.0 / 16.0;
/// Share of the piece of way that lies behind.
constexpr double behind = 0.5;
/// Tools that moved by more lengths of the last piece of way did not go on along it.
constexpr double jump = 4.0;
/// Length of the first piece of way, in lengths of an edge.
constexpr double firstEdges = 4.0;

Facet facetOf(const surface::MeshShape& shape, std::size_t triangle) {
  const auto& t = shape.mesh.triangles[triangle];
  const auto& v = shape.mesh.vertices;
  return {v[t[0]], v[t[1]], v[t[2]], shape.normals[triangle]};
}
}  // namespace

/// Takes the triangles that a tangent from one measured distance does not exclude.
class NearTriangles::Collect final : public geometry::TriangleSearch {
 public:
  Collect(NearTriangles& near,
          const Vec3& from,
          const Vec3& to,
          const Vec3& axis,
          double ceiling,
          std::size_t limit)
      : near_(near),
        from_(from),
        to_(to),
        middle_(*near.body_, 0.5 * (from + to), axis),
        boxes_(*near.body_, 0.5 * (from + to), axis, 0.5 * (to - from)),
        ceiling_(ceiling),
        limit_(limit) {}

  bool enters(const Vec3& center, const Vec3& half) override {
    return !full && boxes_.mayReach(center, half, ceiling_);
  }
  void visit(std::size_t i) override {
    if (full) {
      return;
    }
    const GapTangent tangent = tangentBelow(middle_, facetOf(*near_.shape_, i));
    const Candidate c{tangent.low - tangent.slope.dot(middle_.te()), tangent.slope,
                      static_cast<std::uint32_t>(i)};
    if (std::min(c.below(from_), c.below(to_)) <= ceiling_) {
      near_.near_.push_back(c);
      full = near_.near_.size() >= limit_;
    }
  }

 private:
  NearTriangles& near_;
  const Vec3 &from_, &to_;
  PlacedBody middle_;
  TriangleCutter boxes_;
  double ceiling_;
  std::size_t limit_;

 public:
  bool full = false;
};

void NearTriangles::takeCutter(const surface::MeshShape& shape, const Profile& cutter) {
  if (shape_ == &shape && body_ && &body_->cutter() == &cutter) {
    return;
  }
  shape_ = &shape;
  body_.emplace(cutter);
  arm_ = std::hypot(cutter.maxRadius(), std::max(cutter.h, cutter.f + cutter.r));
  valid_ = false;
  ahead_ = firstEdges * (shape.mesh.corner(0, 0) - shape.mesh.corner(0, 1)).norm();
}

double NearTriangles::toWay(const Vec3& te) const {
  const Vec3 along = to_ - from_;
  const double squared = along.squaredNorm();
  const double share =
      squared > 0.0 ? std::clamp((te - from_).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (te - from_ - share * along).norm();
}

double NearTriangles::turnedBy(const Vec3& axis) const {
  return axis == axis_ ? 0.0 : arm_ * (axis - axis_).norm();
}

double NearTriangles::beyond(const Vec3& te, const Vec3& axis) const {
  return ceiling_ - toWay(te) - turnedBy(axis);
}

bool NearTriangles::collect(
    const Vec3& from, const Vec3& to, const Vec3& axis, double ceiling, std::size_t limit) {
  near_.clear();
  Collect search(*this, from, to, axis, ceiling, limit);
  shape_->tree->search(search);
  valid_ = !search.full;
  from_ = from;
  to_ = to;
  axis_ = axis;
  ceiling_ = ceiling;
  ahead_ = near_.size() < few ? growth * ahead_ : near_.size() > many ? ahead_ / growth : ahead_;
  return valid_;
}

/// The piece of way goes on from the last one.
bool NearTriangles::collectAround(const Vec3& te, const Vec3& axis, double gap) {
  const Vec3 gone = te - from_;
  const double distance = gone.norm();
  const bool goesOn =
      valid_ && distance > 0.0 && distance <= jump * (ahead_ + (to_ - from_).norm());
  const Vec3 way = goesOn ? Vec3(ahead_ / distance * gone) : Vec3(Vec3::Zero());
  return collect(te - behind * way, te + (1.0 - behind) * way, axis, gap + margin * ahead_, most);
}

TriangleGap NearTriangles::scan(const PlacedBody& body, std::size_t& triangle) {
  TriangleGap least = gapOf(body, facetOf(*shape_, triangle));
  const double turned = turnedBy(body.axis());
  for (Candidate& c : near_) {
    if (c.triangle == triangle || c.below(body.te()) - turned > least.gap) {
      continue;
    }
    const TriangleGap gap = gapOf(body, facetOf(*shape_, c.triangle), least.gap);
    if (turned == 0.0) {
      c.raise(gap, body.te());
    }
    if (gap.gap < least.gap || (gap.gap == least.gap && c.triangle < triangle)) {
      least = gap;
      triangle = c.triangle;
    }
  }
  return least;
}

TriangleGap NearTriangles::least(const surface::MeshShape& shape,
                                 const Profile& cutter,
                                 const Vec3& te,
                                 const Vec3& axis,
                                 std::size_t& triangle) {
  takeCutter(shape, cutter);
  if (!body_->isConvex()) {
    return leastGap(TriangleCutter(*body_, te, axis), shape.mesh, *shape.tree, triangle);
  }
  const PlacedBody body(*body_, te, axis);
  TriangleGap least;
  if (valid_ && toWay(te) <= ahead_) {
    least = scan(body, triangle);
    if (least.gap <= beyond(te, axis)) {
      return least;
    }
  } else {
    least = gapOf(body, facetOf(shape, triangle));
  }
  if (collectAround(te, axis, least.gap)) {
    return scan(body, triangle);
  }
  least = leastGap(TriangleCutter(*body_, te, axis), shape.mesh, *shape.tree, triangle);
  (void)collectAround(te, axis, least.gap);
  return least;
}

/// Tangents at both ends, where the one at hand does not do.
double NearTriangles::lowestOf(Candidate& c, const PlacedBody& a, const PlacedBody& b, double aim) {
  const Facet facet = facetOf(*shape_, c.triangle);
  const Vec3 step = b.te() - a.te();
  const double enough = aim + step.norm();
  const TriangleGap first = gapOf(a, facet, enough);
  c.raise(first, a.te());
  if (first.gap >= enough) {
    return aim;  // it changes by no more than the way
  }
  if (step.isZero(0.0)) {
    return first.gap;
  }
  const double rise = first.slope.dot(step);
  if (std::min(first.low, first.low + rise) >= aim) {
    return aim;
  }
  const TriangleGap last = gapOf(b, facet, enough);
  const double fall = last.slope.dot(step);
  if (std::min(last.low, last.low - fall) >= aim) {
    c.raise(last, b.te());
    return aim;
  }
  // The lower envelope of first.low + rise s and last.low - fall (1 - s).
  double least =
      std::min(std::max(first.low, last.low - fall), std::max(last.low, first.low + rise));
  if (rise < 0.0 && fall > 0.0) {
    const double s = std::clamp((last.low - fall - first.low) / (rise - fall), 0.0, 1.0);
    least = std::min(least, first.low + rise * s);
  }
  return least;
}

double NearTriangles::lowest(const surface::MeshShape& shape,
                             const Profile& cutter,
                             const Vec3& from,
                             const Vec3& to,
                             const Vec3& axis,
                             double aim) {
  takeCutter(shape, cutter);
  const double slack = margin * ahead_;
  if (!valid_ || axis != axis_ || std::min(beyond(from, axis), beyond(to, axis)) < aim) {
    if (!collect(from, to, axis, aim + slack, most)) {
      (void)collect(from, to, axis, aim, shape.mesh.triangles.size() + 1);
    }
  }
  const PlacedBody a(*body_, from, axis_);
  const PlacedBody b(*body_, to, axis_);
  double least = aim;
  for (Candidate& c : near_) {
    if (std::min(c.below(from), c.below(to)) < least) {
      least = std::min(least, lowestOf(c, a, b, least));
    }
  }
  return least;
}

}  // namespace arelem::tool
