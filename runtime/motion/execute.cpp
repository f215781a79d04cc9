#include <chrono>
#include <unordered_map>

#include "ir/diag/limits.h"
#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/motion/direction.h"
#include "runtime/motion/follow.h"
#include "runtime/motion/records.h"
#include "runtime/motion/route.h"
#include "runtime/motion/startup.h"
#include "runtime/run.h"

namespace arelem::runtime {

namespace {
using motion::State;

/// Spreads one to four values over part, drive, check and second check surface: the last one
/// repeats.
std::array<double, 4> spread(const std::vector<double>& values) {
  std::array<double, 4> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = values[std::min(i, values.size() - 1)];
  }
  return all;
}

class Machine {
 public:
  Machine(const std::vector<Action>& actions,
          const Options& options,
          cl::RecordSink& records,
          DiagnosticSink& sink)
      : actions_(actions), options_(options), writer_(records), sink_(sink) {
    for (std::size_t i = 0; i < actions.size(); ++i) {
      if (const auto* label = std::get_if<Label>(&actions[i].body)) {
        labels_.emplace(label->key, i);
      }
    }
  }

  MotionOutcome run() {
    std::uint64_t steps = 0;
    for (index_ = 0; index_ < actions_.size() && !stop_; ++index_) {
      if (interrupted()) {
        report(fail(diag::Interrupted));
        break;
      }
      if (++steps > options_.limits.steps || writer_.count() > options_.limits.records) {
        report(fail(diag::MotionLimit, steps, writer_.count()));
        break;
      }
      const Action& action = actions_[index_];
      if (std::holds_alternative<Label>(action.body)) {
        continue;
      }
      writer_.begin(action);
      std::visit([&](const auto& body) { perform(body); }, action.body);
      writer_.end();
    }
    return std::move(outcome_);
  }

 private:
  const Action& action() const { return actions_[index_]; }
  bool interrupted() const {
    return options_.interrupted != nullptr && options_.interrupted->load(std::memory_order_relaxed);
  }

  // ---- diagnostics
  // --------------------------------------------------------------------------------

  void report(Failure failure) {
    const DiagRow& row = *failure.row;
    const bool isError = row.severity == Severity::error;
    if (row.code == "E0890") {
      stop_ = true;
    }
    if (!row.legacy.empty()) {
      const int number = std::stoi(std::string(row.legacy));
      if (number < 0) {
        writer_.put(cl::Listing{true});
        writer_.put(cl::Diagnostic{number});
        writer_.put(cl::Listing{false});
      } else {
        writer_.put(cl::Diagnostic{number});
      }
    }
    Diagnostic d = at(action().origin, std::move(failure));
    for (auto call = action().calls; call; call = call->outer) {
      d.calledFrom.push_back(call->call);
    }
    for (const EntityPtr& entity : involved()) {
      if (entity && !entity->name.empty() && entity->definition.length > 0) {
        d.labels.push_back({entity->definition, "`" + entity->name + "` defined here"});
      }
    }
    sink_.accept(std::move(d));
    outcome_.complete = outcome_.complete && !isError;
  }

  std::vector<EntityPtr> involved() const {
    std::vector<EntityPtr> list;
    if (const auto* follow = std::get_if<Follow>(&action().body)) {
      list.push_back(follow->drive);
      for (const CheckUse& c : follow->checks) {
        list.push_back(c.use.surface);
      }
    } else if (const auto* startup = std::get_if<Startup>(&action().body)) {
      for (const SurfaceUse& s : startup->surfaces) {
        list.push_back(s.surface);
      }
    }
    return list;
  }

  // ---- positions
  // ----------------------------------------------------------------------------------

  void put(const Vec3& toolEnd, cl::Motion::Kind kind, const std::string& name, int subscript) {
    if (!state_.output) {
      return;
    }
    writer_.startPoints(kind, name, subscript, state_.multax);
    writer_.add(toolEnd, state_.axis);
    writer_.finishPoints();
  }

  void putFeed(const std::optional<double>& feed) {
    if (feed) {
      writer_.put(cl::Post{Word::FEDRAT, "", {*feed}});
    }
  }

