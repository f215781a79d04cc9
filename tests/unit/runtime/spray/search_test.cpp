// The search for the least cost: the source's tables in the language of the tests, speed and order.
#include "runtime/spray/search.h"

#include <cmath>

#include <gtest/gtest.h>

#include "runtime/spray/inset.h"
#include "runtime/spray/overlap.h"

namespace arelem::spray {
namespace {

Task rectangle(StopRule stop) {
  Task task;
  task.outline.loops = {{{0, 0}, {1000, 0}, {1000, 800}, {0, 800}}};
  task.film = 0.051;
  task.aspect = 0.7;
  task.overlap = 0.175;
  task.stop = stop;
  task.insetRatio =
      stop == StopRule::program ? programInset : *insetByMean(Profile::ellipse(), task.overlap);
  task.limits = {1000.0, literPerMinute, 0.65};
  task.prices = {60.0, 10.0, 2.0, 2.0};
  return task;
}

TEST(Search, Table42) {
  const SearchResult found =
      search(rectangle(StopRule::program), {20, 75, 2}, {0, 90, 90}, false, nullptr, {});
  const Trial& best = found.trials[found.best];
  EXPECT_NEAR(best.cost.total, 0.9127, 6e-5);
  EXPECT_DOUBLE_EQ(best.across, 62.0);
  EXPECT_DOUBLE_EQ(best.degrees, 0.0);
  EXPECT_EQ(found.trials.size(), 56U);
}

TEST(Search, PreferredSizesAreCheaper) {
  const Task task = rectangle(StopRule::strict);
  const SearchResult plain = search(task, {20, 75, 2}, {0, 0, 0}, false, nullptr, {});
  const SearchResult all = search(task, {20, 75, 2}, {0, 0, 0}, true, nullptr, {});
  const Trial& best = all.trials[all.best];
  EXPECT_TRUE(best.preferred);
  EXPECT_LT(best.cost.total, plain.trials[plain.best].cost.total);
  // A preferred size fills the height with whole passes: the last lies an inset above the edge.
  const PassPlan plan = planPasses(task.outline, rulesFor(task, best.across));
  EXPECT_NEAR(plan.passes.back().height, task.insetRatio * best.across, 1e-6);
  EXPECT_NEAR(plan.passes.front().height, 800.0 - task.insetRatio * best.across, 1e-9);
}

TEST(Search, EqualCostsGoToTheSmallerAngleThenTheSmallerSize) {
  Task square = rectangle(StopRule::strict);
  square.outline.loops = {{{0, 0}, {800, 0}, {800, 800}, {0, 800}}};
  const SearchResult found = search(square, {60, 60, 0}, {0, 360, 90}, false, nullptr, {});
  EXPECT_EQ(found.best, 0U);
}

TEST(Search, Example2) {
  // The ranges of the source's example 2: 16 sizes at 73 angles; its outline is in a figure only,
  // so an L of its size stands for it. How long it takes is in bench/.
  Task task = rectangle(StopRule::program);
  task.outline.loops = {{{0, 0}, {1000, 0}, {1000, 400}, {500, 400}, {500, 900}, {0, 900}}};
  const SearchResult found = search(task, {40, 70, 2}, {0, 360, 5}, false, nullptr, {});
  EXPECT_EQ(found.trials.size(), 16U * 73U);
  // Half a turn changes nothing but the way round.
  const auto cost = [&found](std::size_t angle, std::size_t size) {
    return found.trials[16 * angle + size].cost.total;
  };
  EXPECT_NEAR(cost(0, 3), cost(72, 3), 1e-12);
}

TEST(Search, ItsSizeIsKnownBefore) {
  const Task task = rectangle(StopRule::strict);
  const Range sizes = {40, 70, 2};
  const Range angles = {0, 90, 5};
  const SearchResult found = search(task, sizes, angles, true, nullptr, {});
  double passes = 0.0;
  for (const Trial& trial : found.trials) {
    passes += static_cast<double>(trial.passes);
  }
  const SearchSize size = sizeOfSearch(task, sizes, angles, true);
  EXPECT_EQ(size.sizes, 16U);
  EXPECT_EQ(size.angles, 19U);
  EXPECT_GE(size.trials, static_cast<double>(found.trials.size()));
  EXPECT_GE(size.passes, passes);
  EXPECT_LE(size.passes, 4.0 * passes);
}

TEST(Search, TrialsThatAreCutShortAreNotTheBest) {
  // 800 mm by passes of half width .001 are more than 100 000; what was planned of them is cheap.
  const Task task = rectangle(StopRule::strict);
  const SearchResult found = search(task, {0.001, 50.001, 50}, {0, 0, 0}, false, nullptr, {});
  ASSERT_EQ(found.trials.size(), 2U);
  EXPECT_FALSE(found.trials[0].complete);
  EXPECT_TRUE(found.trials[1].complete);
  EXPECT_EQ(found.best, 1U);
}

TEST(Search, StopsAtAnInterrupt) {
  const InterruptFlag stop = true;
  const SearchResult found =
      search(rectangle(StopRule::strict), {20, 75, 2}, {0, 90, 90}, false, &stop, {});
  EXPECT_FALSE(found.complete);
}

TEST(Search, RepeatsExactly) {
  const Task task = rectangle(StopRule::strict);
  const SearchResult a = search(task, {40, 70, 2}, {0, 90, 5}, true, nullptr, {});
  const SearchResult b = search(task, {40, 70, 2}, {0, 90, 5}, true, nullptr, {});
  ASSERT_EQ(a.trials.size(), b.trials.size());
  for (std::size_t i = 0; i < a.trials.size(); ++i) {
    EXPECT_EQ(a.trials[i].cost.total, b.trials[i].cost.total);
  }
}

}  // namespace
}  // namespace arelem::spray
