#include "runtime/motion/course.h"

#include <algorithm>
#include <cmath>

#include "ir/diag/motion.h"
#include "ir/space/motion_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/motion/axis_choice.h"
#include "runtime/motion/direction.h"
#include "runtime/motion/modal.h"
#include "runtime/motion/route.h"
#include "runtime/motion/told.h"

namespace arelem::motion {

namespace {
/// Distance over which curvature is measured, as a share of the square root of the band.
constexpr double probeShare = 0.01;

class Planner {
 public:
  Planner(const State& state, const FollowRequest& request) : state_(state), request_(request) {}

  Result<Course> run() {
    course_.part = partSurface(state_);
    course_.drive = request_.drive;
    for (const auto step : {&Planner::setGuides, &Planner::checkStart, &Planner::setAxis,
                            &Planner::setChecks, &Planner::setDirection}) {
      if (auto bad = (this->*step)()) {
        return *std::move(bad);
      }
    }
    setRests();
    return std::move(course_);
  }

 private:
  Guide& guide(Role role) { return course_.path.guides[role]; }
  const NamedSurface& surfaceOf(Role role) const {
    return role == partRole ? course_.part : course_.drive;
  }

  std::optional<Failure> setGuides() {
    course_.exact = true;
    for (const CheckGoal& c : request_.checks) {
      course_.exact = course_.exact && c.condition != ir::Condition::pstan &&
                      isPlaneRoute(state_, course_.drive, course_.part, &c.surface);
    }
    for (const Role role : {partRole, driveRole}) {
      guide(role).inner = state_.inner[role];
      guide(role).outer = state_.outer[role];
      if (!(state_.band(role) > 0.0)) {
        return fail(diag::NoBand, surfaceOf(role).name);
      }
    }
    course_.onDrive = toolOn(driveRole);
    onPart_ = toolOn(partRole);
    guide(partRole).field =
        !onPart_ && touching_ ? std::move(touching_) : guideField(partRole, onPart_);
    guide(driveRole).field = guideField(driveRole, course_.onDrive);
    return std::nullopt;
  }

  std::optional<Failure> setAxis() {
    auto wanted = wantedDirection(request_.heading, state_.forward, state_.lastAcross, state_.axis);
    if (!wanted) {
      return wanted.takeFailure();
    }
    wanted_ = *wanted;
    const AxisParty part = party(partRole, onPart_);
    auto axis = chooseAxis(state_, &part, party(driveRole, course_.onDrive), wanted_);
    if (!axis) {
      return axis.takeFailure();
    }
    course_.path.axis = *std::move(axis);
    for (Guide& g : course_.path.guides) {
      g.turning = !course_.path.axis.isFixed();
    }
    course_.path.axis.hold(state_.toolEnd);
    return course_.path.axis.fault(state_.toolEnd);
  }

  AxisParty party(Role role, bool on) {
    const NamedSurface& s = surfaceOf(role);
    return {&s, sideAlongAxis(s), on, [this, role] { return guideField(role, false); }};
  }

  [[nodiscard]] double sideAlongAxis(const NamedSurface& s) const {
    return footOn(s.surface, state_.toolEnd).normal.dot(state_.axis) < 0.0 ? -1.0 : 1.0;
  }

  /// ON by its word (TLON, TLONPS), or, where no such word was ever given, because the tool end is
  /// there and the cutter does not touch.
  [[nodiscard]] bool toolOn(Role role) {
    const double slack = state_.band(role) + tolerance::startLength;
    if (role == driveRole) {
      if (state_.driveRelation) {
        return *state_.driveRelation == Word::TLON || *state_.driveRelation == Word::TLNDON ||
               staysOn();
      }
      return std::abs(footOn(course_.drive.surface, state_.toolEnd).distance) <= slack;
    }
    if (state_.partRelation) {
      return *state_.partRelation == Word::TLONPS;
    }
    if (state_.touchesPart) {
      return false;  // an axis that TLAXIS turned since may have led the cutter off it
    }
    touching_ = guideField(partRole, false);
    const double offset = touching_->at(state_.toolEnd, state_.axis).gap;
    return std::abs(offset) > slack &&
           std::abs(footOn(course_.part.surface, state_.toolEnd).distance) <= slack;
  }

  /// Under TLLFT or TLRGT the old system ran a tool end that was on a line along it, as under TLON.
  [[nodiscard]] bool staysOn() const { return state_.staysOn && oldSystemStaysOn(); }

