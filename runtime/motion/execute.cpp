#include <chrono>

#include "ir/diag/limits.h"
#include "ir/diag/motion.h"
#include "ir/space/tolerance.h"
#include "runtime/motion/cl_curves.h"
#include "runtime/motion/direction.h"
#include "runtime/motion/facts.h"
#include "runtime/motion/follow.h"
#include "runtime/motion/implied_check.h"
#include "runtime/motion/look_ahead.h"
#include "runtime/motion/modal.h"
#include "runtime/motion/motion_output.h"
#include "runtime/motion/pocket.h"
#include "runtime/motion/records.h"
#include "runtime/motion/reporter.h"
#include "runtime/motion/route.h"
#include "runtime/motion/spline_path.h"
#include "runtime/motion/startup.h"
#include "runtime/run.h"

namespace arelem::runtime {

namespace {
using motion::State;

class Motions {
 public:
  Motions(const Options& options, cl::RecordSink& records, DiagnosticSink& sink)
      : options_(options), writer_(records), reporter_(writer_, sink) {}

  void run(const std::vector<Action>& actions) {
    actions_ = &actions;
    labels_ = motion::Labels(actions);
    for (index_ = 0; index_ < actions.size() && !stop_; ++index_) {
      if (interrupted()) {
        report(fail(diag::Interrupted));
        break;
      }
      if (++steps_ > options_.limits.steps || writer_.count() > options_.limits.records) {
        report(fail(diag::MotionLimit, steps_, writer_.count()));
        break;
      }
      const Action& action = actions[index_];
      if (std::holds_alternative<Label>(action.body)) {
        continue;
      }
      if (curves_.endsSpline(action)) {
        showAxis();
        finishCurve(curves_.goAlong());
      }
      curves_.tellLost(&action);
      writer_.begin(action);
      std::visit([&](const auto& body) { perform(body); }, action.body);
      writer_.end();
    }
  }

  MotionOutcome finish() {
    curves_.tellLost(nullptr);
    return facts_.take(!reporter_.failed());
  }

 private:
  const Action& action() const { return (*actions_)[index_]; }
  bool interrupted() const {
    return options_.interrupted != nullptr && options_.interrupted->load(std::memory_order_relaxed);
  }

  void report(Failure failure) {
    reporter_.report(action(), std::move(failure), state_.part ? state_.part->entity : nullptr);
    stop_ = stop_ || reporter_.fatal();
  }
  void reportAll(std::vector<Failure>& warnings) {
    for (Failure& warning : warnings) {
      report(std::move(warning));
    }
  }
  void reportIf(std::optional<Failure> failure) {
    if (failure) {
      report(*std::move(failure));
    }
  }

  /// True where what is told is an error.
  bool refuses(std::optional<Failure> told) {
    const bool refused = told && told->row->severity == Severity::error;
    reportIf(std::move(told));
    return refused;
  }