  void moveTo(const Vec3& toolEnd) {
    const Vec3 step = toolEnd - state_.toolEnd;
    const bool axial =
        step.cross(state_.axis).norm() <= tolerance::nullDirection * (1.0 + step.norm());
    if (!axial) {
      state_.forward = step;
    }
    state_.toolEnd = toolEnd;
    state_.positioned = true;
  }

  void needPosition() {
    if (!state_.positioned && !warnedNoFrom_) {
      report(fail(diag::NoFrom));
      warnedNoFrom_ = true;
    }
  }

  void fact(const char* statement,
            std::uint64_t vectors,
            double length,
            const motion::FollowResult* r,
            std::chrono::steady_clock::time_point since) {
    MotionFact f;
    f.origin = action().origin;
    f.isn = action().isn;
    f.statement = statement;
    f.cutVectors = vectors;
    f.length = length;
    if (r != nullptr) {
      f.driveInner = r->driveInner;
      f.driveOuter = r->driveOuter;
      f.partInner = r->partInner;
      f.partOuter = r->partOuter;
    }
    f.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
    outcome_.cutVectors += vectors;
    outcome_.facts.push_back(std::move(f));
  }

  void perform(const Locate& l) {
    const auto since = std::chrono::steady_clock::now();
    if (l.axis) {
      if (l.axis->norm() <= tolerance::nullDirection) {
        report(fail(diag::NullIndirection, spell(l.word), l.axis->norm()));
        return;
      }
      state_.axis = l.axis->normalized();
    }
    putFeed(l.feed);
    if (l.word == Word::FROM) {
      const bool first = !state_.positioned;
      const Vec3 before = state_.toolEnd;
      moveTo(l.point);
      if (first) {
        state_.forward.reset();  // the first FROM moves nothing
      }
      put(state_.toolEnd, cl::Motion::Kind::from, l.name, l.subscript);
      fact("FROM", 0, first ? 0.0 : (state_.toolEnd - before).norm(), nullptr, since);
      return;
    }
    const Vec3 before = state_.toolEnd;
    Vec3 target = l.point;
    if (l.word == Word::GODLTA) {
      needPosition();
      target = before + (l.axial ? Vec3(*l.axial * state_.axis) : l.point);
    }
    moveTo(target);
    put(target, cl::Motion::Kind::go, l.axial ? "TLAXIS" : l.name, l.subscript);
    fact(l.word == Word::GODLTA ? "GODLTA" : "GOTO", 1, (target - before).norm(), nullptr, since);
  }

  void takeAutomaticPart() {
    if (state_.automaticPart) {
      motion::NamedSurface plane;
      plane.name = "(AUTOPS)";
      plane.surface = surface::Plane{Vec3::UnitZ(), state_.toolEnd.z()};
      state_.part = plane;
    }
  }

  void consumeOneShots() {
    state_.direction = {};
    state_.surfaceVector = {};
    state_.ignorePart = false;
    state_.automaticPart = false;
  }

  void perform(const Startup& s) {
    const auto since = std::chrono::steady_clock::now();
    needPosition();
    takeAutomaticPart();
    putFeed(s.feed);
    auto found = motion::startupPosition(state_, s);
    if (!found) {
      report(found.takeFailure());
    } else {
      const Vec3 before = state_.toolEnd;
      if (s.surfaces.size() > 1) {
        if (auto part = motion::named(s.surfaces[1].surface); part) {
          state_.part = *std::move(part);
        }
      }
      moveTo(*found);
      turnAxis(s);
      const Entity& first = *s.surfaces[0].surface;
      put(*found, cl::Motion::Kind::go, first.name, first.subscript);
      fact(s.offset ? "OFFSET" : "GO", 1, (*found - before).norm(), nullptr, since);
    }
    consumeOneShots();
  }

