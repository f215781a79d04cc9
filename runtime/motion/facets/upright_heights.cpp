#include "runtime/motion/facets/upright_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ir/space/tolerance.h"

namespace arelem::motion {

namespace {
constexpr double nowhere = -std::numeric_limits<double>::infinity();
/// Normals that are more level tell nothing of others.
constexpr double usefulRise = 0.05;
/// Arcs of less than so many bands touch elsewhere when they are thickened by the band.
constexpr double thinArc = 8.0;
/// Triangles that are measured for one node, and for one piece of a bottom, at most.
constexpr int nodeLimit = 400;
constexpr int pieceLimit = 60;

std::size_t greatest(const std::vector<double>& values) {
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}
}  // namespace

std::unique_ptr<UprightHeights> UprightHeights::of(const FacetTask& task, double rest) {
  if ((task.section.up - task.axis).norm() > tolerance::rounding) {
    return nullptr;
  }
  const auto low = tool::UprightProfile::of(*task.cutter, task.low);
  const auto high = tool::UprightProfile::of(*task.cutter, task.high);
  return low && high ? std::make_unique<UprightHeights>(task, *low, *high, rest) : nullptr;
}

/// The tangent is that of the normal, whatever was found by it.
TouchHeight UprightHeights::heightOf(std::uint32_t index, const tool::Touch& touch) const {
  const Vec3& n = touch.normal;
  const UprightList::Line line = list_.line(index, n);
  const double base = gap_ - n.z() * line.base;
  return {index, touch.z, {base, n.x(), n.z()}, 0.0, false};
}

/// A side that ends below where it would touch touches lower, if at all: what is touched higher
/// makes that no matter.
std::optional<TouchNode> UprightHeights::wideNode(double s) {
  TouchNode node;
  node.s = s;
  double best = nowhere;
  bool beyond = false;
  for (std::uint32_t i = 0; i < list_.size(); ++i) {
    if (list_.known(i, s) <= best) {
      continue;
    }
    const auto touch = low_.of(list_.facet(i), s);
    if (!touch || touch->z <= best) {
      continue;
    }
    best = touch->z;
    beyond = touch->beyond;
    if (!beyond) {
      node.add(heightOf(i, *touch));
    }
  }
  return best == nowhere || beyond || node.highest().isSteep() ? std::nullopt : std::optional(node);
}

std::optional<TouchNode> UprightHeights::nearNode(double s) {
  TouchNode node;
  node.s = s;
  double best = nowhere;
  bool beyond = false;
  list_.lines().heightsAt(s, above_);
  for (int i = 0; i < nodeLimit; ++i) {
    const std::size_t j = greatest(above_);
    if (above_.empty() || above_[j] <= best + rest_) {
      return best == nowhere || beyond || node.highest().isSteep() ? std::nullopt
                                                                   : std::optional(node);
    }
    const std::uint32_t index = list_.near()[j];
    const auto touch = low_.of(list_.facet(index), s);
    if (!touch) {
      above_[j] = nowhere;
      continue;
    }
    if (touch->normal.z() >= usefulRise) {
      list_.lines().addNormal(touch->normal, s, above_);
    }
    above_[j] = std::min(above_[j], touch->z);
    if (touch->z > best) {
      best = touch->z;
      beyond = touch->beyond;
    }
    if (!touch->beyond) {
      node.add(heightOf(index, *touch));
    }
  }
  return std::nullopt;
}

std::optional<TouchHeight> UprightHeights::nearTop(TouchNode& node,
                                                   std::uint32_t index,
                                                   double below) {
  const double least = node.highest().z - below;
  if (const TouchHeight* known = node.of(index); known != nullptr) {
    return known->z >= least ? std::optional(*known) : std::nullopt;
  }
  if (list_.known(index, node.s) < least) {
    return std::nullopt;
  }
  const auto touch = low_.of(list_.facet(index), node.s);
  if (!touch || touch->beyond || touch->z < least) {
    return std::nullopt;
  }
  const TouchHeight found = heightOf(index, *touch);
  if (found.isSteep()) {
    return std::nullopt;
  }
  return node.add(found);
}

/// The place that touches stays one of the triangle, so that the thicker cutter, above it, is not
/// too far off. What it would touch instead is nearer by next to nothing.
double UprightHeights::top(double s, TouchHeight& height) {
  const double nz = height.tangent.byZ;
  const double nxy = std::sqrt(std::max(0.0, 1.0 - nz * nz));
  const tool::UprightProfile& low = low_.profile();
  const bool round = low.r > 0.0 && low.r >= thinArc * (high_.profile().r - low.r);
  if (!height.hasTop && round && nz > low.sinBeta + tolerance::nullDirection) {
    if (const auto over = high_.over(low.e + low.r * nxy)) {
      height.top = std::max(height.z, height.z + low.f - low.r * nz + *over);
      height.hasTop = true;
    }
  }
  if (!height.hasTop) {
    const auto touch = high_.of(list_.facet(height.index), s);
    height.top = touch && !touch->beyond ? std::max(height.z, touch->z) : height.z;
    height.hasTop = true;
  }
  return height.top;
}

std::optional<double> UprightHeights::penetration(const Bottom& bottom, std::uint32_t skipped) {
  if (bottom.rise <= 0.0) {
    return penetrationOf(bottom.from, bottom.to, skipped);
  }
  const auto first = penetrationOf(bottom.from, bottom.corner, skipped);
  return first ? first : penetrationOf(bottom.corner, bottom.to, skipped);
}

/// Triangles of which no line is below the piece are measured in its middle, then at its ends.
std::optional<double> UprightHeights::penetrationOf(const SectionPoint& from,
                                                    const SectionPoint& to,
                                                    std::uint32_t skipped) {
  list_.lines().excessOver(from, to, above_);
  const SectionPoint middle{0.5 * (from.s + to.s), 0.5 * (from.z + to.z)};
  std::size_t last = above_.size();
  int again = 0;
  for (int i = 0; i < pieceLimit; ++i) {
    const std::size_t j = greatest(above_);
    if (above_.empty() || above_[j] <= 0.0) {
      return std::nullopt;
    }
    const std::uint32_t index = list_.near()[j];
    if (index == skipped) {
      above_[j] = nowhere;
      continue;
    }
    again = j == last ? again + 1 : 0;
    last = j;
    if (again > 2) {
      return middle.s;
    }
    const SectionPoint& p = again == 0 ? middle : again == 1 ? from : to;
    const auto touch = low_.of(list_.facet(index), p.s);
    if (touch && (touch->z > p.z || touch->normal.z() < usefulRise)) {
      return p.s;
    }
    const Vec3& normal = touch ? touch->normal : list_.facet(index).up;
    if (normal.z() >= usefulRise) {
      list_.lines().addNormal(normal, from, to, above_);
    }
  }
  return middle.s;
}

}  // namespace arelem::motion
