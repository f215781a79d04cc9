#include <chrono>
#include <unordered_map>

#include "ir/diag/limits.h"
#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/motion/direction.h"
#include "runtime/motion/follow.h"
#include "runtime/motion/implied_check.h"
#include "runtime/motion/modal.h"
#include "runtime/motion/motion_output.h"
#include "runtime/motion/pocket.h"
#include "runtime/motion/records.h"
#include "runtime/motion/reporter.h"
#include "runtime/motion/route.h"
#include "runtime/motion/startup.h"
#include "runtime/run.h"

namespace arelem::runtime {

namespace {
using motion::State;

class Machine {
 public:
  Machine(const std::vector<Action>& actions,
          const Options& options,
          cl::RecordSink& records,
          DiagnosticSink& sink)
      : actions_(actions), options_(options), writer_(records), reporter_(writer_, sink) {
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
    outcome_.complete = !reporter_.failed();
    return std::move(outcome_);
  }

 private:
  const Action& action() const { return actions_[index_]; }
  bool interrupted() const {
    return options_.interrupted != nullptr && options_.interrupted->load(std::memory_order_relaxed);
  }

  void report(Failure failure) {
    reporter_.report(action(), std::move(failure));
    stop_ = stop_ || reporter_.fatal();
  }
  void reportIf(std::optional<Failure> failure) {
    if (failure) {
      report(*std::move(failure));
    }
  }

  void put(const Vec3& toolEnd, cl::Motion::Kind kind, const std::string& name, int subscript) {
    if (!state_.output) {
      return;
    }
    writer_.startPoints(kind, name, subscript, state_.multax);
    writer_.add(toolEnd, state_.axis);
    writer_.finishPoints();
  }

  /// FROM or GOTO: with the side of the tool where the statement gives one, MULTAX or not.
  void putPlace(const Locate& l) {
    if (l.side && state_.output) {
      const Vec3 square = *l.side - l.side->dot(state_.axis) * state_.axis;
      writer_.putPose(l, state_.axis, square.normalized());
      return;
    }
    put(l.point, l.word == Word::FROM ? cl::Motion::Kind::from : cl::Motion::Kind::go, l.name,
        l.subscript);
  }

  void putFeed(const std::optional<double>& feed) {
    if (feed) {
      writer_.putFeed(*feed);
    }
  }

  void moveTo(const Vec3& toolEnd) {
    const Vec3 step = toolEnd - state_.toolEnd;
    const bool axial =
        step.cross(state_.axis).norm() <= tolerance::nullDirection * (1.0 + step.norm());
    if (!axial) {
      state_.forward = state_.lastAcross = step;
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
      state_.axisRule = {};  // fixed from here on
    }
    putFeed(l.feed);
    if (l.word == Word::FROM) {
      const bool first = !state_.positioned;
      const Vec3 before = state_.toolEnd;
      moveTo(l.point);
      if (first) {
        state_.forward.reset();  // the first FROM moves nothing
        state_.lastAcross.reset();
      }
      putPlace(l);
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
    if (l.word == Word::GOTO) {
      putPlace(l);
    } else {
      put(target, cl::Motion::Kind::go, l.axial ? "TLAXIS" : l.name, l.subscript);
    }
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

  void perform(const Startup& s) {
    if (state_.cutterRefused) {
      return;
    }
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
      moveTo(found->toolEnd);
      state_.axis = found->axis;
      const Entity& first = *s.surfaces[0].surface;
      put(found->toolEnd, cl::Motion::Kind::go, first.name, first.subscript);
      fact(s.offset ? "OFFSET" : "GO", 1, (found->toolEnd - before).norm(), nullptr, since);
    }
    motion::forgetOneShots(state_);
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
      auto implied = motion::impliedCheck(actions_, index_, state_.driveRelation);
      if (!implied) {
        return implied.takeFailure();
      }
      request.checks.push_back(*std::move(implied));
    }
    return std::nullopt;
  }

  void perform(const Follow& f) {
    if (state_.cutterRefused) {
      return;
    }
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
    reportIf(std::move(bad));
    motion::forgetOneShots(state_);
  }

