#include "runtime/spray/search.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "ir/space/tolerance.h"
#include "runtime/parallel/crew.h"

namespace arelem::spray {

namespace {

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

Trial evaluateTurned(const Task& task, const Outline& outline, double area, double across) {
  const PassPlan plan = planPasses(outline, rulesFor(task, across));
  Trial trial;
  trial.across = across;
  trial.passes = plan.passes.size();
  trial.complete = plan.complete;
  trial.lengths = plan.lengths;
  trial.operation = operationFor(task.film, plan.interval, task.limits);
  trial.lengths.runUpTime = trial.lengths.runUp / trial.operation.speed;
  trial.cost = costOf(trial.lengths, area, task.film, trial.operation, task.limits, task.prices);
  return trial;
}

/// All sizes at one angle.
std::vector<Trial> trialsAt(const Task& task,
                            double degrees,
                            const std::vector<double>& sizes,
                            bool preferredToo,
                            double area,
                            const std::function<bool()>& stopped) {
  const Outline outline = turned(task.outline, -radians(degrees));
  std::vector<std::pair<double, bool>> all;
  for (const double size : sizes) {
    all.emplace_back(size, false);
  }
  if (preferredToo) {
    const Extent extent = extentOf(outline);
    for (const double size :
         preferredSizes(extent.high.y() - extent.low.y(), task.overlap, task.insetRatio,
                        sizes.front(), sizes.back(), task.mostPasses)) {
      all.emplace_back(size, true);
    }
    std::sort(all.begin(), all.end());
  }
  std::vector<Trial> trials;
  for (const auto& [size, preferred] : all) {
    if (stopped()) {
      break;
    }
    Trial& trial = trials.emplace_back(evaluateTurned(task, outline, area, size));
    trial.degrees = degrees;
    trial.preferred = preferred;
  }
  return trials;
}

std::size_t cheapest(const std::vector<Trial>& trials) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < trials.size(); ++i) {
    const double least = trials[best].cost.total;
    const bool cheaper = trials[i].cost.total < least - tolerance::equalCost * std::abs(least);
    if (trials[i].complete && (cheaper || !trials[best].complete)) {
      best = i;
    }
  }
  return best;
}
}  // namespace

PassRules rulesFor(const Task& task, double across) {
  PassRules rules;
  rules.footprint = {task.aspect * across, across};
  rules.overlap = task.overlap;
  rules.inset = task.insetRatio * across;
  rules.stop = task.stop;
  rules.sharpest = task.sharpest;
  rules.shortestGap = task.shortestGap;
  const double interval = 2.0 * across * (1.0 - task.overlap);
  rules.runUp = task.leadOn * operationFor(task.film, interval, task.limits).speed;
  rules.mostPasses = task.mostPasses;
  return rules;
}

Trial evaluate(const Task& task, double across, double degrees) {
  Trial trial =
      evaluateTurned(task, turned(task.outline, -radians(degrees)), areaOf(task.outline), across);
  trial.degrees = degrees;
  return trial;
}

std::vector<double> Range::values() const {
  std::vector<double> list;
  const double count = step > 0.0 ? std::floor((to - from) / step + tolerance::wholeNumber) : 0.0;
  for (double i = 0.0; i <= count; ++i) {
    list.push_back(from + i * step);
  }
  return list;
}

double preferredSize(double height, double overlap, double insetRatio, int passes) {
  return height / (2.0 * ((passes - 1) * (1.0 - overlap) + insetRatio));
}

double passesFor(double height, double overlap, double insetRatio, double across) {
  return (height - 2.0 * insetRatio * across) / (2.0 * across * (1.0 - overlap)) + 1.0;
}

std::vector<double> preferredSizes(double height,
                                   double overlap,
                                   double insetRatio,
                                   double smallest,
                                   double largest,
                                   std::uint64_t mostPasses) {
  std::vector<double> sizes;
  const double most = std::floor(passesFor(height, overlap, insetRatio, smallest));
  const double least = std::ceil(passesFor(height, overlap, insetRatio, largest));
  for (double n = std::min(most, static_cast<double>(mostPasses)); n >= std::max(least, 1.0); --n) {
    if (n > 1.0 || insetRatio > 0.0) {
      sizes.push_back(preferredSize(height, overlap, insetRatio, static_cast<int>(n)));
    }
  }
  return sizes;
}

SearchSize sizeOfSearch(const Task& task,
                        const Range& sizes,
                        const Range& angles,
                        bool preferredToo) {
  const std::vector<double> widths = sizes.values();
  const Extent extent = extentOf(task.outline);
  const double tallest = (extent.high - extent.low).norm();
  const auto passes = [&](double across) {
    return std::max(1.0, passesFor(tallest, task.overlap, task.insetRatio, across)) + 1.0;
  };
  SearchSize size;
  size.sizes = static_cast<double>(widths.size());
  size.angles = static_cast<double>(angles.values().size());
  size.trials = static_cast<double>(widths.size());
  for (const double across : widths) {
    size.passes += passes(across);
  }
  if (preferredToo && !widths.empty()) {
    const double most = std::min(passes(widths.front()), static_cast<double>(task.mostPasses));
    size.trials += most;
    size.passes += most * (most + 1.0) / 2.0;
  }
  size.trials *= size.angles;
  size.passes *= size.angles;
  return size;
}

SearchResult search(const Task& task,
                    const Range& sizes,
                    const Range& angles,
                    bool preferredToo,
                    const InterruptFlag* interrupted,
                    const Progress& progress) {
  const std::vector<double> degrees = angles.values();
  const std::vector<double> widths = sizes.values();
  const double area = areaOf(task.outline);
  std::vector<std::vector<Trial>> byAngle(degrees.size());
  std::atomic<std::size_t> next = 0;
  std::size_t done = 0;
  std::mutex mutex;
  const auto stopped = [&] {
    return interrupted != nullptr && interrupted->load(std::memory_order_relaxed);
  };
  const auto work = [&] {
    for (std::size_t i = next++; i < degrees.size() && !stopped(); i = next++) {
      byAngle[i] = trialsAt(task, degrees[i], widths, preferredToo, area, stopped);
      const std::lock_guard lock(mutex);
      ++done;
      if (progress) {
        progress(done, degrees.size());
      }
    }
  };
  parallel::withCrew(degrees.size(), work);
  SearchResult result;
  result.complete = !stopped();
  for (std::vector<Trial>& trials : byAngle) {
    std::move(trials.begin(), trials.end(), std::back_inserter(result.trials));
  }
  result.best = cheapest(result.trials);
  return result;
}

}  // namespace arelem::spray
