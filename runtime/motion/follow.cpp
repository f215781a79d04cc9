#include "runtime/motion/follow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/diag/limits.h"
#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/motion/arc.h"
#include "runtime/motion/direction.h"
#include "runtime/motion/path.h"
#include "runtime/motion/route.h"

namespace arelem::motion {

namespace {
/// Share of the band, beside a fixed length, by which the start may lie outside its band (502,
/// 503).
constexpr double startShare = 0.2;
constexpr double startLength = 5e-5;
/// Interior cut vectors end within this share of the band of the gap aimed at.
constexpr double aimShare = 1e-5;
/// A chord is taken when it could grow by less than this factor.
constexpr double goodFit = 1.01;
constexpr double safety = 0.9995;
/// A stop whose chord leaves the band by this share of the length's square is taken.
constexpr double fitShare = 1e-6;
constexpr int tryLimit = 40;
/// Largest turn of the path over one cut vector.
constexpr double turnCosine = 0.2;
constexpr double fullTurn = 2.0 * std::numbers::pi;

struct Met {
  std::size_t check;
  CheckWatch::Hit hit;
};

class Follower {
 public:
  Follower(const State& state,
           const FollowRequest& request,
           const EmitPoint& emit,
           const Limits& limits,
           const InterruptFlag* interrupted)
      : state_(state), request_(request), emit_(emit), limits_(limits), interrupted_(interrupted) {}

  Result<FollowResult> run() {
    if (!state_.cutter) {
      return fail(diag::CutterUndefined);
    }
    for (const auto setUp : {&Follower::setGuides, &Follower::setChecks, &Follower::setStart}) {
      if (auto bad = (this->*setUp)()) {
        return *bad;
      }
    }
    auto bad = isArc() ? runArc() : runChords([&](const PathPoint& p) { put(p); });
    if (bad) {
      return *bad;
    }
    return result_;
  }

 private:
  Guide& part() { return path_.guides[0]; }
  Guide& drive() { return path_.guides[1]; }
  [[nodiscard]] bool isArc() const {
    return exact_ && std::holds_alternative<surface::Cylinder>(request_.drive.surface);
  }

  // ---- setting up -------------------------------------------------------------------------------

  std::optional<Failure> setGuides() {
    const NamedSurface part = partSurface(state_);
    exact_ = true;
    for (const CheckGoal& c : request_.checks) {
      exact_ = exact_ && c.condition != ir::Condition::pstan &&
               isPlaneRoute(state_, request_.drive, part, &c.surface);
    }
    for (const Role role : {partRole, driveRole}) {
      Guide& g = path_.guides[role];
      g.surface = role == partRole ? part : request_.drive;
      g.inner = state_.inner[role];
      g.outer = state_.outer[role];
      if (!(g.inner + g.outer > 0.0)) {
        return fail(diag::NoBand, g.inner + g.outer);
      }
    }
    path_.axis.fixed = state_.axis;
    const auto kind = state_.axisRule.kind;
    if (kind == runtime::ToolAxis::Kind::normalPart ||
        kind == runtime::ToolAxis::Kind::normalDrive) {
      const NamedSurface& s = kind == runtime::ToolAxis::Kind::normalPart ? part : request_.drive;
      axisField_ = makeField(s.surface, sideAlongAxis(s), {});
      path_.axis.normalTo = axisField_.get();
    }
    part_.emplace(part);
    path_.guides[0].field = guideField(*part_, partRole, state_.toolOnPart);
    path_.guides[1].field = guideField(request_.drive, driveRole, toolOnDrive());
    return std::nullopt;
  }

  [[nodiscard]] double sideAlongAxis(const NamedSurface& s) const {
    return footOn(s.surface, state_.toolEnd).normal.dot(state_.axis) < 0.0 ? -1.0 : 1.0;
  }

  /// TLON by its word, or, where no tool position was ever given, because the tool end is there.
  [[nodiscard]] bool toolOnDrive() const {
    if (state_.driveRelation) {
      return *state_.driveRelation == Word::TLON || *state_.driveRelation == Word::TLNDON;
    }
    const double gap = std::abs(footOn(request_.drive.surface, state_.toolEnd).distance);
    return gap <= state_.band(driveRole) + startLength;
  }

