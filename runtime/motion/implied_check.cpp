#include "runtime/motion/implied_check.h"

#include "ir/diag/motion.h"
#include "runtime/motion/direction.h"
#include "runtime/motion/route.h"

namespace arelem::motion {

namespace {
Result<CheckGoal> impliedBy(const runtime::Follow& next, const std::optional<Word>& relation) {
  if (next.heading == ir::Heading::up || next.heading == ir::Heading::down) {
    return fail(diag::ImpliedCheckUpDown, spell(next.heading));
  }
  auto surface = named(next.drive);
  if (!surface) {
    return surface.takeFailure();
  }
  CheckGoal goal;
  goal.surface = *std::move(surface);
  const bool straight = next.heading == ir::Heading::forward || next.heading == ir::Heading::back;
  const bool left = next.heading == ir::Heading::left;
  if (straight) {
    goal.condition = ir::Condition::tanto;
  } else if (!relation || *relation == Word::TLON || *relation == Word::TLNDON) {
    goal.condition = ir::Condition::on;
    goal.onByDefault = !relation;
  } else {
    goal.condition = (*relation == Word::TLLFT) == left ? ir::Condition::to : ir::Condition::past;
  }
  return goal;
}
}  // namespace

Result<CheckGoal> impliedCheck(const std::vector<runtime::Action>& actions,
                               std::size_t index,
                               std::optional<Word> relation) {
  for (std::size_t i = index + 1; i < actions.size(); ++i) {
    const auto& body = actions[i].body;
    if (const auto* r = std::get_if<runtime::ToolRelation>(&body)) {
      if (r->word != Word::TLONPS && r->word != Word::TLOFPS) {
        relation = r->word;
      }
    } else if (const auto* next = std::get_if<runtime::Follow>(&body)) {
      return impliedBy(*next, relation);
    } else if (std::holds_alternative<runtime::Startup>(body) ||
               std::holds_alternative<runtime::Locate>(body)) {
      return fail(diag::ImpliedCheckPoint);
    }
  }
  return fail(diag::ImpliedCheckPending);
}

Result<std::vector<CheckGoal>> checkGoals(const std::vector<runtime::Action>& actions,
                                          std::size_t index,
                                          const runtime::Follow& follow,
                                          std::optional<Word> relation) {
  std::vector<CheckGoal> goals;
  for (const runtime::CheckUse& c : follow.checks) {
    auto surface = named(c.use.surface);
    if (!surface) {
      return surface.takeFailure();
    }
    const auto condition =
        c.use.condition == ir::Condition::automatic ? ir::Condition::to : c.use.condition;
    goals.push_back({*std::move(surface), condition, c.nth, false});
  }
  if (follow.checks.empty()) {
    auto implied = impliedCheck(actions, index, relation);
    if (!implied) {
      return implied.takeFailure();
    }
    goals.push_back(*std::move(implied));
  }
  return goals;
}

}  // namespace arelem::motion
