#include "runtime/motion/facets/touch_heights.h"

#include <cmath>
#include <limits>

namespace arelem::motion {

namespace {
/// Steeper ways are looked at from another side. Dimensionless.
constexpr double steepest = 3.0;
constexpr double leastRise = 0.25;
constexpr int newtonLimit = 40;
/// How often the highest of a list changes before it counts as a steep wall.
constexpr int raiseLimit = 60;
}  // namespace

TouchHeight* TouchNode::of(std::uint32_t index) {
  for (std::size_t i = 0; i < count_; ++i) {
    if (known_[i].index == index) {
      return &known_[i];
    }
  }
  return nullptr;
}

const TouchHeight& TouchNode::add(const TouchHeight& height) {
  std::size_t place = count_;
  if (count_ < known_.size()) {
    ++count_;
  } else {
    place = best_ == 0 ? 1 : 0;
  }
  known_[place] = height;
  if (count_ == 1 || height.z > known_[best_].z) {
    best_ = place;
  }
  return known_[place];
}

std::optional<TouchHeight> TouchHeights::height(std::uint32_t index, const SectionPoint& guess) {
  SectionPoint p = guess;
  for (int i = 0; i < newtonLimit; ++i) {
    const auto m = list_.measure(index, p, std::numeric_limits<double>::infinity());
    const double excess = m.gap - list_.task().low;
    const bool steep =
        m.tangent.byZ < leastRise || std::abs(m.tangent.byS) > steepest * m.tangent.byZ;
    if (std::abs(excess) <= rest_) {
      return steep ? std::nullopt : std::optional(TouchHeight{index, p.z, m.tangent, 0.0, false});
    }
    if (m.tangent.byZ < leastRise) {
      return std::nullopt;
    }
    p.z -= excess / m.tangent.byZ;
  }
  return std::nullopt;
}

/// That of the triangle nearest to a place, as far as that is known without measuring.
std::optional<TouchHeight> TouchHeights::likely(const SectionPoint& guess,
                                                std::span<const std::uint32_t> among) {
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
std::optional<TouchHeight> TouchHeights::nearest(const SectionPoint& guess,
                                                 std::span<const std::uint32_t> among) {
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

std::optional<TouchNode> TouchHeights::node(const SectionPoint& guess,
                                            std::span<const std::uint32_t> among) {
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
      if (m.tangent.byZ < leastRise) {
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

std::optional<TouchHeight> TouchHeights::nearTop(TouchNode& node,
                                                 std::uint32_t index,
                                                 double below) {
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

double TouchHeights::top(double s, TouchHeight& height) {
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

}  // namespace arelem::motion
