#include "runtime/spray/passes.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::spray {

namespace {
/// Heights of the passes from the top down.
std::vector<double> heightsOf(const Extent& extent, double interval, const PassRules& rules) {
  std::vector<double> heights;
  const double top = extent.high.y() - rules.inset;
  const double last = extent.low.y() + rules.inset - interval;
  const bool strict = rules.stop == StopRule::strict;
  if (strict && extent.high.y() - extent.low.y() <= 2.0 * rules.inset) {
    return {(extent.high.y() + extent.low.y()) / 2.0};  // one pass in the middle of a strip
  }
  for (std::size_t n = 0; n <= rules.mostPasses; ++n) {
    const double height = top - static_cast<double>(n) * interval;
    if (strict ? height <= last + tolerance::passHeight : height < last) {
      break;
    }
    heights.push_back(height);
  }
  return heights;
}

/// The source's program subtracts the interval again and again; its rounding decides the last pass.
std::vector<double> programHeights(const Extent& extent, double interval, const PassRules& rules) {
  std::vector<double> heights;
  const double last = extent.low.y() - interval + rules.inset;
  for (double height = extent.high.y() - rules.inset;
       height >= last && heights.size() <= rules.mostPasses; height -= interval) {
    heights.push_back(height);
  }
  return heights;
}

void measure(PassPlan& plan, double runUp) {
  const Pass* before = nullptr;
  for (const Pass& pass : plan.passes) {
    const double begin =
        pass.hits.front() - std::copysign(runUp, pass.hits.back() - pass.hits.front());
    if (before != nullptr) {
      plan.lengths.unpainted +=
          std::hypot(begin - before->hits.back(), pass.height - before->height);
    }
    plan.lengths.unpainted += runUp;
    plan.lengths.runUp += runUp;
    for (std::size_t i = 1; i < pass.hits.size(); ++i) {
      const double length = std::abs(pass.hits[i] - pass.hits[i - 1]);
      (i % 2 == 1 ? plan.lengths.painted : plan.lengths.unpainted) += length;
      plan.lengths.runUp += i % 2 == 1 ? 0.0 : std::min(runUp, length);
    }
    before = &pass;
  }
}
}  // namespace

std::vector<Interval> withoutGaps(const std::vector<Interval>& intervals, double gap) {
  std::vector<Interval> result;
  for (const Interval& interval : intervals) {
    if (!result.empty() && interval.from - result.back().to < gap) {
      result.back().to = interval.to;
    } else {
      result.push_back(interval);
    }
  }
  return result;
}

PassPlan planPasses(const Outline& outline, const PassRules& rules) {
  PassPlan plan;
  plan.interval = 2.0 * rules.footprint.across * (1.0 - rules.overlap);
  const Extent extent = extentOf(outline);
  const std::vector<double> heights = rules.stop == StopRule::program
                                          ? programHeights(extent, plan.interval, rules)
                                          : heightsOf(extent, plan.interval, rules);
  plan.complete = heights.size() <= rules.mostPasses;
  if (!plan.complete) {
    return plan;
  }
  const SprayedArea sprayed(outline, rules.footprint, rules.sharpest);
  bool toRight = true;
  for (const double height : heights) {
    Pass pass;
    pass.height = height;
    for (const Interval& piece : withoutGaps(sprayed.at(height), rules.shortestGap)) {
      pass.hits.push_back(piece.from);
      pass.hits.push_back(piece.to);
    }
    if (pass.hits.empty()) {
      continue;
    }
    if (!toRight) {
      std::reverse(pass.hits.begin(), pass.hits.end());
    }
    toRight = !toRight;
    plan.passes.push_back(std::move(pass));
  }
  measure(plan, rules.runUp);
  return plan;
}

}  // namespace arelem::spray