  /// The axis at the end of a startup under TLAXIS/NORMPS or NORMDS.
  void turnAxis(const Startup& s) {
    const auto kind = state_.axisRule.kind;
    const motion::NamedSurface part = motion::partSurface(state_);
    std::optional<surface::AnySurface> normalTo;
    if (kind == ToolAxis::Kind::normalPart) {
      normalTo = part.surface;
    } else if (kind == ToolAxis::Kind::normalDrive) {
      if (auto drive = motion::named(s.surfaces[0].surface); drive) {
        normalTo = drive->surface;
      }
    }
    if (normalTo) {
      const Vec3 normal = motion::footOn(*normalTo, state_.toolEnd).normal;
      state_.axis = normal.dot(state_.axis) < 0.0 ? Vec3(-normal) : normal;
    }
  }

  // ---- continuous motion
  // --------------------------------------------------------------------------

  /// The check surface that the next motion implies (spec 4.8), or why there is none.
  Result<motion::CheckGoal> impliedCheck() {
    std::optional<Word> relation = state_.driveRelation;
    for (std::size_t i = index_ + 1; i < actions_.size(); ++i) {
      const auto& body = actions_[i].body;
      if (const auto* r = std::get_if<ToolRelation>(&body)) {
        if (r->word != Word::TLONPS && r->word != Word::TLOFPS) {
          relation = r->word;
        }
      } else if (const auto* next = std::get_if<Follow>(&body)) {
        return impliedBy(*next, relation);
      } else if (std::holds_alternative<Startup>(body) || std::holds_alternative<Locate>(body)) {
        return fail(diag::ImpliedCheckPoint);
      }
    }
    return fail(diag::ImpliedCheckPending);
  }

  static Result<motion::CheckGoal> impliedBy(const Follow& next,
                                             const std::optional<Word>& relation) {
    if (next.heading == ir::Heading::up || next.heading == ir::Heading::down) {
      return fail(diag::ImpliedCheckUpDown, motion::spell(next.heading));
    }
    auto surface = motion::named(next.drive);
    if (!surface) {
      return surface.takeFailure();
    }
    motion::CheckGoal goal;
    goal.surface = *std::move(surface);
    const bool straight = next.heading == ir::Heading::forward || next.heading == ir::Heading::back;
    const bool left = next.heading == ir::Heading::left;
    if (straight) {
      goal.condition = ir::Condition::tanto;
    } else if (!relation || *relation == Word::TLON || *relation == Word::TLNDON) {
      goal.condition = ir::Condition::on;
    } else {
      goal.condition = (*relation == Word::TLLFT) == left ? ir::Condition::to : ir::Condition::past;
    }
    return goal;
  }

  std::optional<Failure> fillChecks(const Follow& f, motion::FollowRequest& request) {
    for (const CheckUse& c : f.checks) {
      auto surface = motion::named(c.use.surface);
      if (!surface) {
        return surface.takeFailure();
      }
      const auto condition =
          c.use.condition == ir::Condition::automatic ? ir::Condition::to : c.use.condition;
      request.checks.push_back({*std::move(surface), condition, c.nth});
    }
    if (f.checks.empty()) {
      auto implied = impliedCheck();
      if (!implied) {
        return implied.takeFailure();
      }
      request.checks.push_back(*std::move(implied));
    }
    return std::nullopt;
  }

  void perform(const Follow& f) {
    const auto since = std::chrono::steady_clock::now();
    needPosition();
    takeAutomaticPart();
    motion::FollowRequest request;
    request.heading = f.heading;
    auto drive = motion::named(f.drive);
    auto bad = drive ? fillChecks(f, request) : std::optional<Failure>(drive.takeFailure());
    if (!bad) {
      request.drive = *std::move(drive);
      bad = runFollow(f, request, since);
    }
    if (bad) {
      report(*std::move(bad));
    }
    consumeOneShots();
  }

