#include "runtime/tool/near_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "runtime/tool/mesh_contact.h"

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
constexpr double shareBehind = 0.5;
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

class NearTriangles::List {
 public:
  List(const surface::MeshShape& shape, const Profile& cutter)
      : shape_(shape),
        body_(cutter),
        arm_(std::hypot(cutter.maxRadius(), std::max(cutter.h, cutter.f + cutter.r))),
        ahead_(firstEdges * (shape.mesh.corner(0, 0) - shape.mesh.corner(0, 1)).norm()) {}

  [[nodiscard]] TriangleGap least(const Vec3& te, const Vec3& axis, std::size_t& triangle);
  [[nodiscard]] double lowest(const Passage& way, double aim);

 private:
  /// The gap with the tool end at te is at least base + slope.te.
  struct Tangent {
    double base = 0.0;
    Vec3 slope = Vec3::Zero();

    [[nodiscard]] double at(const Vec3& te) const { return base + slope.dot(te); }
  };
  /// With the tangents from the last positions, as those are often looked at again.
  struct Candidate {
    std::array<Tangent, 3> tangents;
    std::uint32_t triangle = 0;
    std::uint32_t count = 1;

    [[nodiscard]] bool isBeyond(const Vec3& te, double gap) const {
      return tangents[0].at(te) > gap || (count > 1 && tangents[1].at(te) > gap) ||
             (count > 2 && tangents[2].at(te) > gap);
    }
    /// The same on a whole straight way.
    [[nodiscard]] bool isBeyond(const Vec3& from, const Vec3& to, double gap) const {
      for (std::uint32_t i = 0; i < count; ++i) {
        if (std::min(tangents[i].at(from), tangents[i].at(to)) >= gap) {
          return true;
        }
      }
      return false;
    }
    void raise(const TriangleGap& gap, const Vec3& te) {
      tangents[2] = tangents[1];
      tangents[1] = tangents[0];
      tangents[0] = {gap.low - gap.slope.dot(te), gap.slope};
      count = std::min(count + 1, 3U);
    }
  };
  class Collect;

  /// Distance of a tool end to the piece of way.
  [[nodiscard]] double toWay(const Vec3& te) const;
  /// How much a gap may have changed by the turn of the axis.
  [[nodiscard]] double turnedBy(const Vec3& axis) const;
  /// No triangle outside the list is nearer than this.
  [[nodiscard]] double beyond(const Vec3& te, const Vec3& axis) const;
  [[nodiscard]] TriangleGap scan(const PlacedBody& body, std::size_t& triangle);
  [[nodiscard]] TriangleGap begin(const PlacedBody& body, std::size_t& triangle) const;
  [[nodiscard]] bool collect(
      const Vec3& from, const Vec3& to, const Vec3& axis, double ceiling, std::size_t limit);
  [[nodiscard]] bool collectAround(const Vec3& te, const Vec3& axis, double gap);
  [[nodiscard]] double below(const TriangleGap& gap,
                             const PlacedBody& here,
                             const PlacedBody& there) const;
  [[nodiscard]] double lowestOf(
      Candidate& c, const PlacedBody& a, const PlacedBody& b, double turn, double aim);

  const surface::MeshShape& shape_;
  Body body_;
  double arm_;  ///< from the tool end to the farthest place of the cutter
  std::vector<Candidate> near_;
  bool seen_ = false, valid_ = false;
  Vec3 from_ = Vec3::Zero(), to_ = Vec3::Zero(), axis_ = Vec3::UnitZ();
  /// Where the tool end was when the list was left, or none: who goes far goes on so, and needs
  /// none.
  Vec3 looked_ = Vec3::Zero();
  double ceiling_ = 0.0;
  double ahead_;  ///< length of the piece of way that is looked at next
};

/// Takes the triangles that a tangent from one measured distance does not exclude.
class NearTriangles::List::Collect {
 public:
  Collect(List& near,
          const Vec3& from,
          const Vec3& to,
          const Vec3& axis,
          double ceiling,
          std::size_t limit)
      : near_(near),
        from_(from),
        to_(to),
        middle_(near.body_, 0.5 * (from + to), axis),
        boxes_(near.body_, 0.5 * (from + to), axis, 0.5 * (to - from)),
        ceiling_(ceiling),
        limit_(limit) {}

  bool enters(const Vec3& center, const Vec3& half) {
    return !full && boxes_.mayReach(center, half, ceiling_);
  }
  void visit(std::size_t i) {
    if (full) {
      return;
    }
    const GapTangent tangent = tangentBelow(middle_, facetOf(near_.shape_, i));
    const Tangent below{tangent.low - tangent.slope.dot(middle_.te()), tangent.slope};
    if (std::min(below.at(from_), below.at(to_)) <= ceiling_) {
      near_.near_.push_back({{below}, static_cast<std::uint32_t>(i), 1});
      full = near_.near_.size() >= limit_;
    }
  }

