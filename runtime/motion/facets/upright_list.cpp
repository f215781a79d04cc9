#include "runtime/motion/facets/upright_list.h"

#include <algorithm>

namespace arelem::motion {

namespace {
/// More triangles than this are too many to be looked at: those that may be touched by where they
/// are and how they look, but are far below. Their next lists know how high the way goes.
constexpr std::size_t crowd = 400;
/// A ball has no level bottom with many triangles below it: with it so many are on rough meshes.
constexpr std::size_t crowdBelowBall = 200;
constexpr int slabsThen = 16;

}  // namespace

UprightList::UprightList(const FacetTask& task, const tool::UprightProfile& profile)
    : frame_(task, profile),
      bounds_(frame_.bounds()),
      places_(UprightPlaces::of(frame_.mesh(), profile, bounds_.radius(), frame_.section().up)),
      lines_(bounds_) {}

UprightList::Line UprightList::line(std::uint32_t index, const Vec3& normal) const {
  return bounds_.lineOf(all_[index].facet, Normal::of(normal));
}

double UprightList::known(std::uint32_t index, double s) const {
  return std::min(all_[index].lines[0].at(s), all_[index].lines[1].at(s));
}

/// Takes the triangles that lines for a few normals do not exclude.
class UprightList::Collect {
 public:
  Collect(UprightList& list, const Way& way, std::size_t limit)
      : list_(list),
        edge_(way),
        lowest_(std::min({way.from.z, way.to.z, way.heightAt(edge_.middle())}) - way.slab -
                std::abs(way.bow) * 0.25 * (way.to.s - way.from.s) * (way.to.s - way.from.s) +
                list.bounds_.profile().f - list.bounds_.profile().r),
        limit_(limit) {}

  bool enters(Doubt& doubt, const Vec3& center, const Vec3& half, const Cover& cover) {
    const Box box = list_.frame_.boxOf(center, half, cover);
    if (full || box.middle.z() + box.half.z() < lowest_ || !list_.frame_.meets(box, doubt)) {
      return false;
    }
    const double middle = doubt.middle();
    const Line line = list_.frame_.lineOf(box, middle);
    if (line.at(middle) >= edge_.at(middle)) {
      if (box.half.x() + box.half.y() > smallBox * (doubt.to - doubt.from)) {
        return true;
      }
    } else if (doubt.isSettled(line, edge_, middle)) {
      return false;
    }
    const Doubt before = doubt;
    return !doubt.isSettled(list_.frame_.lineOf(box, before.from), edge_, before.from) &&
           !doubt.isSettled(list_.frame_.lineOf(box, before.to), edge_, before.to);
  }
  void visit(Doubt doubt, std::size_t i) {
    if (full) {
      return;
    }
    own_.facet = list_.frame_.facetOf(i);
    if (list_.bounds_.isBeside(own_.facet, doubt.middle(), 0.5 * (doubt.to - doubt.from))) {
      return;
    }
    const auto& c = own_.facet.corners;
    const double x = (c[0].x() + c[1].x() + c[2].x()) / 3.0;
    const double y = (c[0].y() + c[1].y() + c[2].y()) / 3.0;
    const auto towards = [&](double s) {
      return list_.bounds_.lineOf(own_.facet, list_.bounds_.normalTowards(x - s, y, own_.facet.up));
    };
    const double middle = doubt.middle();
    own_.lines[0] = own_.lines[1] = towards(middle);
    if (doubt.isSettled(own_.lines[0], edge_, middle)) {
      return;
    }
    if (own_.facet.up.z() >= UprightBounds::usefulRise) {
      own_.lines[1] = list_.bounds_.lineOf(own_.facet, Normal::of(own_.facet.up));
      if (doubt.isSettled(own_.lines[1], edge_, doubt.middle())) {
        return;
      }
    }
    for (int round = 0; round < rounds && !list_.bounds_.isSharp(); ++round) {
      const Doubt before = doubt;
      if (doubt.isSettled(towards(before.from), edge_, before.from) ||
          doubt.isSettled(towards(before.to), edge_, before.to)) {
        return;
      }
      if (doubt.to - doubt.from > shrinks * (before.to - before.from)) {
        break;
      }
    }
    own_.range = {doubt.from, doubt.to};
    own_.number = static_cast<std::uint32_t>(i);
    list_.all_.push_back(own_);
    full = list_.all_.size() >= limit_;
  }
  [[nodiscard]] Doubt all() const { return {edge_.from(), edge_.to()}; }

 private:
  /// Boxes of more than this share of the way that is in doubt leave that to their parts.
  static constexpr double smallBox = 0.5;
  /// Each round takes about half of what is too long; one that takes less is the last.
  static constexpr int rounds = 3;
  static constexpr double shrinks = 0.8;

  UprightList& list_;
  UprightBounds::Edge edge_;
  double lowest_;
  std::size_t limit_;
  Own own_;