  [[nodiscard]] bool oldSystemStaysOn() const {
    const auto* line = std::get_if<surface::Plane>(&course_.drive.surface);
    const tool::Profile* cutter = cutterFor(state_, driveRole);
    const double slack = state_.band(driveRole) + tolerance::startLength;
    return line != nullptr && cutter->maxRadius() > slack && state_.thick[driveRole] == 0.0 &&
           std::abs(line->normal.dot(state_.axis)) <= tolerance::symmetric &&
           std::abs(footOn(course_.drive.surface, state_.toolEnd).distance) <= slack;
  }

  /// The gap field of a guiding surface, on the side where the tool is.
  std::unique_ptr<Field> guideField(Role role, bool on) {
    const NamedSurface& s = surfaceOf(role);
    if (on) {
      AxisRule axis(state_.axis);
      return onField(s.surface, state_.toolEnd, axis, state_.inner[role], state_.outer[role]);
    }
    const Tool tool{cutterFor(state_, role), state_.thick[role]};
    if (std::holds_alternative<surface::Mesh>(s.surface) && !tool.cutter->isPoint() &&
        !tool.cutter->ring) {
      return makeField(s.surface, sideAlongAxis(s), tool);  // its gap is the same on both sides
    }
    // The cutter reaches at least as far as its rim, where the gap on the other side begins.
    const double rim = rimDistance(s, *tool.cutter);
    const double likely = rim < 0.0 ? -1.0 : 1.0;
    auto near = makeField(s.surface, likely, tool);
    const double gapNear = near->at(state_.toolEnd, state_.axis).gap;
    if (std::abs(gapNear) + tolerance::sameSide < std::abs(rim) + tool.thick) {
      return near;
    }
    auto far = makeField(s.surface, -likely, tool);
    const double gapFar = far->at(state_.toolEnd, state_.axis).gap;
    double apart = std::abs(gapFar) - std::abs(gapNear);
    if (std::abs(apart) <= tolerance::sameSide) {
      // A tool without size is on the side that keeps the tolerance.
      apart = outside(role, gapFar) - outside(role, gapNear);
    }
    if (std::abs(apart) <= tolerance::sameSide) {
      return undecidedSide(role, s) == likely ? std::move(near) : std::move(far);
    }
    return apart > 0.0 ? std::move(near) : std::move(far);
  }

  /// The side of a tool without size that keeps the tolerance on both: at the drive surface that of
  /// TLLFT or TLRGT, else that towards the axis, if there is one.
  [[nodiscard]] double undecidedSide(Role role, const NamedSurface& s) const {
    const Vec3 normal = footOn(s.surface, state_.toolEnd).normal;
    const bool byWord =
        role == driveRole && state_.driveRelation &&
        (*state_.driveRelation == Word::TLLFT || *state_.driveRelation == Word::TLRGT);
    const auto way =
        byWord ? wantedDirection(request_.heading, state_.forward, state_.lastAcross, state_.axis)
               : Result<Vec3>(Vec3(Vec3::Zero()));
    if (way) {
      const double left = normal.dot(state_.axis.cross(*way));
      if (std::abs(left) > tolerance::nullDirection) {
        return (left > 0.0) == (*state_.driveRelation == Word::TLLFT) ? 1.0 : -1.0;
      }
    }
    return normal.dot(state_.axis) < -tolerance::nullDirection ? -1.0 : 1.0;
  }

  /// How far a gap is outside the band.
  [[nodiscard]] double outside(Role role, double gap) const {
    return std::max({0.0, -state_.inner[role] - gap, gap - state_.outer[role]});
  }

  /// Signed distance of one place of the upper rim of the cutter.
  [[nodiscard]] double rimDistance(const NamedSurface& s, const tool::Profile& cutter) const {
    const Vec3 out = state_.axis.unitOrthogonal();
    const Vec3 place = state_.toolEnd + cutter.sideEnd.rho * out + cutter.sideEnd.z * state_.axis;
    return footOn(s.surface, place).distance;
  }

