#include <cmath>

#include "ir/diag/interpret.h"
#include "runtime/interpret/expression.h"
#include "runtime/interpret/motion.h"
#include "runtime/motion/direction.h"

namespace arelem::runtime::interpret {

namespace {

constexpr double mostIntersections = 1000000.0;
constexpr std::string_view startupForms =
    "GO/[{TO|ON|PAST},]ds[,[{TO|ON|PAST},]ps[,[{TO|ON|PAST|TANTO},]cs]][,feed]";

bool isSurface(EntityType type) {
  return type != EntityType::point && type != EntityType::vector && type != EntityType::matrix &&
         type != EntityType::pattern;
}

EntityPtr surfaceArgument(State& state, const ir::Argument& argument, std::string_view statement) {
  const std::optional<Item> item = evaluate(state, argument, Use::motion);
  return item ? surfaceOf(state, *item, statement) : nullptr;
}

/// The optional feed at the end; false when it was written but has no value.
bool feedOf(State& state, ir::ExprId expr, std::optional<double>& feed) {
  if (!expr.valid()) {
    return true;
  }
  feed = scalar(state, expr);
  return feed.has_value();
}

bool checkUse(State& state,
              const ir::CheckUse& check,
              ir::BlockId block,
              std::string_view word,
              CheckUse& out) {
  out.use.condition = check.use.condition;
  out.use.surface = surfaceArgument(state, check.use.surface, word);
  if (check.label) {
    out.label = std::uint64_t{block.index} << 32U | check.label->statement;
  }
  if (!check.nth.valid()) {
    return out.use.surface != nullptr;
  }
  const std::optional<double> nth = scalar(state, check.nth);
  if (!nth) {
    return false;
  }
  if (*nth < 1.0 || *nth > mostIntersections || *nth != std::round(*nth)) {
    state.report(diagnose(state.program[check.nth].span, diag::IntersectionNumber, *nth));
    return false;
  }
  out.nth = static_cast<int>(*nth);
  return out.use.surface != nullptr;
}

bool countsFit(State& state, const ir::Follow& follow, std::string_view word) {
  const Span& span = state.statement->span;
  const bool axial = follow.heading == ir::Heading::up || follow.heading == ir::Heading::down;
  if (axial && follow.checks.empty()) {
    state.report(diagnose(span, diag::MotionArguments, word, "no check surface",
                          fmt::format("{}/ds,[{{TO|ON|PAST}},]cs[,feed]", word)));
    return false;
  }
  const std::uint64_t most = state.options.limits.checks;
  if (follow.checks.size() > most) {
    state.report(diagnose(span, diag::CheckCount, follow.checks.size(), most));
    return false;
  }
  for (std::size_t i = 0; i < follow.checks.size() && follow.checks.size() > 1; ++i) {
    if (!follow.checks[i].label) {
      state.report(diagnose(follow.checks[i].use.surface.span, diag::CheckLabel, i + 1,
                            follow.checks.size()));
      return false;
    }
  }
  return true;
}

}  // namespace

EntityPtr surfaceOf(State& state, const Item& item, std::string_view statement) {
  const EntityPtr* entity = item.entity();
  if (entity == nullptr) {
    state.report(diagnose(item.span, diag::MotionOperand, statement, describe(item),
                          "surfaces by name or as (TYPE/...)"));
    return nullptr;
  }
  if (!isSurface((*entity)->type)) {
    reportAt(state, item.span, fail(diag::NoSurfaceType, arelem::spell((*entity)->type), statement),
             {item});
    return nullptr;
  }
  return *entity;
}

void execute(State& state, const ir::Startup& startup) {
  const std::string_view word = startup.offset ? "OFFSET" : "GO";
  state.meetImplied(word, false, true);
  state.warnOfSystem();
  const std::size_t most = startup.offset ? 2 : 3;
  if (startup.surfaces.empty() || startup.surfaces.size() > most) {
    state.report(diagnose(state.statement->span, diag::MotionArguments, word,
                          fmt::format("{} surfaces", startup.surfaces.size()),
                          startup.offset ? "OFFSET/[m,]ds[,[m,]ps]" : startupForms));
    return;
  }
  Startup action;
  action.offset = startup.offset;
  bool good = feedOf(state, startup.feed, action.feed);
  for (std::size_t i = 0; i < startup.surfaces.size(); ++i) {
    const ir::SurfaceUse& use = startup.surfaces[i];
    const bool tangent =
        use.condition == ir::Condition::tanto || use.condition == ir::Condition::pstan;
    if (tangent && (i < 2 || use.condition == ir::Condition::pstan)) {
      state.report(diagnose(use.conditionSpan, diag::MotionWord, word,
                            use.condition == ir::Condition::tanto ? "TANTO" : "PSTAN",
                            startupForms));
      good = false;
    }
    EntityPtr surface = surfaceArgument(state, use.surface, word);
    good = good && surface;
    action.surfaces.push_back({std::move(surface), use.condition});
  }
  if (good) {
    state.emit(std::move(action));
  }
}

void execute(State& state, const ir::Follow& follow, ir::BlockId block) {
  const std::string_view word = motion::spell(follow.heading);
  const bool axial = follow.heading == ir::Heading::up || follow.heading == ir::Heading::down;
  state.meetImplied(word, axial, false);
  state.warnOfSystem();
  if (!countsFit(state, follow, word)) {
    return;
  }
  Follow action;
  action.heading = follow.heading;
  action.drive = surfaceArgument(state, follow.drive, word);
  bool good = action.drive != nullptr;
  for (const ir::CheckUse& check : follow.checks) {
    good = checkUse(state, check, block, word, action.checks.emplace_back()) && good;
  }
  good = feedOf(state, follow.feed, action.feed) && good;
  if (follow.checks.empty()) {
    state.expectImplied();
  }
  if (good) {
    state.emit(std::move(action));
  }
}

}  // namespace arelem::runtime::interpret