  std::optional<Failure> runFollow(const Follow& f,
                                   const motion::FollowRequest& request,
                                   std::chrono::steady_clock::time_point since) {
    // Points wait until the motion is known to succeed: a failed motion puts out none.
    points_.clear();
    const auto keep = [&](const Vec3& toolEnd, const Vec3& axis) {
      points_.push_back({toolEnd, axis});
    };
    auto result = motion::follow(state_, request, keep, options_.limits, options_.interrupted);
    if (!result) {
      return result.takeFailure();
    }
    for (Failure& warning : result->warnings) {
      report(std::move(warning));
    }
    putSequence(f);
    state_.toolEnd = result->toolEnd;
    state_.axis = result->axis;
    state_.forward = result->forward;
    state_.positioned = true;
    lastDrive_ = f.drive;
    fact(motion::spell(f.heading).data(), result->cutVectors, result->length, &*result, since);
    if (result->check < f.checks.size() && f.checks[result->check].label) {
      jump(*f.checks[result->check].label);
    }
    return std::nullopt;
  }

  /// The circle that the points run along, the feed from here on, the points.
  void putSequence(const Follow& f) {
    const Entity& drive = *f.drive;
    const bool round = drive.type == EntityType::circle || drive.type == EntityType::cylinder;
    if (state_.output && round) {
      cl::Surface s;
      s.surface = {drive.type, drive.name, drive.subscript, drive.canon};
      writer_.put(std::move(s));
    }
    putFeed(f.feed);
    if (!state_.output) {
      return;
    }
    writer_.startPoints(cl::Motion::Kind::go, drive.name, drive.subscript, state_.multax);
    for (const Location& p : points_) {
      writer_.add(p.toolEnd, p.axis);
    }
    writer_.finishPoints();
  }

  void jump(std::uint64_t key) {
    // The next place with this label, or, where there is none ahead, the last one behind.
    const auto [first, last] = labels_.equal_range(key);
    std::optional<std::size_t> ahead, behind;
    for (auto i = first; i != last; ++i) {
      if (i->second > index_) {
        ahead = std::min(ahead.value_or(i->second), i->second);
      } else {
        behind = std::max(behind.value_or(i->second), i->second);
      }
    }
    if (ahead || behind) {
      index_ = ahead ? *ahead : *behind;
    } else {
      report(fail(diag::TransferTarget));
    }
  }

  void perform(const Transfer& t) { jump(t.label); }

  // ---- modal statements
  // ---------------------------------------------------------------------------

  void perform(const Direction& d) {
    auto& target = d.word == Word::SRFVCT ? state_.surfaceVector : state_.direction;
    target = {};
    for (std::size_t i = 0; i < 3; ++i) {
      if (!d.values[i]) {
        continue;
      }
      const Vec3 v = d.word == Word::INDIRP ? Vec3(*d.values[i] - state_.toolEnd) : *d.values[i];
      if (v.norm() <= tolerance::nullDirection) {
        report(fail(diag::NullIndirection, spell(d.word), v.norm()));
        return;
      }
      target[i] = v;
    }
    if (d.word != Word::SRFVCT && target[0]) {
      state_.forward = *target[0];
    }
  }

  void perform(const PartSurface& p) {
    auto surface = motion::named(p.surface);
    if (!surface) {
      report(surface.takeFailure());
      return;
    }
    state_.part = *std::move(surface);
  }

  void perform(const ToolRelation& r) {
    if (r.word == Word::TLONPS || r.word == Word::TLOFPS) {
      state_.toolOnPart = r.word == Word::TLONPS;
    } else {
      state_.driveRelation = r.word;
    }
  }

  void perform(const Parameter& p) {
    switch (p.word) {
      case Word::TOLER:
        state_.outer = spread(p.values);
        state_.inner = {};
        writer_.put(cl::Values{Word::OUTTOL, {state_.outer.begin(), state_.outer.end()}});
        writer_.put(cl::Values{Word::INTOL, {0.0, 0.0, 0.0, 0.0}});
        break;
      case Word::INTOL:
        state_.inner = spread(p.values);
        writer_.put(cl::Values{p.word, {state_.inner.begin(), state_.inner.end()}});
        break;
      case Word::OUTTOL:
        state_.outer = spread(p.values);
        writer_.put(cl::Values{p.word, {state_.outer.begin(), state_.outer.end()}});
        break;
      case Word::THICK:
        state_.thick = spread(p.values);
        break;
      case Word::MAXDP:
        state_.longestVector = p.values[0];
        break;
      case Word::NUMPTS:
        state_.vectorLimit = p.values[0];
        break;
      default:
        setCutter(p);
        break;
    }
  }

