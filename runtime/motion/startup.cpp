#include "runtime/motion/startup.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/motion/axis_choice.h"
#include "runtime/motion/nearer.h"
#include "runtime/motion/pierce.h"
#include "runtime/motion/route.h"
#include "runtime/motion/settle.h"
#include "runtime/motion/startup_faults.h"
#include "runtime/motion/startup_sense.h"
#include "runtime/motion/told.h"

namespace arelem::motion {

namespace {
/// Where a position without gaps is missed by so many bands, there is none within them either.
constexpr double nearlyTouching = 10.0;

class Starter {
 public:
  Starter(const State& state, const runtime::Startup& startup) : state_(state), startup_(startup) {}

  Result<Standing> run() {
    if (auto bad = collect()) {
      return *bad;
    }
    for (StartupGoal& goal : goals_) {
      if (auto bad = chooseSide(goal)) {
        return *bad;
      }
    }
    if (auto bad = setAxis()) {
      return *std::move(bad);
    }
    exact_ = goals_.size() <= 2 && partIndex_ && !hasSurfaceVectors() && !state_.direction[1] &&
             goals_[*partIndex_].condition != ir::Condition::past &&
             isPlaneRoute(state_, goals_[0].surface, goals_[*partIndex_].surface, nullptr);
    auto end = startup_.offset ? runOffset() : runGo();
    if (auto bad = end ? behindEnd(goals_, end->toolEnd, end->axis) : std::nullopt) {
      return *std::move(bad);
    }
    return end;
  }

 private:
  static Role roleOf(std::size_t index) {
    return index == 0 ? driveRole : index == 1 ? partRole : checkRole;
  }
  [[nodiscard]] bool hasSurfaceVectors() const {
    return state_.surfaceVector[0] || state_.surfaceVector[1] || state_.surfaceVector[2];
  }

  std::optional<Failure> collect() {
    const auto count = startup_.surfaces.size();
    if (state_.ignorePart && count > 1) {
      return fail(diag::StartupSurfaceCount, static_cast<int>(count));
    }
    for (std::size_t i = 0; i < count; ++i) {
      auto surface = named(startup_.surfaces[i].surface);
      if (!surface) {
        return surface.takeFailure();
      }
      StartupGoal goal;
      goal.surface = *std::move(surface);
      goal.condition = startup_.surfaces[i].condition == ir::Condition::automatic
                           ? ir::Condition::to
                           : startup_.surfaces[i].condition;
      goal.role = roleOf(i);
      goals_.push_back(std::move(goal));
    }
    if (count == 1 && (!state_.ignorePart || state_.automaticPart)) {
      StartupGoal part;
      part.surface = partSurface(state_);
      part.condition = state_.partRelation == Word::TLONPS ? ir::Condition::on : ir::Condition::to;
      part.role = partRole;
      goals_.push_back(std::move(part));
    }
    if (goals_.size() > 1) {
      partIndex_ = 1;
    }
    return std::nullopt;
  }

  /// The side on which the tool ends up: TO the present one, PAST the other one; SRFVCT points from
  /// the one to the other.
  std::optional<Failure> chooseSide(StartupGoal& goal) {
    const auto index = static_cast<std::size_t>(&goal - goals_.data());
    const Vec3 from = sidePoint(state_, state_.toolEnd, state_.axis);
    const surface::Foot foot = footOn(goal.surface.surface, from);
    const bool on = goal.condition == ir::Condition::on;
    double present = foot.distance < 0.0 ? -1.0 : 1.0;
    if (state_.surfaceVector[index]) {
      present = state_.surfaceVector[index]->dot(foot.normal) > 0.0 ? -1.0 : 1.0;
    } else if (std::abs(foot.distance) <= tolerance::sameSide) {
      if (!on && goal.role == driveRole && state_.cutter->maxRadius() > 0.0) {
        return fail(diag::ToolOnSurface, goal.surface.name, foot.distance);
      }
      present = foot.normal.dot(state_.axis) < 0.0 ? -1.0 : 1.0;
    }
    goal.side = goal.condition == ir::Condition::past ? -present : present;
    const tool::Profile* cutter = on ? nullptr : cutterFor(state_, goal.role);
    goal.field =
        makeField(goal.surface.surface, goal.side, {cutter, on ? 0.0 : state_.thick[goal.role]});
    return std::nullopt;
  }