 private:
  List& near_;
  const Vec3 &from_, &to_;
  PlacedBody middle_;
  TriangleCutter boxes_;
  double ceiling_;
  std::size_t limit_;

 public:
  bool full = false;
};

double NearTriangles::List::toWay(const Vec3& te) const {
  const Vec3 along = to_ - from_;
  const double squared = along.squaredNorm();
  const double share =
      squared > 0.0 ? std::clamp((te - from_).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (te - from_ - share * along).norm();
}

double NearTriangles::List::turnedBy(const Vec3& axis) const {
  return axis == axis_ ? 0.0 : arm_ * (axis - axis_).norm();
}

double NearTriangles::List::beyond(const Vec3& te, const Vec3& axis) const {
  return ceiling_ - toWay(te) - turnedBy(axis);
}

bool NearTriangles::List::collect(
    const Vec3& from, const Vec3& to, const Vec3& axis, double ceiling, std::size_t limit) {
  near_.clear();
  Collect search(*this, from, to, axis, ceiling, limit);
  shape_.tree.search(search);
  valid_ = !search.full;
  from_ = from;
  to_ = to;
  axis_ = axis;
  ceiling_ = ceiling;
  ahead_ = near_.size() < few ? growth * ahead_ : near_.size() > many ? ahead_ / growth : ahead_;
  return valid_;
}

/// The piece of way goes on from the last one.
bool NearTriangles::List::collectAround(const Vec3& te, const Vec3& axis, double gap) {
  const Vec3 gone = te - from_;
  const double distance = gone.norm();
  const bool goesOn =
      valid_ && distance > 0.0 && distance <= jump * (ahead_ + (to_ - from_).norm());
  const Vec3 way = goesOn ? Vec3(ahead_ / distance * gone) : Vec3(Vec3::Zero());
  return collect(te - shareBehind * way, te + (1.0 - shareBehind) * way, axis,
                 gap + margin * ahead_, most);
}

TriangleGap NearTriangles::List::scan(const PlacedBody& body, std::size_t& triangle) {
  TriangleGap least = gapOf(body, facetOf(shape_, triangle));
  const double turned = turnedBy(body.axis());
  for (Candidate& c : near_) {
    if (c.triangle == triangle || c.isBeyond(body.te(), least.gap + turned)) {
      continue;
    }
    const TriangleGap gap = gapOf(body, facetOf(shape_, c.triangle), least.gap);
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

/// What a search begins with: the last triangle, or where the tool has gone far since one that is
/// likely to be nearer.
TriangleGap NearTriangles::List::begin(const PlacedBody& body, std::size_t& triangle) const {
  const TriangleGap last = gapOf(body, facetOf(shape_, triangle));
  const std::size_t other = shape_.tree.likely([&](const Vec3& center, const Vec3& half) {
    const PlacedBody::Away away = body.away(center);
    return away.distance - away.gradient.cwiseAbs().dot(half);
  });
  const TriangleGap gap = gapOf(body, facetOf(shape_, other));
  if (gap.gap < last.gap) {
    triangle = other;
    return gap;
  }
  return last;
}

TriangleGap NearTriangles::List::least(const Vec3& te, const Vec3& axis, std::size_t& triangle) {
  if (!body_.isConvex()) {
    return leastGap(TriangleCutter(body_, te, axis), shape_.mesh, shape_.tree, triangle);
  }
  if (!seen_) {
    // Many look at one place only.
    seen_ = true;
    (void)begin(PlacedBody(body_, te, axis), triangle);
    return leastGap(TriangleCutter(body_, te, axis), shape_.mesh, shape_.tree, triangle);
  }
  const PlacedBody body(body_, te, axis);
  TriangleGap least;
  if (valid_ && toWay(te) <= ahead_) {
    least = scan(body, triangle);
    if (least.gap <= beyond(te, axis)) {
      return least;
    }
  } else {
    least = begin(body, triangle);
    const bool jumps = (te - looked_).norm() > ahead_;
    looked_ = te;
    if (jumps) {
      return leastGap(TriangleCutter(body_, te, axis), shape_.mesh, shape_.tree, triangle);
    }
  }
  if (collectAround(te, axis, least.gap)) {
    return scan(body, triangle);
  }
  least = leastGap(TriangleCutter(body_, te, axis), shape_.mesh, shape_.tree, triangle);
  (void)collectAround(te, axis, least.gap);
  return least;
}

namespace {
/// The lowest place of the higher of two lines over [0, 1].
double lowestOfHigher(double firstFrom, double firstTo, double lastFrom, double lastTo) {
  const double least = std::min(std::max(firstFrom, lastFrom), std::max(firstTo, lastTo));
  const double ahead = firstFrom - lastFrom;
  const double behind = firstTo - lastTo;
  return (ahead > 0.0) == (behind > 0.0)
             ? least
             : std::min(least, firstFrom + ahead / (ahead - behind) * (firstTo - firstFrom));
}
}  // namespace

/// Lower bound of the gap at `there` by the planes that bound it from below at `here`. They stay
/// where they are in space, and the cutter, turned, reaches towards them otherwise.
double NearTriangles::List::below(const TriangleGap& gap,
                                  const PlacedBody& here,
                                  const PlacedBody& there) const {
  const double moved = gap.low + gap.slope.dot(there.te() - here.te());
  if (here.axis() == there.axis()) {
    return moved;
  }
  const auto more = [&](const Vec3& normal) {
    return reach(body_.cutter(), normal.dot(there.axis())) -
           reach(body_.cutter(), normal.dot(here.axis()));
  };
  if (gap.share == 1.0) {
    return moved - more(gap.slope);
  }
  const Vec3 own = (gap.slope - (1.0 - gap.share) * gap.other) / gap.share;
  return moved - gap.share * more(own) - (1.0 - gap.share) * more(gap.other);
}

/// Planes from both ends, where the tangents at hand do not do. How far the cutter reaches towards
/// a plane is the greatest of circular motions: while it turns that bulges by at most turn^2 arm /
/// 8 over the chord of both ends.
double NearTriangles::List::lowestOf(
    Candidate& c, const PlacedBody& a, const PlacedBody& b, double turn, double aim) {
  const Facet facet = facetOf(shape_, c.triangle);
  const double enough = aim + (b.te() - a.te()).norm() + turn * arm_;
  const double bulge = 0.125 * turn * turn * arm_;
  const TriangleGap first = gapOf(a, facet, enough);
  if (turn == 0.0) {
    c.raise(first, a.te());
  }
  if (first.gap >= enough) {
    return aim;  // it changes by no more than the way
  }
  const double firstAtB = below(first, a, b);
  if (std::min(first.low, firstAtB) - bulge >= aim) {
    return aim;
  }
  if (a.te() == b.te() && a.axis() == b.axis()) {
    return first.gap;
  }
  const TriangleGap last = gapOf(b, facet, enough);
  const double lastAtA = below(last, b, a);
  if (std::min(last.low, lastAtA) - bulge >= aim) {
    if (turn == 0.0) {
      c.raise(last, b.te());
    }
    return aim;
  }
  return lowestOfHigher(first.low, firstAtB, lastAtA, last.low) - bulge;
}

double NearTriangles::List::lowest(const Passage& way, double aim) {
  const double slack = margin * ahead_ + way.turn * arm_;
  // What lies between two axes is nowhere farther from a third one than one of them.
  const auto turned = [&] { return std::max(turnedBy(way.axisFrom), turnedBy(way.axisTo)); };
  const auto covers = [&] {
    return ceiling_ - std::max(toWay(way.from), toWay(way.to)) - turned() >= aim;
  };
  if (!valid_ || (way.turn == 0.0 && way.axisFrom != axis_) || !covers()) {
    if (!collect(way.from, way.to, way.axisFrom, aim + slack, most)) {
      (void)collect(way.from, way.to, way.axisFrom, aim + turned(),
                    shape_.mesh.triangles.size() + 1);
    }
  }
  const PlacedBody a(body_, way.from, way.axisFrom);
  const PlacedBody b(body_, way.to, way.axisTo);
  const double more = turned();
  double least = aim;
  for (Candidate& c : near_) {
    if (!c.isBeyond(way.from, way.to, least + more)) {
      least = std::min(least, lowestOf(c, a, b, way.turn, least));
    }
  }
  return least;
}

TriangleGap NearTriangles::least(const surface::MeshShape& shape,
                                 const Profile& cutter,
                                 const Vec3& te,
                                 const Vec3& axis,
                                 std::size_t& triangle) {
  if (!list_) {
    list_ = std::make_shared<List>(shape, cutter);
  }
  return list_->least(te, axis, triangle);
}

double NearTriangles::lowest(const surface::MeshShape& shape,
                             const Profile& cutter,
                             const Passage& way,
                             double aim) {
  if (!list_) {
    list_ = std::make_shared<List>(shape, cutter);
  }
  return list_->lowest(way, aim);
}

}  // namespace arelem::tool