  std::optional<Failure> setChecks() {
    for (std::size_t i = 0; i < request_.checks.size(); ++i) {
      const CheckGoal& goal = request_.checks[i];
      const bool tangent =
          goal.condition == ir::Condition::tanto || goal.condition == ir::Condition::pstan;
      const Role partner = goal.condition == ir::Condition::pstan ? partRole : driveRole;
      if (tangent && goal.surface.isPlane() && surfaceOf(partner).isPlane()) {
        return fail(diag::NoTangentWord, surfaceOf(partner).name, goal.surface.name);
      }
      const Role role = i == 0 ? checkRole : secondCheckRole;
      const bool on = goal.condition == ir::Condition::on ||
                      (tangent && (partner == partRole ? onPart_ : course_.onDrive));
      const Tool tool{on ? nullptr : &*state_.cutter, on ? 0.0 : state_.thick[role]};
      if (!(state_.band(role) > 0.0)) {
        return fail(diag::NoBand, goal.surface.name);
      }
      const StopBand allowed{state_.inner[role], state_.outer[role]};
      course_.watches.emplace_back(goal.surface, goal.condition, goal.nth, tool, allowed,
                                   state_.band(partner));
    }
    return std::nullopt;
  }

  std::optional<Failure> checkStart() {
    for (const Role role : {partRole, driveRole}) {
      const Guide& g = guide(role);
      const double gap = g.field->at(state_.toolEnd, state_.axis).gap;
      const double slack = tolerance::startShare * (g.inner + g.outer) + tolerance::startLength;
      if (gap > g.outer + slack || gap < -g.inner - slack) {
        const std::string& name = surfaceOf(role).name;
        if (auto bad = role == driveRole && gap < 0.0 ? doesNotFit() : std::nullopt) {
          return bad;
        }
        Failure off = role == partRole
                          ? fail(diag::OffPartSurface, gap, name, 0.0 - g.inner, g.outer)
                          : fail(diag::OffDriveSurface, gap, name, 0.0 - g.inner, g.outer);
        if (turnsWhereItStands()) {
          return std::move(off).withHelp(
              "TLAXIS turns a tool that stands about its end: it belongs before the startup");
        }
        const std::string_view help = asTheOtherWord(role, slack);
        return help.empty() ? off : std::move(off).withHelp(std::string(help));
      }
    }
    return std::nullopt;
  }

  /// What to write where the tool is in the tolerance of the other word: ON or in contact.
  std::string_view asTheOtherWord(Role role, double slack) {
    const Guide& g = guide(role);
    const bool on = role == driveRole ? course_.onDrive : onPart_;
    const double gap = on ? guideField(role, false)->at(state_.toolEnd, state_.axis).gap
                          : std::abs(footOn(surfaceOf(role).surface, state_.toolEnd).distance);
    if (gap > g.outer + slack || gap < -g.inner - slack) {
      return {};
    }
    if (role == partRole) {
      return on ? "the cutter touches it: TLOFPS keeps it so, TLONPS needs a startup ON it"
                : "the tool end is on it: TLONPS keeps it so, TLOFPS needs a startup TO it";
    }
    if (on) {
      return "the cutter touches it: TLLFT and TLRGT keep it so, TLON needs a startup ON it";
    }
    return oldSystemStaysOn()
               ? "the tool end is on it: TLON keeps it so, TLLFT and TLRGT need a startup TO or "
                 "PAST it (--dialect apt360 goes ON it as the old system did)"
               : "the tool end is on it: TLON keeps it so, TLLFT and TLRGT need a startup TO or "
                 "PAST it";
  }

  /// True where a TLAXIS with a vector may have turned the tool away from its surfaces.
  [[nodiscard]] bool turnsWhereItStands() const {
    const runtime::ToolAxis& rule = state_.axisRule;
    return rule.kind == runtime::ToolAxis::Kind::vector && rule.vector != Vec3::UnitZ();
  }

  /// A tool that gouges because it stands in a hollow of the drive surface that is narrower than
  /// it.
  [[nodiscard]] std::optional<Failure> doesNotFit() const {
    const NamedSurface& s = course_.drive;
    const Vec3 p = told(state_.toolEnd);
    const double side = footOn(s.surface, state_.toolEnd).distance < 0.0 ? -1.0 : 1.0;
    const double radius = course_.onDrive ? 0.0 : cutterFor(state_, driveRole)->maxRadius();
    const double hollow = hollowRadius(s.surface, side, state_.toolEnd);
    if (!(radius > hollow)) {
      return std::nullopt;
    }
    return fail(diag::CutterDoesNotFit, radius, s.name, hollow, radius - hollow, p.x(), p.y(),
                p.z());
  }