  /// The gap field of a guiding surface, on the side where the tool is.
  std::unique_ptr<Field> guideField(const NamedSurface& s, Role role, bool on) {
    if (on) {
      const Guide& g = path_.guides[role];
      return onField(s.surface, state_.toolEnd, path_.axis, g.inner, g.outer);
    }
    const Tool tool{cutterFor(state_, role), state_.thick[role]};
    auto plus = makeField(s.surface, 1.0, tool);
    auto minus = makeField(s.surface, -1.0, tool);
    const Vec3 axis = path_.axis.at(state_.toolEnd);
    const double gapPlus = std::abs(plus->at(state_.toolEnd, axis).gap);
    const double gapMinus = std::abs(minus->at(state_.toolEnd, axis).gap);
    if (std::abs(gapPlus - gapMinus) <= tolerance::sameSide) {
      return sideAlongAxis(s) < 0.0 ? std::move(minus) : std::move(plus);
    }
    return gapPlus < gapMinus ? std::move(plus) : std::move(minus);
  }

  std::optional<Failure> setChecks() {
    for (std::size_t i = 0; i < request_.checks.size(); ++i) {
      const CheckGoal& goal = request_.checks[i];
      const bool tangent =
          goal.condition == ir::Condition::tanto || goal.condition == ir::Condition::pstan;
      const bool touchesPart = goal.condition == ir::Condition::pstan;
      const NamedSurface& partner = touchesPart ? *part_ : request_.drive;
      if (tangent && goal.surface.isPlane() && partner.isPlane()) {
        return fail(diag::NoTangentWord, partner.name, goal.surface.name);
      }
      const Role role = i == 0 ? checkRole : secondCheckRole;
      const bool on = goal.condition == ir::Condition::on ||
                      (tangent && (touchesPart ? state_.toolOnPart : toolOnDrive()));
      const Tool tool{on ? nullptr : &*state_.cutter, on ? 0.0 : state_.thick[role]};
      const double band = state_.band(role);
      if (!(band > 0.0)) {
        return fail(diag::NoBand, band);
      }
      const double pathBand = state_.band(touchesPart ? partRole : driveRole);
      watches_.emplace_back(goal.surface, goal.condition, goal.nth, tool, band, pathBand);
    }
    return std::nullopt;
  }

  std::optional<Failure> setStart() {
    const Vec3 axis = path_.axis.at(state_.toolEnd);
    for (const Role role : {partRole, driveRole}) {
      const Guide& g = path_.guides[role];
      const double gap = g.field->at(state_.toolEnd, axis).gap;
      const double slack = startShare * (g.inner + g.outer) + startLength;
      if (gap > g.outer + slack || gap < -g.inner - slack) {
        return role == partRole
                   ? fail(diag::OffPartSurface, gap, g.surface.name, -g.inner, g.outer)
                   : fail(diag::OffDriveSurface, gap, g.surface.name, -g.inner, g.outer);
      }
    }
    auto wanted = wantedDirection(request_.heading, state_.forward, axis);
    if (!wanted) {
      return wanted.takeFailure();
    }
    start_ = path_.look(state_.toolEnd, *wanted);
    auto direction = startDirection(request_.heading, *wanted, start_.contacts[0].normal,
                                    start_.contacts[1].normal);
    if (!direction) {
      return direction.takeFailure();
    }
    start_.tangent = *direction;
    warnWrongSide();
    for (Guide& g : path_.guides) {
      g.rest = restGap(*g.field, state_.toolEnd, path_.axis, g.inner, g.outer, exact_);
      g.bend = g.flat() ? 0.0
                        : curvatureAlong(*g.field, state_.toolEnd, path_.axis, start_.tangent,
                                         0.01 * std::sqrt(g.inner + g.outer));
    }
    if (isArc()) {
      // A circle keeps the radius on which the tool stands (spec 4.8).
      drive().rest = std::clamp(start_.contacts[1].gap, -drive().inner, drive().outer);
    }
    for (CheckWatch& w : watches_) {
      w.begin(state_.toolEnd, path_.axis);
    }
    return std::nullopt;
  }