  std::optional<Failure> setAxis() {
    const AxisParty drive = party(goals_[0]);
    const AxisParty part = goals_.size() > 1 ? party(goals_[1]) : AxisParty{};
    auto axis = chooseAxis(state_, goals_.size() > 1 ? &part : nullptr, drive, forward());
    if (!axis) {
      return axis.takeFailure();
    }
    rule_ = *std::move(axis);
    return std::nullopt;
  }

  /// The sense of the motion, for axes that lead: before any motion the way to the third surface.
  [[nodiscard]] Vec3 forward() const {
    constexpr std::size_t third = 2;
    if (state_.forward || goals_.size() <= third) {
      return state_.forward.value_or(Vec3::Zero());
    }
    const surface::Foot foot = footOn(goals_[third].surface.surface, state_.toolEnd);
    return -foot.distance * foot.normal;
  }

  [[nodiscard]] AxisParty party(const StartupGoal& goal) const {
    const bool on = goal.condition == ir::Condition::on;
    return {&goal.surface, goal.side, on, [this, &goal] {
              return makeField(goal.surface.surface, goal.side,
                               {cutterFor(state_, goal.role), state_.thick[goal.role]});
            }};
  }

  /// Seen from the side from which the motions that follow will see it.
  std::unique_ptr<Field> onField(const StartupGoal& goal, const Vec3& near) {
    const auto& surface = goal.surface.surface;
    if (std::abs(footOn(surface, state_.toolEnd).distance) <= tolerance::sameSide) {
      return motion::onField(surface, near, rule_, state_.inner[goal.role],
                             state_.outer[goal.role]);
    }
    const Vec3 normal = footOn(surface, near).normal;
    return makeField(surface, sideSeenOn(normal, rule_.at(near), goal.side), {});
  }

  std::vector<Wanted> wanted(bool atRest, const Vec3& near) {
    // An axis that follows may settle elsewhere for each place that it is asked for.
    const bool hasPath = atRest && !exact_ && rule_.isFixed();
    const Vec3 path = hasPath ? pathOf(goals_, near, rule_.at(near)) : Vec3(Vec3::Zero());
    std::vector<Wanted> list;
    for (StartupGoal& goal : goals_) {
      if (atRest && goal.condition == ir::Condition::on) {
        goal.field = onField(goal, near);
      }
      const double target = atRest ? restGap(*goal.field, near, rule_, state_.inner[goal.role],
                                             state_.outer[goal.role], exact_,
                                             goal.role == checkRole ? Vec3(Vec3::Zero()) : path)
                                   : 0.0;
      list.push_back({goal.field.get(), target});
    }
    return list;
  }

  /// True where the tool keeps all tolerances: in a hollow of its own radius it has no other place
  /// than that without a gap.
  [[nodiscard]] bool isWithin(const Vec3& toolEnd) {
    return std::all_of(goals_.begin(), goals_.end(),
                       [&](const StartupGoal& goal) { return isWithin(goal, toolEnd); });
  }
  [[nodiscard]] double widestBand() const {
    double widest = 0.0;
    for (const StartupGoal& goal : goals_) {
      widest = std::max(widest, state_.band(goal.role));
    }
    return widest;
  }
  [[nodiscard]] bool isWithin(const StartupGoal& goal, const Vec3& toolEnd) {
    const double gap = goal.field->at(toolEnd, rule_.at(toolEnd)).gap;
    return gap >= -state_.inner[goal.role] - tolerance::sameSide &&
           gap <= state_.outer[goal.role] + tolerance::sameSide;
  }