  std::optional<Failure> runFollow(const Follow& f,
                                   const motion::FollowRequest& request,
                                   std::chrono::steady_clock::time_point since) {
    output_.begin(f, state_.output, state_.multax);
    auto result = motion::follow(state_, request, output_, options_.limits, options_.interrupted);
    if (!result) {
      return result.takeFailure();
    }
    for (Failure& warning : result->warnings) {
      report(std::move(warning));
    }
    output_.commit();
    state_.toolEnd = result->toolEnd;
    state_.axis = result->axis;
    state_.forward = state_.lastAcross = result->forward;
    state_.positioned = true;
    lastDrive_ = f.drive;
    fact(motion::spell(f.heading).data(), result->cutVectors, result->length, &*result, since);
    if (result->check < f.checks.size() && f.checks[result->check].label) {
      jump(*f.checks[result->check].label);
    }
    return std::nullopt;
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

  void perform(const Direction& d) { reportIf(motion::setDirections(state_, d)); }
  void perform(const PartSurface& p) { reportIf(motion::setPartSurface(state_, p)); }
  void perform(const ToolRelation& r) { motion::setRelation(state_, r); }
  void perform(const ToolAxis& t) { reportIf(motion::setToolAxis(state_, t)); }
  void perform(const CutterOption& o) { motion::setCutterOption(state_, o, writer_); }

  void perform(const Parameter& p) {
    if (p.word == Word::CUTTER) {
      writer_.put(cl::Values{Word::CUTTER, p.values});
      reportIf(motion::setCutter(state_, p, cutterIsUsed()));
    } else {
      motion::setParameter(state_, p, writer_);
    }
  }

  /// Whether a startup or a motion along a surface stands between this CUTTER and the next.
  [[nodiscard]] bool cutterIsUsed() const {
    for (std::size_t i = index_ + 1; i < actions_.size(); ++i) {
      const auto& body = actions_[i].body;
      if (std::holds_alternative<Startup>(body) || std::holds_alternative<Follow>(body) ||
          std::holds_alternative<Transfer>(body)) {
        return true;
      }
      const auto* parameter = std::get_if<Parameter>(&body);
      if (parameter != nullptr && parameter->word == Word::CUTTER) {
        return false;
      }
    }
    return false;
  }

  void perform(const Toggle& t) {
    if (t.word == Word::CUT) {
      if (!state_.output) {
        state_.output = true;
        put(state_.toolEnd, cl::Motion::Kind::go, lastDrive_ ? lastDrive_->name : "",
            lastDrive_ ? lastDrive_->subscript : 0);
      }
      writer_.put(cl::Switch{t.word});
    } else if (t.word == Word::DNTCUT) {
      state_.output = false;
      writer_.put(cl::Switch{t.word});
    } else {
      motion::setToggle(state_, t, writer_);
    }
  }

  void perform(const Pass& p) { writer_.put(p.body); }
  void perform(const Label&) {}
  void perform(const Pocket& p) {
    if (state_.cutterRefused) {
      return;
    }
    const auto since = std::chrono::steady_clock::now();
    needPosition();
    auto plan = motion::planPocket(state_, p);
    if (!plan) {
      report(plan.takeFailure());
      return;
    }
    if (plan->missed > 0.0) {
      report(fail(diag::PocketMissed, plan->missed));
    }
    const motion::PocketTotals done =
        motion::putPocket(*plan, state_.axis, state_.output, state_.multax, writer_);
    const double approach = (done.first - state_.toolEnd).norm();
    moveTo(done.beforeLast);
    moveTo(done.last);
    fact("POCKET", done.cutVectors, approach + done.length, nullptr, since);
  }
  void perform(const Fini&) {
    writer_.put(cl::Fini{});
    stop_ = true;
  }

  const std::vector<Action>& actions_;
  const Options& options_;
  motion::RecordWriter writer_;
  motion::MotionOutput output_{writer_};
  motion::Reporter reporter_;
  std::unordered_multimap<std::uint64_t, std::size_t> labels_;
  std::size_t index_ = 0;
  bool stop_ = false;
  bool warnedNoFrom_ = false;
  State state_;
  EntityPtr lastDrive_;
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