  void warnWrongSide() {
    if (!state_.driveRelation || toolOnDrive() ||
        cutterFor(state_, driveRole)->maxRadius() == 0.0) {
      return;
    }
    // The drive surface lies to the right of the motion when the tool is left of it.
    const double q = start_.tangent.cross(Vec3(-start_.contacts[1].normal)).dot(start_.axis);
    const bool left = *state_.driveRelation == Word::TLLFT;
    if (left ? q > tolerance::coincidence : q < -tolerance::coincidence) {
      result_.warnings.push_back(
          fail(diag::WrongSide, spell(*state_.driveRelation), request_.drive.name));
    }
  }

  // ---- output -----------------------------------------------------------------------------------

  void put(const PathPoint& p) {
    const Vec3 step = p.toolEnd - last_.toolEnd;
    result_.length += step.norm();
    ++result_.cutVectors;
    emit_(p.toolEnd, p.axis);
    part().gapInner = std::min(part().gapInner, p.contacts[0].gap);
    part().gapOuter = std::max(part().gapOuter, p.contacts[0].gap);
    drive().gapInner = std::min(drive().gapInner, p.contacts[1].gap);
    drive().gapOuter = std::max(drive().gapOuter, p.contacts[1].gap);
    result_.forward = step.norm() > 0.0 ? Vec3(step) : p.tangent;
    last_ = p;
  }

  std::optional<Failure> finish(const PathPoint& end) {
    result_.toolEnd = end.toolEnd;
    result_.axis = end.axis;
    result_.partInner = part().gapInner;
    result_.partOuter = part().gapOuter;
    result_.driveInner = drive().gapInner;
    result_.driveOuter = drive().gapOuter;
    return std::nullopt;
  }

  // ---- cut vectors ------------------------------------------------------------------------------

  /// Longest chord that the bands allow by the present curvature.
  [[nodiscard]] double plannedLength(const PathPoint& a) const {
    double length = path_.flat() ? tolerance::farAway : state_.longestVector;
    for (std::size_t i = 0; i < 2; ++i) {
      const Guide& g = path_.guides[i];
      const double from = a.contacts[i].gap;
      length = std::min(length, longestChord(g.bend, from, g.vertexGap(), std::max(g.inner, -from),
                                             std::max(g.outer, from)));
    }
    return length;
  }

  /// The next cut vector from `a`, as long as its bands allow but not longer than `cap`.
  std::optional<PathPoint> advance(const PathPoint& a, double cap) {
    double length = std::min(plannedLength(a), cap);
    const double accept =
        aimShare * std::min(part().inner + part().outer, drive().inner + drive().outer);
    std::optional<PathPoint> best;
    for (int i = 0; i < tryLimit && length > tolerance::sameSide; ++i) {
      const std::array gaps{part().vertexGap(), drive().vertexGap()};
      auto b = path_.step(a, length, gaps, accept);
      if (!b || b->tangent.dot(a.tangent) < turnCosine) {
        length *= 0.5;
        continue;
      }
      const double factor = path_.fit(a, *b);
      if (factor < 1.0 - tolerance::coincidence) {
        // Past an inflection the surface bends the other way than it did: aim at the other edge of
        // the band before shortening the chord.
        if (i == 0 && learnTurn(a, *b)) {
          length = std::min({plannedLength(a), cap, length});
        } else {
          length *= std::max(factor * safety, 0.3);
        }
        continue;
      }
      const bool better =
          !best || (b->toolEnd - a.toolEnd).norm() > (best->toolEnd - a.toolEnd).norm();
      if (better) {
        best = b;
      }
      if (!better || factor < goodFit || length >= cap * safety || length >= state_.longestVector ||
          i > 4) {
        break;
      }
      length = std::min({length * std::min(factor * safety, 2.0), cap, state_.longestVector});
    }
    return best;
  }

  /// Takes over the curvatures of a trial chord where their sign differs; true where one does.
  bool learnTurn(const PathPoint& a, const PathPoint& b) {
    const std::array before{part().bend, drive().bend};
    learnBend(a, b);
    return (part().bend >= 0.0) != (before[0] >= 0.0) ||
           (drive().bend >= 0.0) != (before[1] >= 0.0);
  }

  void learnBend(const PathPoint& a, const PathPoint& b) {
    const Vec3 chord = b.toolEnd - a.toolEnd;
    const double squared = chord.squaredNorm();
    for (std::size_t i = 0; i < 2 && squared > 0.0; ++i) {
      Guide& g = path_.guides[i];
      if (!g.flat()) {
        g.bend = (b.contacts[i].normal - a.contacts[i].normal).dot(chord) / squared;
      }
    }
  }