  /// The pseudo surfaces that make the position unique where a direction is given.
  std::vector<Constraint> constraints(const Vec3& from) {
    std::vector<Constraint> list;
    const auto& v = state_.direction[0];
    if (!isGuided_) {
      return list;
    }
    if (exact_ && goals_.size() == 2) {
      const Vec3 toward = v ? *v : goals_[0].field->at(from, state_.axis).normal;
      list.push_back({state_.axis.cross(toward).normalized(), state_.toolEnd});
    } else if (v && goals_.size() == 1) {
      const Vec3 across = v->normalized().unitOrthogonal();
      list.push_back({across, state_.toolEnd});
      list.push_back({v->normalized().cross(across), state_.toolEnd});
    } else if (goals_.size() == 2 && (v.has_value() != state_.direction[1].has_value())) {
      const Vec3& given = v ? *v : *state_.direction[1];
      const auto normal = guidePlane(goals_, given, v ? 0 : 1, {from, rule_.at(from)},
                                     {state_.toolEnd, state_.axis});
      if (normal) {
        list.push_back({*normal, state_.toolEnd});
      }
    }
    return list;
  }

  Result<Standing> runGo() {
    const Led led = leadOf(state_, goals_);
    Vec3 reached = led.toolEnd;
    Settled found = search(led.toolEnd, reached);
    if (led.beyond && (!found.ok || goesBack(found.toolEnd))) {
      Vec3 last = *led.beyond;
      const Settled other = search(*led.beyond, last);
      found = other.ok && (!found.ok || !goesBack(other.toolEnd)) ? other : found;
    }
    if (!found.ok && isOnlyGuided()) {
      // Where directions that guide lead astray, the nearest position is looked for without them.
      Vec3 last = reached;
      isGuided_ = false;
      const Settled other = search(state_.toolEnd, last);
      found = other.ok ? other : found;
    }
    // Where a search ends in vain is anywhere: that with the axis held tells whether there is one.
    if (!found.ok) {
      rule_.startAnew();
    }
    auto bad = rule_.fault(found.ok ? found.toolEnd : reached);
    if (bad && (found.ok || bad->row == diag::AxisImpossible.row)) {
      return *std::move(bad);
    }
    if (!found.ok) {
      Failure none = noPosition(*state_.cutter, goals_, found, led.toolEnd);
      return bad ? std::move(none).withHelp(bad->message) : none;
    }
    return along(found);
  }

  /// Directions of two surfaces, where these are no lines and circles on a plane, and of three.
  [[nodiscard]] bool isOnlyGuided() const {
    const auto& v = state_.direction;
    return goals_.size() > 1 && !exact_ && (v[0] || v[1] || v[2]);
  }
  [[nodiscard]] bool goesBack(const Vec3& toolEnd) const {
    for (std::size_t i = 0; i < goals_.size(); ++i) {
      const auto& v = state_.direction[i];
      if (v && senseOf(state_, *v, toolEnd, goals_[i].role, exact_).back > 0.0) {
        return true;
      }
    }
    return false;
  }

  /// The position to which the conditions lead from a place; `reached` is where the first way ends.
  Settled search(const Vec3& from, Vec3& reached) {
    const auto extra = constraints(from);
    const auto wished = wanted(false, from);
    const bool evenly = rule_.isFixed() && !exact_;
    Settled start = evenly ? measured(from, rule_, wished) : Settled{};
    Settled found = evenly ? settleEvenly(start, rule_, wished, extra)
                    : exact_ && rule_.isFixed()
                        ? settle(from, rule_, wished, extra)
                        : settleInTurn(from, state_.axis, rule_, wished, extra);
    reached = found.toolEnd;
    bool isFirst = true;
    // From far away or across a kink a way may miss what there is; and where surfaces nearly touch
    // each other, only places within the tolerances may be any.
    double missed = 0.0;
    for (const bool atRest : {false, true}) {
      if (!found.ok && (!atRest || missed <= nearlyTouching * widestBand())) {
        isFirst = false;
        rule_.startAnew();
        const Settled near = closest(from, rule_, wanted(atRest, from), extra);
        missed = near.worst;
        const auto goals = wanted(atRest, near.toolEnd);
        const Settled tried = nearestAround(near, from, rule_, goals, extra);
        found = tried.ok || !atRest ? tried : found;
      }
    }
    // Where a direction leads, its wall is the one in front, be another one nearer to that place.
    const bool isLed = found.ok && from != state_.toolEnd;
    if (evenly && !allPlanes(goals_) && !isLed) {
      const auto goals = wanted(false, from);
      start = isFirst ? start : measured(from, rule_, goals);  // by fields that are new
      found = nearer(found, start, rule_, goals, extra);
    }
    if (found.ok && !exact_) {
      const Settled rest = settle(found.toolEnd, rule_, wanted(true, found.toolEnd), extra);
      found = rest.ok || !isWithin(found.toolEnd) ? rest : found;
    }
    // Along lines that a surface shares with another, what is missed shrinks without end.
    found.ok = found.ok && (found.toolEnd - from).norm() <= tolerance::farAway;
    return found;
  }