  void put(const Vec3& toolEnd, cl::Motion::Kind kind, const std::string& name, int subscript) {
    if (!state_.output) {
      return;
    }
    showAxis();
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

  void showAxis() { options_.axesFollow ? motion::showAxis(state_, writer_) : void(); }

  void perform(const Arc&) { curves_.begin(action()); }

  void finishCurve(std::optional<Result<motion::CurveFact>> curve) {
    if (!curve) {
      return;
    }
    if (!*curve) {
      return report(curve->takeFailure());
    }
    reportAll((*curve)->warnings);
    fact((*curve)->statement, 1, (*curve)->length, nullptr, facts_.begin());
  }

  void putFeed(const std::optional<double>& feed) {
    if (feed) {
      writer_.putFeed(*feed);
    }
  }

  void moveTo(const Vec3& toolEnd) { motion::moveTo(state_, toolEnd); }

  void needPosition() {
    if (!state_.positioned && !warnedNoFrom_) {
      report(fail(diag::NoFrom));
      warnedNoFrom_ = true;
    }
  }

  void fact(const char* statement,
            std::uint64_t vectors,
            double length,
            const motion::FollowResult* result,
            motion::Facts::Instant since) {
    facts_.add(action(), statement, vectors, length, result, state_, since);
  }

  void perform(const Locate& l) {
    const auto since = facts_.begin();
    if (refuses(motion::setAxis(state_, l, options_.axesFollow))) {
      return;
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
    if (curves_.takes(l, steps_)) {
      showAxis();
      return finishCurve(curves_.goAlong(l));
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

  void perform(const FollowSpline& f) {
    const auto since = facts_.begin();
    needPosition();
    auto path = motion::alongSpline(*f.curve, state_.band(motion::driveRole));
    if (!path) {
      report(path.takeFailure());
      return;
    }
    const Vec3 before = state_.toolEnd;
    const Vec3 start = path->front();
    putFeed(f.feed);
    if ((start - before).norm() > tolerance::sameSide || !state_.positioned) {
      put(start, cl::Motion::Kind::go, f.curve->name, f.curve->subscript);
    }
    if (state_.output) {
      motion::putSpline(writer_, *f.curve, *path, state_.axis, state_.multax);
    }
    const double length = (start - before).norm() + motion::lengthOf(*path);
    moveTo((*path)[path->size() - 2]);
    moveTo(path->back());
    fact("GOTO", path->size() - 1, length, nullptr, since);
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
    if (state_.cutterRefused || refuses(motion::tooFarOut(state_))) {
      return;
    }
    const auto since = facts_.begin();
    needPosition();
    takeAutomaticPart();
    putFeed(s.feed);
    auto found = motion::startupPosition(state_, s);
    // The part surface of what follows it is, with or without a position at it.
    if (s.surfaces.size() > 1) {
      motion::startAtPart(state_, s.surfaces[1]);
    }
    if (!found) {
      reportIf(motion::ofMotion(state_, found.takeFailure()));
    } else {
      reportAll(found->warnings);
      const Vec3 before = state_.toolEnd;
      moveTo(found->toolEnd);
      state_.axis = found->axis;
      state_.touchesPart = s.surfaces.size() > 1 && s.surfaces[1].condition != ir::Condition::on;
      const Entity& first = *s.surfaces[0].surface;
      put(found->toolEnd, cl::Motion::Kind::go, first.name, first.subscript);
      fact(s.offset ? "OFFSET" : "GO", 1, (found->toolEnd - before).norm(), nullptr, since);
    }
    motion::forgetOneShots(state_);
  }

  void perform(const Follow& f) {
    if (state_.cutterRefused || refuses(motion::tooFarOut(state_))) {
      return;
    }
    const auto since = facts_.begin();
    needPosition();
    takeAutomaticPart();
    motion::FollowRequest request;
    request.heading = f.heading;
    auto drive = motion::named(f.drive);
    auto checks = motion::checkGoals(*actions_, index_, f, state_.driveRelation);
    if (!drive || !checks) {
      report(drive ? checks.takeFailure() : drive.takeFailure());
    } else {
      request.drive = *std::move(drive);
      request.checks = *std::move(checks);
      reportIf(motion::ofMotion(state_, runFollow(f, request, since)));
    }
    motion::forgetOneShots(state_);
  }

  std::optional<Failure> runFollow(const Follow& f,
                                   const motion::FollowRequest& request,
                                   motion::Facts::Instant since) {
    output_.begin(f, state_.output, state_.multax);
    auto result = motion::follow(state_, request, output_, options_.limits, options_.interrupted);
    if (!result) {
      return result.takeFailure();
    }
    reportAll(result->warnings);
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
    auto place = labels_.from(key, index_, reporter_.failed(), options_.limits.transfers);
    place ? void(index_ = *place) : report(place.takeFailure());
  }

  void perform(const Transfer& t) { jump(t.label); }

  void perform(const Direction& d) { reportIf(motion::setDirections(state_, d)); }
  void perform(const PartSurface& p) { reportIf(motion::setPartSurface(state_, p)); }
  void perform(const ToolRelation& r) { motion::setRelation(state_, r); }
  void perform(const ToolAxis& t) { reportIf(motion::setToolAxis(state_, t)); }
  void perform(const CutterOption& o) { reportIf(motion::setCutterOption(state_, o, writer_)); }

  void perform(const Parameter& p) {
    if (p.word == Word::CUTTER) {
      writer_.put(cl::Values{Word::CUTTER, p.values});
      // CL text has been cut already: its cutter tells what the system that wrote it took.
      const bool matters = !options_.axesFollow || motion::cutterIsUsed(*actions_, index_);
      reportIf(motion::setCutter(state_, p, matters));
    } else {
      motion::setParameter(state_, p, writer_);
    }
    reportIf(motion::wideBand(state_));
  }

  void perform(const Toggle& t) {
    if (t.word == Word::DEBUG) {
      facts_.trace(t.on);
    } else if (t.word == Word::CUT) {
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
      options_.axesFollow ? motion::endAxes(state_, t) : void();
    }
  }

  void perform(const Pass& p) {
    curves_.look(p.body);
    writer_.put(p.body);
  }
  void perform(const Label&) {}
  void perform(const Pocket& p) {
    const auto since = facts_.begin();
    needPosition();
    const auto path = motion::pocketPath(p, state_);
    if (!path) {
      return report(path.failure());
    }
    const auto vectors = state_.output ? motion::putPocket(*path, p, state_, writer_) : 0;
    moveTo(path->passes.back().back());
    fact("POCKET", vectors, path->length, nullptr, since);
  }
  void perform(const Fini&) {
    writer_.put(cl::Fini{});
    stop_ = true;
  }

  const std::vector<Action>* actions_ = nullptr;
  const Options options_;
  motion::Facts facts_{options_.keepsFacts};
  motion::RecordWriter writer_;
  motion::MotionOutput output_{writer_};
  motion::Reporter reporter_;
  motion::Labels labels_{{}};
  std::size_t index_ = 0;
  std::uint64_t steps_ = 0;
  bool stop_ = false;
  bool warnedNoFrom_ = false;
  State state_;
  motion::ClCurves curves_{state_, writer_, reporter_, options_.axesFollow};
  EntityPtr lastDrive_;
};
}  // namespace

struct Execution::Machine : Motions {
  using Motions::Motions;
};

Execution::Execution(const Options& options, cl::RecordSink& records, DiagnosticSink& sink)
    : machine_(std::make_unique<Machine>(options, records, sink)) {}

Execution::~Execution() = default;

void Execution::feed(const std::vector<Action>& actions) {
  machine_->run(actions);
}

MotionOutcome Execution::finish() {
  return machine_->finish();
}

MotionOutcome execute(const std::vector<Action>& actions,
                      const Options& options,
                      cl::RecordSink& records,
                      DiagnosticSink& sink) {
  Execution execution(options, records, sink);
  execution.feed(actions);
  return execution.finish();
}

}  // namespace arelem::runtime