  void setCutter(const Parameter& p) {
    writer_.put(cl::Values{Word::CUTTER, p.values});
    auto profile = tool::makeProfile(p.values);
    if (!profile) {
      report(profile.takeFailure());
      return;
    }
    state_.cutter = *profile;
    state_.option = {};
  }

  void perform(const CutterOption& o) {
    auto& slot = state_.option[o.surface == 1 ? motion::partRole : motion::driveRole];
    std::vector<double> values{static_cast<double>(o.surface)};
    if (o.ring) {
      slot = tool::makeRing((*o.ring)[0], (*o.ring)[1]);
      values.insert(values.end(), o.ring->begin(), o.ring->end());
    } else {
      slot.reset();
    }
    writer_.put(cl::Values{Word::CUTTER, std::move(values)});
  }

  void perform(const ToolAxis& t) {
    switch (t.kind) {
      case ToolAxis::Kind::vector:
        if (t.vector.norm() <= tolerance::nullDirection) {
          report(fail(diag::NullIndirection, "TLAXIS", t.vector.norm()));
          return;
        }
        state_.axis = t.vector.normalized();
        break;
      case ToolAxis::Kind::keep:
      case ToolAxis::Kind::normalPart:
      case ToolAxis::Kind::normalDrive:
        break;
      case ToolAxis::Kind::parallel:
        report(fail(diag::MotionUnsupported, std::string("TLAXIS/PARLEL")));
        return;
      case ToolAxis::Kind::angle:
        report(fail(diag::MotionUnsupported, std::string("TLAXIS/ATANGL")));
        return;
    }
    state_.axisRule = t;
  }

  void perform(const Toggle& t) {
    switch (t.word) {
      case Word::CUT:
        if (!state_.output) {
          state_.output = true;
          put(state_.toolEnd, cl::Motion::Kind::go, lastDrive_ ? lastDrive_->name : "",
              lastDrive_ ? lastDrive_->subscript : 0);
        }
        writer_.put(cl::Switch{t.word});
        break;
      case Word::DNTCUT:
        state_.output = false;
        writer_.put(cl::Switch{t.word});
        break;
      case Word::MULTAX:
        state_.multax = t.on;
        writer_.put(cl::Multax{t.on});
        break;
      case Word::NOPS:
        state_.ignorePart = true;
        break;
      case Word::AUTOPS:
        state_.automaticPart = true;
        break;
      case Word::W_3DCALC:
      case Word::W_2DCALC:
      case Word::NDTEST:
        state_.alwaysIterate = t.word == Word::W_3DCALC;
        writer_.put(cl::Switch{t.word});
        break;
      default:
        state_.gougeCheck = t.on;
        break;
    }
  }

  void perform(const Pass& p) { writer_.put(p.body); }
  void perform(const Label&) {}
  void perform(const Pocket&) { report(fail(diag::MotionUnsupported, std::string("POCKET"))); }
  void perform(const Fini&) {
    writer_.put(cl::Fini{});
    stop_ = true;
  }

  struct Location {
    Vec3 toolEnd, axis;
  };

  const std::vector<Action>& actions_;
  const Options& options_;
  motion::RecordWriter writer_;
  DiagnosticSink& sink_;
  std::unordered_multimap<std::uint64_t, std::size_t> labels_;
  std::size_t index_ = 0;
  bool stop_ = false;
  bool warnedNoFrom_ = false;
  State state_;
  EntityPtr lastDrive_;
  std::vector<Location> points_;
  MotionOutcome outcome_;
};
}  // namespace

MotionOutcome execute(const std::vector<Action>& actions,
                      const Options& options,
                      cl::RecordSink& records,
                      DiagnosticSink& sink) {
  return Machine(actions, options, records, sink).run();
}

}  // namespace arelem::runtime