  /// A position, unless it lies behind the tool on a way that its direction gives exactly.
  [[nodiscard]] Result<Standing> along(const Settled& found) const {
    Standing end{found.toolEnd, found.axis, {}};
    for (std::size_t i = 0; i < goals_.size(); ++i) {
      const StartupGoal& goal = goals_[i];
      if (!state_.direction[i]) {
        continue;
      }
      const Sense sense = senseOf(state_, *state_.direction[i], found.toolEnd, goal.role, exact_);
      const LedTo to{goal.surface.name, goal.condition};
      if (sense.back > 0.0 && i == 0 && (exact_ || goals_.size() == 1)) {
        return behind(to, found.toolEnd, sense);
      }
      if (sense.back > 0.0) {
        end.warnings.push_back(turnsBack(to, sense));
      }
    }
    return end;
  }

  /// OFFSET: along INDIR to the drive surface, along its normal to the relation, along the axis to
  /// the part.
  /// A tool end ON its surface is where it came to it, a cutter at rest in its band.
  Wanted offsetTo(const StartupGoal& goal, const Vec3& near) {
    const double rest = goal.condition == ir::Condition::on
                            ? 0.0
                            : restGap(*goal.field, near, rule_, state_.inner[goal.role],
                                      state_.outer[goal.role], exact_, Vec3::Zero());
    return {goal.field.get(), rest};
  }

  Result<Standing> runOffset() {
    if (!state_.direction[0] || state_.direction[1] || state_.direction[2]) {
      return fail(diag::OffsetNeedsDirection);
    }
    const Vec3 along = state_.direction[0]->normalized();
    const auto hit = pierce(goals_[0].surface.surface, state_.toolEnd, along);
    if (!hit) {
      return offsetMisses(goals_[0].surface, state_.toolEnd, state_.axis, along);
    }
    const Vec3 onDrive = state_.toolEnd + *hit * along;
    const std::array first{offsetTo(goals_[0], onDrive)};
    const Vec3 normal = footOn(goals_[0].surface.surface, onDrive).normal;
    const Vec3 across = normal.unitOrthogonal();
    const std::array alongNormal{Constraint{across, onDrive},
                                 Constraint{normal.cross(across), onDrive}};
    Settled found = settle(onDrive, rule_, first, alongNormal);
    if (found.ok && goals_.size() > 1) {
      const Vec3 e1 = state_.axis.unitOrthogonal();
      const std::array alongAxis{Constraint{e1, found.toolEnd},
                                 Constraint{state_.axis.cross(e1), found.toolEnd}};
      const std::array second{offsetTo(goals_[1], found.toolEnd)};
      found = settle(found.toolEnd, rule_, second, alongAxis);
      found.worstAt = 1;
    }
    if (!found.ok) {
      return diverged(goals_, found);
    }
    if (!isWithin(goals_[0], found.toolEnd)) {
      const double drift = goals_[0].field->at(found.toolEnd, rule_.at(found.toolEnd)).gap;
      return fail(diag::OffsetLeavesDrive, goals_.back().surface.name, goals_[0].surface.name,
                  drift, 0.0 - state_.inner[driveRole], state_.outer[driveRole])
          .withHelp("GO with both surfaces finds the nearest place on both, if there is one");
    }
    return Standing{found.toolEnd, found.axis, {}};
  }

  const State& state_;
  const runtime::Startup& startup_;
  std::vector<StartupGoal> goals_;
  std::optional<std::size_t> partIndex_;
  AxisRule rule_;
  bool exact_ = false, isGuided_ = true;
};
}  // namespace

Result<Standing> startupPosition(const State& state, const runtime::Startup& startup) {
  if (!state.cutter) {
    return fail(diag::CutterUndefined);
  }
  return Starter(state, startup).run();
}

}  // namespace arelem::motion