  std::optional<Failure> setDirection() {
    const Vec3 axis = course_.path.axis.at(state_.toolEnd);
    course_.turnsFirst = (axis - state_.axis).norm() > tolerance::nullDirection;
    PathPoint& start = course_.start;
    // A tool that is to turn first goes where the contacts lead that it has.
    start = course_.turnsFirst ? course_.path.lookWith(state_.toolEnd, state_.axis, wanted_)
                               : course_.path.look(state_.toolEnd, wanted_);
    auto direction = startDirection(request_.heading, wanted_, start.contacts[0].normal,
                                    start.contacts[1].normal, state_.toolEnd);
    if (!direction) {
      return direction.takeFailure();
    }
    start.face(*direction);
    warnWrongSide();
    warnOnByDefault();
    warnOnAsItStands();
    for (CheckWatch& w : course_.watches) {
      const double away = footOn(w.surface().surface, state_.toolEnd).distance;
      if (auto bad = tooFarOut(state_, checkRole, std::abs(away))) {
        return bad;
      }
      w.begin(state_.toolEnd, state_.axis);
    }
    return std::nullopt;
  }

  void setRests() {
    for (Guide& g : course_.path.guides) {
      g.rest = restGap(*g.field, state_.toolEnd, course_.path.axis, g.inner, g.outer, course_.exact,
                       course_.start.tangent);
      g.startAnew(g.flat() ? 0.0
                           : curvatureAlong(*g.field, state_.toolEnd, course_.path.axis,
                                            course_.start.tangent,
                                            probeShare * std::sqrt(g.inner + g.outer)));
    }
    const double gap = course_.start.contacts[1].gap;
    if (course_.isArc() || (course_.exact && std::abs(gap) > tolerance::sameSide)) {
      // A circle keeps the radius on which the tool stands (spec 4.8), a line the distance.
      Guide& drive = guide(driveRole);
      drive.rest = std::clamp(gap, -drive.inner, drive.outer);
    }
  }

  /// Contours of lines without TLLFT or TLRGT run beside their lines up to where a check surface is
  /// implied: there the rule takes the tool onto the next one.
  void warnOnByDefault() {
    if (course_.onDrive || cutterFor(state_, driveRole)->maxRadius() == 0.0) {
      return;
    }
    for (const CheckGoal& goal : request_.checks) {
      if (goal.onByDefault) {
        course_.warnings.push_back(fail(diag::OnByDefault, goal.surface.name, course_.drive.name));
      }
    }
  }

  void warnOnAsItStands() {
    const auto relation = state_.driveRelation;
    if (course_.onDrive && (relation == Word::TLLFT || relation == Word::TLRGT)) {
      course_.warnings.push_back(fail(diag::OnAsItStands, spell(*relation), course_.drive.name,
                                      cutterFor(state_, driveRole)->maxRadius()));
    }
  }

  void warnWrongSide() {
    if (!state_.driveRelation || course_.onDrive ||
        cutterFor(state_, driveRole)->maxRadius() == 0.0) {
      return;
    }
    // The drive surface lies to the right of the motion when the tool is left of it.
    const PathPoint& start = course_.start;
    const double q = start.tangent.cross(Vec3(-start.contacts[1].normal)).dot(start.axis);
    const bool left = *state_.driveRelation == Word::TLLFT;
    if (left ? q > tolerance::coincidence : q < -tolerance::coincidence) {
      Failure wrong = fail(diag::WrongSide, spell(*state_.driveRelation), course_.drive.name);
      if (request_.heading == ir::Heading::back) {
        wrong.help = fmt::format("the way back has on its left what was on the right: {}",
                                 left ? "TLRGT" : "TLLFT");
      }
      course_.warnings.push_back(std::move(wrong));
    }
  }

  const State& state_;
  const FollowRequest& request_;
  Course course_;
  bool onPart_ = false;              ///< the tool end, not the cutter, is at the part surface
  std::unique_ptr<Field> touching_;  ///< of the cutter and the part surface, if that was looked at
  Vec3 wanted_ = Vec3::UnitX();      ///< direction of the GO word
};
}  // namespace

Result<Course> planCourse(const State& state, const FollowRequest& request) {
  return Planner(state, request).run();
}

}  // namespace arelem::motion