  static Segment segmentOf(const PathPoint& a, const PathPoint& b) {
    Segment s;
    s.from = a.toolEnd;
    s.direction = b.toolEnd - a.toolEnd;
    s.length = s.direction.norm();
    s.direction = s.length > 0.0 ? Vec3(s.direction / s.length) : a.tangent;
    s.tangentFrom = a.tangent;
    s.tangentTo = b.tangent;
    return s;
  }

  /// The first check surface met on the chord.
  std::optional<Met> scan(const Segment& segment) {
    std::optional<Met> first;
    for (std::size_t i = 0; i < watches_.size(); ++i) {
      Field& partner = watches_[i].usesPart() ? *part().field : *drive().field;
      const auto hit = watches_[i].scan(segment, path_.axis, partner);
      if (hit && (!first || hit->low < first->hit.low)) {
        first = Met{i, *hit};
      }
    }
    return first;
  }

  std::optional<PathPoint> meetCheck(const PathPoint& a, const Segment& segment, const Met& met) {
    const Vec3 near = segment.from + 0.5 * (met.hit.low + met.hit.high) * segment.direction;
    if (!isArc()) {
      for (Guide& g : path_.guides) {
        g.rest =
            restGapAfter(*g.field, near, path_.axis, a.tangent, g.bend, g.inner, g.outer, exact_);
      }
    }
    return meetAtRest(a, segment, met, near);
  }

  std::optional<PathPoint> meetAtRest(const PathPoint& a,
                                      const Segment& segment,
                                      const Met& met,
                                      const Vec3& near) {
    const CheckWatch& watch = watches_[met.check];
    const Role role = met.check == 0 ? checkRole : secondCheckRole;
    const double rest = watch.isTangent() ? 0.0
                                          : restGap(*met.hit.field, near, path_.axis,
                                                    state_.inner[role], state_.outer[role], exact_);
    auto end = meet(path_, a, segment, watch, met.hit, rest);
    if (end) {
      result_.check = met.check;
    }
    return end;
  }

  /// The stop at the band's edge instead of a tenth inside: where that saves a cut vector.
  std::optional<PathPoint> endAtEdge(const PathPoint& a, const Segment& segment, const Met& met) {
    if (exact_) {
      return std::nullopt;
    }
    const auto rests = path_.rests();
    for (Guide& g : path_.guides) {
      g.rest = g.vertexGap();
    }
    auto end = meetAtRest(a, segment, met, a.toolEnd);
    path_.guides[0].rest = rests[0];
    path_.guides[1].rest = rests[1];
    return end;
  }

  [[nodiscard]] Failure lost(const PathPoint& a) const {
    return fail(diag::ContactLost, request_.drive.name, part_->name, a.toolEnd.x(), a.toolEnd.y(),
                a.toolEnd.z());
  }

  [[nodiscard]] Failure notReached() const {
    const CheckWatch& w = watches_.front();
    const Vec3& p = w.nearestPlace();
    if (w.isTangent()) {
      const std::string& partner = w.usesPart() ? part_->name : request_.drive.name;
      return fail(diag::NoTangency, partner, w.surface().name, w.band(), w.nearest());
    }
    return fail(diag::CheckNotReached, w.surface().name, "as asked", w.nearest(), p.x(), p.y(),
                p.z());
  }

  [[nodiscard]] std::optional<Failure> beyondLimits(const PathPoint& a,
                                                    std::uint64_t vectors) const {
    if (interrupted_ != nullptr && interrupted_->load(std::memory_order_relaxed)) {
      return fail(diag::Interrupted);
    }
    const double most = path_.flat() || exact_
                            ? static_cast<double>(limits_.points)
                            : std::min(state_.vectorLimit, static_cast<double>(limits_.points));
    if (static_cast<double>(vectors) >= most) {
      return fail(diag::CutVectorLimit, most, a.toolEnd.x(), a.toolEnd.y(), a.toolEnd.z());
    }
    return std::nullopt;
  }

