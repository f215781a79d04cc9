#include "runtime/motion/facets/gap_heights.h"

#include <cmath>
#include <limits>

namespace arelem::motion {

namespace {
constexpr int newtonLimit = 40;
/// How often the highest of a list changes before it counts as a steep wall.
constexpr int raiseLimit = 60;
}  // namespace

std::optional<TouchHeight> GapHeights::height(std::uint32_t index, const SectionPoint& guess) {
  SectionPoint p = guess;
  for (int i = 0; i < newtonLimit; ++i) {
    const auto m = list_.measure(index, p, std::numeric_limits<double>::infinity());
    const double excess = m.gap - list_.task().low;
    if (std::abs(excess) <= rest_) {
      const TouchHeight found{index, p.z, m.tangent, 0.0, false};
      return found.isSteep() ? std::nullopt : std::optional(found);
    }
    if (m.tangent.byZ < TouchHeight::leastRise) {
      return std::nullopt;
    }
    p.z -= excess / m.tangent.byZ;
  }
  return std::nullopt;
}

/// That of the triangle nearest to a place, as far as that is known without measuring.
std::optional<TouchHeight> GapHeights::likely(const SectionPoint& guess, Indices among) {
  double least = std::numeric_limits<double>::infinity();
  std::uint32_t found = 0;
  for (const std::uint32_t j : among) {
    const double gap = list_.tangents(j).lowest(guess);
    if (gap < least) {
      least = gap;
      found = j;
    }
  }
  return among.empty() ? std::nullopt : height(found, guess);
}

/// That of the triangle nearest to a place.
std::optional<TouchHeight> GapHeights::nearest(const SectionPoint& guess, Indices among) {
  double least = std::numeric_limits<double>::infinity();
  std::optional<std::uint32_t> found;
  for (const std::uint32_t j : among) {
    if (list_.tangents(j).isBeyond(guess, least)) {
      continue;
    }
    const double gap = list_.measure(j, guess, least).gap;
    if (gap < least) {
      least = gap;
      found = j;
    }
  }
  return found ? height(*found, guess) : std::nullopt;
}

std::optional<TouchNode> GapHeights::node(const SectionPoint& guess, Indices among) {
  std::optional<TouchHeight> best = likely(guess, among);
  if (!best) {
    best = nearest(guess, among);
  }
  if (!best) {
    return std::nullopt;
  }
  TouchNode node;
  node.s = guess.s;
  node.add(*best);
  const double low = list_.task().low - rest_;
  bool raised = true;
  for (int i = 0; raised && i < raiseLimit; ++i) {
    raised = false;
    for (const std::uint32_t j : among) {
      const SectionPoint top = node.point();
      if (node.highest().index == j || list_.tangents(j).isBeyond(top, low)) {
        continue;
      }
      const auto m = list_.measure(j, top, low);
      if (m.gap >= low) {
        continue;
      }
      if (m.tangent.byZ < TouchHeight::leastRise) {
        return std::nullopt;
      }
      const auto higher = height(j, {top.s, top.z + (low - m.gap) / m.tangent.byZ});
      if (!higher) {
        return std::nullopt;
      }
      raised = raised || higher->z > top.z;
      node.add(*higher);
    }
  }
  return raised ? std::nullopt : std::optional(node);
}

std::optional<TouchHeight> GapHeights::nearTop(TouchNode& node, std::uint32_t index, double below) {
  const SectionPoint top = node.point();
  if (const TouchHeight* known = node.of(index); known != nullptr) {
    return known->z >= top.z - below ? std::optional(*known) : std::nullopt;
  }
  // The gap changes by no more than the height.
  const double low = list_.task().low;
  if (list_.tangents(index).isBeyond({top.s, top.z - below}, low + rest_) ||
      list_.measure(index, top, low + below + rest_).gap > low + below + rest_) {
    return std::nullopt;
  }
  const auto found = height(index, top);
  if (!found) {
    return std::nullopt;
  }
  node.add(*found);
  return found->z >= top.z - below ? found : std::nullopt;
}

double GapHeights::top(double s, TouchHeight& height) {
  if (height.hasTop) {
    return height.top;
  }
  const double low = list_.task().low;
  const double high = list_.task().high;
  const double rise = (high - low) / height.tangent.byZ;
  const double gap =
      list_.measure(height.index, {s, height.z + rise}, std::numeric_limits<double>::infinity())
          .gap;
  // The gap is convex: below its chord.
  height.top = height.z + (gap <= high ? rise : rise * (high - low - rest_) / (gap - low - rest_));
  height.hasTop = true;
  return height.top;
}

/// Where a triangle may come through the bottom of a cell, or between bottom and top.
std::optional<double> GapHeights::penetrationBy(const Bottom& bottom, std::uint32_t j) {
  const double low = list_.task().low;
  bool first = false;
  bool second = false;
  const auto see = [&](const Tangent& t) {
    const double more = t.byZ < 0.0 ? above * band_ * t.byZ : 0.0;
    const double middle = t.at(bottom.corner) + more;
    if (middle >= low) {
      first = first || t.at(bottom.from) + more >= low;
      second = second || t.at(bottom.to) + more >= low;
    }
    return first && second;
  };
  const SectionTriangles::Tangents& known = list_.tangents(j);
  for (std::uint32_t i = 0; i < known.count; ++i) {
    if (see(known.last[i])) {
      return std::nullopt;
    }
  }
  const auto between = [](const SectionPoint& a, const SectionPoint& b) {
    return SectionPoint{0.5 * (a.s + b.s), 0.5 * (a.z + b.z)};
  };
  for (int i = 0; i < 4; ++i) {
    const SectionPoint p = i == 0   ? !first && !second ? bottom.corner
                                      : first           ? between(bottom.corner, bottom.to)
                                                        : between(bottom.from, bottom.corner)
                             : i == 1 ? bottom.corner
                           : i == 2 ? bottom.from
                                    : bottom.to;
    const auto m = list_.measure(j, p, low);
    if (m.gap < low) {
      return p.s;
    }
    if (see(m.tangent)) {
      return std::nullopt;
    }
  }
  return bottom.corner.s;
}

std::optional<double> GapHeights::penetration(const Bottom& bottom, std::uint32_t skipped) {
  for (const std::uint32_t j : list_.near()) {
    if (j == skipped) {
      continue;
    }
    if (const auto s = penetrationBy(bottom, j)) {
      return s;
    }
  }
  return std::nullopt;
}

}  // namespace arelem::motion
