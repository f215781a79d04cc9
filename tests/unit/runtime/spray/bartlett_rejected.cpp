// The negative controls: rules that the source's text speaks of and that do not give its tables.
#include "tests/unit/runtime/spray/bartlett_case.h"

namespace arelem::spray {

namespace {
/// Passes by the rules that the controls are about: down to the edge ("ymin"), or to the inset
/// above it ("yf"). Nobody offers them; none gives the source's Table 4.2.
Trial byRejectedRule(const Task& task, double b, double degrees, bool toInset) {
  const Outline outline = turned(task.outline, -degrees * std::numbers::pi / 180.0);
  const PassRules rules = rulesFor(task, b);
  const SprayedArea area(outline, rules.footprint, rules.sharpest);
  const Extent extent = extentOf(outline);
  const double interval = 2.0 * b * (1.0 - task.overlap);
  const double last = extent.low.y() + (toInset ? rules.inset : 0.0);
  Trial trial;
  trial.across = b;
  trial.degrees = degrees;
  Vec2 before = Vec2::Zero();
  for (double y = extent.high.y() - rules.inset; y >= last; y -= interval) {
    const Interval pass = area.at(y).at(0);
    const bool toRight = trial.passes % 2 == 0;
    const Vec2 from(toRight ? pass.from : pass.to, y);
    trial.lengths.unpainted += trial.passes > 0 ? (from - before).norm() : 0.0;
    trial.lengths.painted += pass.to - pass.from;
    before = {toRight ? pass.to : pass.from, y};
    ++trial.passes;
  }
  trial.operation = operationFor(task.film, interval, task.limits);
  trial.cost =
      costOf(trial.lengths, areaOf(outline), task.film, trial.operation, task.limits, task.prices);
  return trial;
}

}  // namespace

void BartlettCase::rejected(const Json& given) const {
  std::optional<Trial> best;
  for (const Json& degrees : given.at("thetas_deg")) {
    for (double b = num(given, "b0"); b <= num(given, "b1"); b += num(given, "db")) {
      const Trial trial =
          byRejectedRule(taskOf(given), b, degrees.get<double>(), given.at("stop") == "yf");
      best = !best || trial.cost.total < best->cost.total ? trial : best;
    }
  }
  compare(*best);
}

}  // namespace arelem::spray