  /// Walks the path chord by chord until a check surface is met; `accept` gets every cut vector's
  /// end.
  template <class Accept>
  std::optional<Failure> runChords(Accept accept) {
    PathPoint a = last_ = start_;
    double turned = 0.0;
    double cap = tolerance::farAway;
    for (std::uint64_t vectors = 0;; ++vectors) {
      if (auto bad = beyondLimits(a, vectors)) {
        return bad;
      }
      const auto b = advance(a, cap);
      if (!b) {
        return lost(a);
      }
      const Segment segment = segmentOf(a, *b);
      std::vector<CheckWatch::Progress> before;
      for (const CheckWatch& w : watches_) {
        before.push_back(w.progress());
      }
      auto met = scan(segment);
      std::optional<PathPoint> end;
      if (met) {
        end = meetCheck(a, segment, *met);
        const bool tangent = watches_[met->check].isTangent();
        if (!end && !tangent) {
          return lost(a);
        }
        // A near miss: nearest here, but beyond the tolerance.
        if (tangent && !(end && watches_[met->check].touches(
                                    met->hit.field->at(end->toolEnd, end->axis).gap))) {
          met.reset();
        }
      }
      if (met) {
        const double factor = path_.fit(a, *end);
        if (factor >= 1.0 - fitShare || vectors + 1 >= limits_.points) {
          accept(*end);
          return finish(*end);
        }
        if (const auto edge = endAtEdge(a, segment, *met);
            edge && path_.fit(a, *edge) >= 1.0 - fitShare) {
          accept(*edge);
          return finish(*edge);
        }
        // Too long for one: share the rest evenly, so that no tiny vector remains.
        const double rest = (end->toolEnd - a.toolEnd).norm();
        cap = rest / std::max(2.0, std::ceil(1.0 / factor));
        for (std::size_t i = 0; i < watches_.size(); ++i) {
          watches_[i].restore(before[i]);
        }
        if (cap <= tolerance::sameSide) {
          accept(*end);
          return finish(*end);
        }
        continue;
      }
      turned += std::acos(std::clamp(a.tangent.dot(b->tangent), -1.0, 1.0));
      if (path_.flat() || turned > fullTurn * (turnsAllowed() + 1.5)) {
        return notReached();
      }
      accept(*b);
      learnBend(a, *b);
      a = *b;
    }
  }

  /// A closed path that met nothing in this many turns never will.
  [[nodiscard]] double turnsAllowed() const {
    int most = 1;
    for (const CheckGoal& c : request_.checks) {
      most = std::max(most, c.nth);
    }
    return most;
  }

  // ---- circles ----------------------------------------------------------------------------------

  /// A circle on a plane: finds the stop on chords that are not put out, then divides the arc
  /// evenly.
  std::optional<Failure> runArc() {
    std::vector<Vec3> walked{start_.toolEnd};
    auto bad = runChords([&](const PathPoint& p) { walked.push_back(p.toolEnd); });
    if (bad) {
      return bad;
    }
    const auto& circle = std::get<surface::Cylinder>(request_.drive.surface);
    const Vec3 end = result_.toolEnd;
    const ArcPlan plan = planArc(circle, walked, start_.contacts[1], drive().inner, drive().outer);
    last_ = start_;
    for (std::uint64_t k = 1; k < plan.halfSteps; k += 2) {
      if (auto over = beyondLimits(last_, k / 2)) {
        return over;
      }
      Vec3 vertex = plan.vertex(k);
      // Along the axis onto the part plane.
      const tool::Contact c = part().field->at(vertex, state_.axis);
      vertex -= c.gap / c.normal.dot(state_.axis) * state_.axis;
      put(path_.look(vertex, plan.tangent(k)));
    }
    const PathPoint last = path_.look(end, plan.tangent(plan.halfSteps));
    put(last);
    result_.forward = last.tangent;
    return finish(last);
  }

  const State& state_;
  const FollowRequest& request_;
  const EmitPoint& emit_;
  const Limits& limits_;
  const InterruptFlag* interrupted_;
  Path path_;
  std::optional<NamedSurface> part_;
  std::unique_ptr<Field> axisField_;
  std::vector<CheckWatch> watches_;
  PathPoint start_, last_;
  bool exact_ = false;
  FollowResult result_;
};
}  // namespace

Result<FollowResult> follow(const State& state,
                            const FollowRequest& request,
                            const EmitPoint& emit,
                            const Limits& limits,
                            const InterruptFlag* interrupted) {
  return Follower(state, request, emit, limits, interrupted).run();
}

}  // namespace arelem::motion
