#include "runtime/certify/motion_check.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ir/diag/verify.h"
#include "ir/space/motion_tolerance.h"
#include "ir/space/tolerance.h"

namespace arelem::certify {

namespace {
/// Cosine of the angle within which contact normals agree at a tangency.
constexpr double agreeing = 0.5;

using State = Verdict::State;
}  // namespace

std::string_view spell(ir::Condition condition) {
  constexpr std::array names = {"TO", "TO", "ON", "PAST", "TANTO", "PSTAN"};
  return names.at(static_cast<std::size_t>(condition));
}
std::string_view spell(ir::Heading heading) {
  constexpr std::array names = {"GOLFT", "GORGT", "GOFWD", "GOBACK", "GOUP", "GODOWN"};
  return names.at(static_cast<std::size_t>(heading));
}

void MotionCheck::report(StatementResult& result, const runtime::Action& action, Failure failure) {
  result.good = result.good && failure.row->severity != Severity::error;
  Diagnostic d = at(action.origin, std::move(failure));
  for (auto call = action.calls; call; call = call->outer) {
    d.calledFrom.push_back(call->call);
  }
  sink_.accept(std::move(d));
}

Allowed MotionCheck::allowedFor(const Modal& modal, Role role) const {
  const double inner = modal.inner[role];
  const double outer = modal.outer[role];
  return {inner, outer, options_.beyondBand.value_or(slackOf(inner + outer))};
}

GuideTask MotionCheck::taskOf(const Modal& modal, Role role, Named surface, bool on) const {
  GuideTask task;
  task.surface = std::move(surface);
  task.cutter = on ? nullptr : modal.cutterFor(role);
  task.thick = on ? 0.0 : modal.thick[role];
  task.allowed = allowedFor(modal, role);
  task.startSlack =
      tolerance::startShare * (task.allowed.inner + task.allowed.outer) + tolerance::startLength;
  return task;
}

std::optional<StopCount> MotionCheck::countOf(const Modal& modal,
                                              const Goal& goal,
                                              std::size_t index,
                                              double pathBand,
                                              const Vec3& path,
                                              const Location& first) const {
  if (goal.condition == ir::Condition::tanto || goal.condition == ir::Condition::pstan) {
    return std::nullopt;
  }
  const Role role = index == 0 ? checkRole : secondCheckRole;
  const bool on = goal.condition == ir::Condition::on;
  const StopWanted wanted{goal.condition,
                          goal.nth,
                          on ? nullptr : modal.cutterFor(role),
                          on ? 0.0 : modal.thick[role],
                          allowedFor(modal, role),
                          pathBand,
                          path};
  return StopCount(goal.surface.surface, wanted, first);
}

void MotionCheck::judgeCount(StatementResult& result,
                             const runtime::Action& action,
                             const Goal& goal,
                             const StopCount& count,
                             bool endsThere) {
  if (count.passed()) {
    const Vec3& p = count.passedAt();
    report(result, action,
           fail(diag::StopPassed, spell(goal.condition), goal.surface.name, p.x(), p.y(), p.z(),
                std::uint64_t{count.passedVector() + 1}));
  } else if (endsThere && count.early()) {
    report(
        result, action,
        fail(diag::StopEarly, count.number(), spell(goal.condition), goal.surface.name, goal.nth));
  }
}

void MotionCheck::judgeStop(StatementResult& result,
                            const Modal& modal,
                            const runtime::Action& action,
                            const Goal& goal,
                            std::size_t index,
                            const PathEnd& end,
                            const surface::AnySurface& drive) {
  const Contact contact = contactOf(modal, goal, index, end, drive);
  StopFigures stop{goal.surface.name, std::string(spell(goal.condition)), contact.touch.high,
                   contact.missed() == 0.0};
  const Allowed& a = contact.allowed;
  const bool measuredGood = contact.touch.high >= -a.inner - a.slack;
  if (!stop.good && measuredGood && contact.touch.high <= a.outer + a.slack) {
    report(result, action,
           fail(diag::StopUndecided, stop.condition, stop.surface, contact.touch.low,
                contact.touch.high, 0.0 - a.inner, a.outer));
  } else if (!stop.good && contact.tangent) {
    report(result, action,
           fail(diag::DoesNotTouch, stop.surface, std::abs(contact.touch.high), a.outer));
  } else if (!stop.good) {
    report(result, action,
           fail(diag::StopMissed, contact.touch.high, stop.condition, stop.surface, 0.0 - a.inner,
                a.outer));
  }
  result.stops.push_back(std::move(stop));
}

void MotionCheck::judge(StatementResult& result,
                        const runtime::Action& action,
                        const GuideFigures& figures) {
  const GuideResult& r = figures.result;
  const Verdict& v = r.verdict;
  const Allowed& a = figures.allowed;
  if (v.inner == State::refuted) {
    const Vec3& p = r.leastPlace;
    report(result, action,
           fail(diag::Undercut, -v.least.measured, figures.surface, p.x(), p.y(), p.z(),
                std::uint64_t{r.leastVector + 1}, a.inner, -v.least.measured - a.inner));
  } else if (v.inner == State::undecided) {
    const Vec3& p = r.leastPlace;
    report(result, action,
           fail(diag::ToleranceUndecided, figures.surface, p.x(), p.y(), p.z(),
                std::uint64_t{r.leastVector + 1}, v.least.proven, v.least.measured, 0.0 - a.inner));
  }
  if (v.outer == State::refuted) {
    const Vec3& p = r.greatestPlace;
    report(result, action,
           fail(diag::LeftOff, v.greatest.measured, figures.surface, p.x(), p.y(), p.z(),
                std::uint64_t{r.greatestVector + 1}, a.outer, v.greatest.measured - a.outer));
  } else if (v.outer == State::undecided) {
    const Vec3& p = r.greatestPlace;
    report(
        result, action,
        fail(diag::ToleranceUndecided, figures.surface, p.x(), p.y(), p.z(),
             std::uint64_t{r.greatestVector + 1}, v.greatest.measured, v.greatest.proven, a.outer));
  }
}

/// TLLFT: the drive surface lies to the right of the motion.
void MotionCheck::judgeHand(const Modal& modal,
                            const runtime::Action& action,
                            const GuideFigures& drive,
                            const Vec3& step,
                            const Vec3& axis) {
  if (!modal.driveRelation || options_.own) {  // of our own path W0501 tells
    return;
  }
  const double q = step.normalized().cross(Vec3(-drive.result.firstNormal)).dot(axis);
  const bool left = *modal.driveRelation == Word::TLLFT;
  if (left ? q > tolerance::coincidence : q < -tolerance::coincidence) {
    sink_.accept(diagnose(action.origin, diag::OtherHand, arelem::spell(*modal.driveRelation),
                          drive.surface));
  }
}

double MotionCheck::Contact::missed() const {
  return excess(touch, allowed);
}

/// How the tool touches a surface that guides it, on the side on which it keeps the tolerance.
Touch MotionCheck::touchOf(const Modal& modal,
                           const surface::AnySurface& guide,
                           Role role,
                           const Location& end) const {
  const bool on = role == partRole ? modal.toolOnPart() : modal.toolOnDrive();
  const tool::Profile* cutter = on ? nullptr : modal.cutterFor(role);
  const Allowed keeps = allowedFor(modal, role);
  const Touch plus = touch(guide, {cutter, 1.0, modal.thick[role]}, end, keeps);
  const Touch minus = touch(guide, {cutter, -1.0, modal.thick[role]}, end, keeps);
  // A tool without size is on the side that keeps the tolerance.
  const double apart = excess(minus, keeps) - excess(plus, keeps);
  const bool ofPlus = apart != 0.0 ? apart > 0.0 : std::abs(plus.high) <= std::abs(minus.high);
  return ofPlus ? plus : minus;
}

MotionCheck::Contact MotionCheck::contactOf(const Modal& modal,
                                            const Goal& goal,
                                            std::size_t index,
                                            const PathEnd& at,
                                            const surface::AnySurface& drive) const {
  const Role role = index == 0 ? checkRole : secondCheckRole;
  const bool touchesPart = goal.condition == ir::Condition::pstan;
  Contact c;
  c.tangent = goal.condition == ir::Condition::tanto || touchesPart;
  c.allowed = allowedFor(modal, role);
  const bool on = goal.condition == ir::Condition::on ||
                  (c.tangent && (touchesPart ? modal.toolOnPart() : modal.toolOnDrive()));
  if (on || c.tangent) {
    // Either side of the surface: the whole band counts on both.
    const double band = c.allowed.inner + c.allowed.outer;
    c.allowed.inner = c.tangent ? band : std::max(c.allowed.inner, c.allowed.outer);
    c.allowed.outer = c.allowed.inner;
  }
  const Location& end = at.place();
  if (on) {
    c.touch = touch(goal.surface.surface, {nullptr, 1.0, 0.0}, end, c.allowed);
    return c;
  }
  const tool::Profile* cutter = modal.cutterFor(role);
  const std::array relations = {Relation{cutter, 1.0, modal.thick[role]},
                                Relation{cutter, -1.0, modal.thick[role]}};
  const std::array sides = {touch(goal.surface.surface, relations[0], end, c.allowed),
                            touch(goal.surface.surface, relations[1], end, c.allowed)};
  // TO ends while the tool comes nearer, PAST while it leaves; at a tangency the tool is on the
  // side on which it is of its guide.
  std::optional<Vec3> guideNormal;
  if (c.tangent) {
    guideNormal = touchesPart ? touchOf(modal, modal.partSurface().surface, partRole, end).normal
                              : touchOf(modal, drive, driveRole, end).normal;
  }
  const bool comesNearer = goal.condition == ir::Condition::to;
  const ir::Condition other = comesNearer ? ir::Condition::past : ir::Condition::to;
  const double sign = comesNearer ? -1.0 : 1.0;
  const auto came = [&](std::size_t side, ir::Condition condition) {
    return cameFrom(at, goal.surface.surface, relations[side], condition, c.allowed, sides[side]);
  };
  const auto fits = [&](std::size_t side) {
    const Touch& t = sides[side];
    if (guideNormal) {
      return t.normal.dot(*guideNormal) >= agreeing;
    }
    const bool leads = sign * t.normal.dot(at.towards(t.offset)) >= -glancing;
    return (leads ? !came(side, other) || hasTurned(at, goal.surface.surface, relations[side],
                                                    goal.condition, c.allowed, t)
                  : came(side, goal.condition)) ||
           isTouch(modal, drive, at, goal.surface.surface, relations[side], c.allowed, t,
                   leads && !comesNearer);
  };
  // The nearer one where the path does not tell, but none that it met in the other sense.
  const std::array fit{fits(0), fits(1)};
  bool first = std::abs(sides[0].high) <= std::abs(sides[1].high);
  if (fit[0] != fit[1]) {
    first = fit[0];
  } else if (!fit[0] && !guideNormal && came(first ? 0 : 1, other)) {
    first = !first;
  }
  c.touch = sides[first ? 0 : 1];
  return c;
}

double MotionCheck::missed(const Modal& modal,
                           const Goal& goal,
                           std::size_t index,
                           const PathEnd& end,
                           const surface::AnySurface& drive) const {
  return contactOf(modal, goal, index, end, drive).missed();
}

namespace {
/// The side of a surface on which the tool is before a startup, judged at half its height.
double presentSide(const Modal& modal,
                   const surface::AnySurface& surface,
                   const Location& before,
                   const std::optional<Vec3>& toPast) {
  const double lift = modal.cutter ? modal.cutter->h / 2 : 0.0;
  const Location judged{before.toolEnd + lift * before.axis, before.axis};
  const Touch foot = touch(surface, {nullptr, 1.0, 0.0}, judged, {});
  if (toPast) {
    return toPast->dot(foot.normal) > 0.0 ? -1.0 : 1.0;
  }
  if (std::abs(foot.high) <= tolerance::sameSide) {
    return foot.normal.dot(before.axis) < 0.0 ? -1.0 : 1.0;
  }
  return foot.high < 0.0 ? -1.0 : 1.0;
}
}  // namespace

StatementResult MotionCheck::startup(const Modal& modal,
                                     const runtime::Action& action,
                                     const runtime::Startup& startup,
                                     const Location& before,
                                     const Location& after) {
  StatementResult result;
  result.origin = action.origin;
  result.isn = action.isn;
  result.statement = startup.offset ? "OFFSET" : "GO";
  const auto check = [&](const Named& surface, ir::Condition condition, std::size_t index) {
    const Role role = index == 0 ? driveRole : index == 1 ? partRole : checkRole;
    const bool on = condition == ir::Condition::on;
    const double present = presentSide(modal, surface.surface, before,
                                       modal.surfaceVector[std::min<std::size_t>(index, 2)]);
    const double side = condition == ir::Condition::past ? -present : present;
    Allowed allowed = allowedFor(modal, role);
    if (on) {
      allowed.inner = allowed.outer = std::max(allowed.inner, allowed.outer);
    }
    const Touch t = touch(
        surface.surface, {on ? nullptr : modal.cutterFor(role), on ? 1.0 : side, modal.thick[role]},
        after, allowed);
    const bool good = excess(t, allowed) == 0.0;
    result.stops.push_back({surface.name, std::string(spell(condition)), t.high, good});
    if (!good && t.high >= -allowed.inner - allowed.slack &&
        t.high <= allowed.outer + allowed.slack) {
      report(result, action,
             fail(diag::StopUndecided, spell(condition), surface.name, t.low, t.high,
                  0.0 - allowed.inner, allowed.outer));
    } else if (!good) {
      report(result, action,
             fail(diag::StartupMissed, t.high, spell(condition), surface.name, 0.0 - allowed.inner,
                  allowed.outer));
    }
  };
  for (std::size_t i = 0; i < startup.surfaces.size(); ++i) {
    auto surface = named(startup.surfaces[i].surface);
    if (!surface) {
      report(result, action, fail(diag::NotCertified, surface.failure().message));
      continue;
    }
    const ir::Condition c = startup.surfaces[i].condition;
    check(*surface, c == ir::Condition::automatic ? ir::Condition::to : c, i);
  }
  if (startup.surfaces.size() == 1 && !modal.ignorePart) {
    check(modal.partSurface(), modal.toolOnPart() ? ir::Condition::on : ir::Condition::to, 1);
  }
  return result;
}

}  // namespace arelem::certify
