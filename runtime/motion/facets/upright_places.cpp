#include "runtime/motion/facets/upright_places.h"

#include <algorithm>
#include <cmath>

namespace arelem::motion {

namespace {
/// Normals within this of those of the cutter's side may touch it there.
constexpr double aboveSide = 1e-6;
/// Rectangles are larger than computed by this share of the cutter's radius.
constexpr double slack = 1e-9;
}  // namespace

UprightPlaces::Foot UprightPlaces::footOf(const geometry::NormalCones::Cone& cone) const {
  const tool::UprightProfile& cutter = frame_.bounds().profile();
  const double radius = frame_.bounds().radius();
  const double more = slack * radius;
  Vec3 n = frame_.turned(cone.direction());
  n = n.z() < 0.0 ? Vec3(-n) : n;
  const double around = cone.radius;
  if (cone.isAny() || n.z() - around <= cutter.sinBeta + aboveSide) {
    return {0.0, 0.0, radius + more, radius + more};
  }
  const double lean = std::sqrt(n.x() * n.x() + n.y() * n.y());
  const double arc = cutter.r * around + more;
  if (lean <= around) {
    // With the level bottom too.
    return {cutter.r * n.x(), cutter.r * n.y(), arc + cutter.e, arc + cutter.e};
  }
  // Directions seen from above are within an angle of this sine.
  const double sine = around / lean;
  const double cosine = std::sqrt(1.0 - sine * sine);
  const double x = n.x() / lean;
  const double y = n.y() / lean;
  const double ring = 0.5 * cutter.e * (1.0 + cosine);
  const double thick = 0.5 * cutter.e * (1.0 - cosine);
  const double wide = cutter.e * sine;
  return {cutter.r * n.x() + ring * x, cutter.r * n.y() + ring * y,
          arc + thick * std::abs(x) + wide * std::abs(y),
          arc + thick * std::abs(y) + wide * std::abs(x)};
}

class UprightPlaces::Search {
 public:
  Search(const UprightPlaces& places, std::size_t limit, std::vector<Found>& found)
      : places_(places), limit_(limit), found_(found) {}

  bool enters(UprightBounds::Range& way,
              const Vec3& center,
              const Vec3& half,
              const geometry::NormalCones::Cone& cone) const {
    if (full) {
      return false;
    }
    const Foot foot = places_.footOf(cone);
    const UprightFrame::Extent box = places_.frame_.extentOf(center, half);
    if (std::abs(box.y + foot.y) > box.halfY + foot.halfY) {
      return false;
    }
    const double reach = box.halfX + foot.halfX;
    way.first = std::max(way.first, box.x + foot.x - reach);
    way.last = std::min(way.last, box.x + foot.x + reach);
    return way.first <= way.last;
  }
  void visit(const UprightBounds::Range& way,
             std::uint32_t triangle,
             const geometry::NormalCones::Cone& cone) {
    if (full) {
      return;
    }
    const Foot foot = places_.footOf(cone);
    Found found{places_.frame_.facetOf(triangle), way, triangle};
    const auto& c = found.facet.corners;
    const auto [lowY, highY] = std::minmax({c[0].y(), c[1].y(), c[2].y()});
    if (highY + foot.y < -foot.halfY || lowY + foot.y > foot.halfY) {
      return;
    }
    const auto [lowX, highX] = std::minmax({c[0].x(), c[1].x(), c[2].x()});
    found.range.first = std::max(way.first, lowX + foot.x - foot.halfX);
    found.range.last = std::min(way.last, highX + foot.x + foot.halfX);
    if (found.range.first <= found.range.last) {
      found_.push_back(found);
      full = found_.size() > limit_;
    }
  }

 private:
  const UprightPlaces& places_;
  std::size_t limit_;
  std::vector<Found>& found_;

 public:
  bool full = false;
};

bool UprightPlaces::find(double from,
                         double to,
                         std::size_t limit,
                         std::vector<Found>& found) const {
  found.clear();
  Search search(*this, limit, found);
  frame_.mesh().cones().search(search, UprightBounds::Range{from, to});
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    return a.range.first < b.range.first || (a.range.first == b.range.first && a.number < b.number);
  });
  return !search.full;
}

}  // namespace arelem::motion