 public:
  bool full = false;
};

/// Looks for the triangle that is touched highest at one place.
class UprightList::Highest {
 public:
  Highest(const UprightList& list, const tool::UprightTouch& touch, double s, double floor)
      : height(floor), list_(list), touch_(touch), s_(s) {}

  double height;

  bool enters(Doubt here, const Vec3& center, const Vec3& half, const Cover& cover) {
    const Box box = list_.frame_.boxOf(center, half, cover);
    return list_.frame_.meets(box, here) && list_.frame_.lineOf(box, s_).at(s_) > height;
  }
  void visit(const Doubt& /*here*/, std::size_t i) {
    const tool::UprightFacet facet = list_.frame_.facetOf(i);
    if (list_.bounds_.isBeside(facet, s_, 0.0)) {
      return;
    }
    const auto& c = facet.corners;
    const double x = (c[0].x() + c[1].x() + c[2].x()) / 3.0 - s_;
    const double y = (c[0].y() + c[1].y() + c[2].y()) / 3.0;
    const Normal normal = list_.bounds_.normalTowards(x, y, facet.up);
    if (list_.bounds_.lineOf(facet, normal).at(s_) <= height) {
      return;
    }
    const auto found = touch_.of(facet, s_);
    height = found ? std::max(height, found->z) : height;
  }

 private:
  const UprightList& list_;
  const tool::UprightTouch& touch_;
  double s_;
};

bool UprightList::gather(const Way& way, std::size_t limit) {
  all_.clear();
  near_.clear();
  lines_.clear();
  byPlaces_ = goesByPlaces();
  if (byPlaces_) {
    const bool found = gatherByPlaces(way);
    slabsToCome_ = found ? 0 : slabsThen;
    return found;
  }
  --slabsToCome_;
  Collect search(*this, way, limit);
  frame_.mesh().tree.search(search, search.all());
  return !search.full;
}

bool UprightList::gatherByPlaces(const Way& way) {
  const std::size_t most = bounds_.profile().e > 0.0 ? crowd : crowdBelowBall;
  if (!places_->find(frame_.section(), {way.from.s, way.to.s}, most, found_)) {
    return false;
  }
  for (const UprightPlaces::Found& found : found_) {
    const tool::UprightFacet facet = frame_.facetOf(found.triangle);
    const auto& c = facet.corners;
    const double x = (c[0].x() + c[1].x() + c[2].x()) / 3.0;
    const double y = (c[0].y() + c[1].y() + c[2].y()) / 3.0;
    const double middle = 0.5 * (found.range.first + found.range.last);
    Own own{facet, {}, found.range, found.triangle, false};
    own.lines[0] = own.lines[1] =
        bounds_.lineOf(own.facet, bounds_.normalTowards(x - middle, y, own.facet.up));
    if (own.facet.up.z() >= UprightBounds::usefulRise) {
      own.lines[1] = bounds_.lineOf(own.facet, Normal::of(own.facet.up));
    }
    all_.push_back(own);
  }
  return true;
}

std::optional<double> UprightList::highestAt(double s,
                                             double floor,
                                             const tool::UprightTouch& touch) const {
  Highest search(*this, touch, s, floor);
  frame_.mesh().tree.search(search, Doubt{s, s});
  return search.height > floor ? std::optional(search.height) : std::nullopt;
}

/// Whether the cutter comes to a triangle at all. Those that it covers all the way need no range.
bool UprightList::reaches(Own& own, const Way& way) {
  const double middle = 0.5 * (way.from.s + way.to.s);
  const double half = 0.5 * (way.to.s - way.from.s);
  if (!own.hasRange) {
    if (bounds_.isBeside(own.facet, middle, half)) {
      return false;
    }
    if (bounds_.covers(own.facet, middle, half)) {
      return true;
    }
    const UprightBounds::Range range = bounds_.rangeOf(own.facet);
    own.range.first = std::max(own.range.first, range.first);
    own.range.last = std::min(own.range.last, range.last);
    own.hasRange = true;
  }
  return own.range.first <= way.to.s && own.range.last >= way.from.s;
}

void UprightList::focus(const Way& way) {
  const UprightBounds::Edge edge(way);
  near_.clear();
  lines_.clear();
  for (std::uint32_t i = 0; i < all_.size(); ++i) {
    Own& own = all_[i];
    if (own.range.first > way.to.s || own.range.last < way.from.s ||
        (!byPlaces_ && own.isBelow(edge)) || !reaches(own, way)) {
      continue;
    }
    const auto& c = own.facet.corners;
    const double x = (c[0].x() + c[1].x() + c[2].x()) / 3.0 - edge.middle();
    const double y = (c[0].y() + c[1].y() + c[2].y()) / 3.0;
    own.lines[0] = bounds_.lineOf(own.facet, bounds_.normalTowards(x, y, own.facet.up));
    if (byPlaces_ || !edge.isAbove(own.lines[0])) {
      near_.push_back(i);
      lines_.add(own.facet, own.lines, own.range);
    }
  }
}

}  // namespace arelem::motion
