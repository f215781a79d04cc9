#include "backend/vplus/writer.h"

#include <cmath>
#include <ostream>
#include <set>

#include "backend/robot/feed.h"
#include "backend/robot/reach_check.h"
#include "backend/text/clean.h"
#include "backend/vplus/blank.h"
#include "backend/vplus/held_tool.h"
#include "backend/vplus/program_lines.h"
#include "backend/vplus/reader.h"
#include "ir/cl/feed.h"
#include "ir/cl/post_word.h"
#include "ir/diag/ngc.h"
#include "ir/diag/robot.h"
#include "ir/diag/told_factor.h"
#include "ir/hole/cycle_feed.h"
#include "ir/hole/steps.h"
#include "ir/space/tolerance.h"
#include "ir/words/units.h"

namespace arelem::backend {

namespace {
using namespace robot;
using vplus::numberText;
using vplus::slowestSpeed;
using vplus::speedText;
using vplus::transText;

constexpr int bitsOfTilt = 8;

class VplusWriter : public Writer {
 public:
  VplusWriter(std::ostream& out, const Context& context, DiagnosticSink& sink)
      : out_(out), sink_(sink) {
    if (context.machine != nullptr) {
      machine_ = *context.machine;
    } else {
      machine_.speed = 0.0;
    }
  }

  void accept(const cl::Record& record) override {
    record_ = &record;
    std::visit(*this, record.body);
  }

  void finish() override {
    if (machine_.vplus.approach > 0.0 && stands_) {
      depart("the way up at the end");
    } else if (!signalsAfterMove_.empty()) {
      line("BREAK");
    }
    switchOutputs();
    reach_.report(sink_);
    if (machine_.speed > 0.0 && fastest_.speed > machine_.speed) {
      sink_.accept(diagnose(fastest_.origin, diag::RobotSpeed, fastest_.place, fastest_.speed,
                            machine_.speed, diag::toldFactor(machine_.speed / fastest_.speed)));
    }
    out_ << program_.text(name_, machine_.frame);
    out_.flush();
  }

  void operator()(const cl::Motion& motion) {
    for (const Pose& pose : posesOf(motion, millimeters_)) {
      ++location_;
      reach_.begin(record_->origin);
      if (auto objection = cycles_.objection()) {
        report(*std::move(objection));
      }
      if (cycles_.now() != nullptr && motion.kind != cl::Motion::Kind::from) {
        drill(pose, hole::cycleFrom(*cycles_.now(), heightOver(pose)));
      } else {
        moveTo(pose, motion.kind == cl::Motion::Kind::from);
      }
    }
  }
  void operator()(const cl::Post& post) {
    if (cl::isApplied(post)) {
      return;
    }
    if (!post.foreign.empty()) {
      return without(post.foreign);
    }
    switch (post.word) {
      case Word::FEDRAT:
        return feed(post);
      case Word::RAPID:
        rapid_ = true;
        return;
      case Word::SPRAY:
        return spray(post);
      case Word::DELAY:
        return delay(post);
      case Word::STOP:
      case Word::OPSTOP:
        line("BREAK");
        switchOutputs();
        line("PAUSE");
        return;
      case Word::MACHIN:
      case Word::END:
        return;  // for others, or said by the program itself
      case Word::CYCLE:
        return cycle(post);
      case Word::SPINDL:
        turns_ = cl::turnsBehind(post, turns_);
        return without("SPINDL");
      default:
        without(spell(post.word));
    }
  }
  void operator()(const cl::Text& text) {
    if (text.word == Word::PARTNO && name_.empty()) {
      name_ = trimmed(text.text);
    }
    if (text.word == Word::INSERT) {
      return without("INSERT");
    }
    std::string clean = printableAscii(trimmed(text.text));
    program_.comment(std::move(clean));
  }
  void operator()(const cl::Units& units) { millimeters_ = millimetersOf(units.unit); }
  void operator()(const cl::Raw&) { without("a record of an unknown class"); }
  template <class Other>
  void operator()(const Other&) {
  }  // what tells of surfaces, tolerances and the cutter moves nothing

 private:
  void line(std::string text) {
    if (auto failure = program_.add(std::move(text))) {
      report(*std::move(failure));
    }
  }
  void report(Failure failure) {
    if (reported_++ < mostReports) {
      sink_.accept(at(record_->origin, std::move(failure)));
    }
  }
  /// A word that the robot has no use for: told once.
  void without(std::string_view word) {
    if (told_.insert(std::string(word)).second) {
      sink_.accept(diagnose(record_->origin, diag::VplusWithout, word));
    }
    program_.comment(fmt::format("{} is left out", printableAscii(word)));
  }

  void feed(const cl::Post& post) {
    Result<double> speed = robot::neededSpeed(post, millimeters_, turns_);
    if (!speed) {
      return report(speed.takeFailure());
    }
    speed_.set(*speed);
    rapid_ = false;
  }

  void delay(const cl::Post& post) {
    Result<double> seconds = secondsOf(post, turns_);
    if (!seconds) {
      return report(seconds.takeFailure());
    }
    // The robot stands while it waits: what is to change at this place does so before.
    if (!signalsAfterMove_.empty()) {
      line("BREAK");
      switchOutputs();
    }
    line(fmt::format("DELAY {}", numberText(*seconds)));
  }

  /// SPRAY/ON, n and SPRAY/OFF, n: at the location before, or on the way from it.
  void spray(const cl::Post& post) {
    const double* output = numberAt(post, 1);
    const bool on = cl::has(post, Word::ON);
    const double number = output == nullptr ? 1.0 : *output;
    if (number != std::round(number) || !vplus::isOutput(number)) {
      return report(fail(diag::VplusOutput, number));
    }
    const int n = static_cast<int>(number);
    if (machine_.tilt && n >= machine_.tilt->firstOutput &&
        n < machine_.tilt->firstOutput + bitsOfTilt) {
      return report(fail(diag::TiltOutput, n, machine_.tilt->firstOutput,
                         machine_.tilt->firstOutput + bitsOfTilt - 1));
    }
    const std::string signal = fmt::format("SIGNAL {}", on ? n : -n);
    if (machine_.vplus.onTheFly) {
      signalsAfterMove_.push_back(signal);
      return;
    }
    line("BREAK");
    line(signal);
  }

  void cycle(const cl::Post& post) {
    const auto change = cycles_.read(post);
    if (!change) {
      return report(change.failure());
    }
    if (*change == hole::Cycles::Change::none) {
      return;
    }
    speed_.endCycle();
    const hole::Cycle* begun = cycles_.now();
    if (begun == nullptr) {
      return;
    }
    if (const auto own = hole::feedOf(*begun)) {
      Result<double> speed = robot::neededSpeed(*own, millimeters_, turns_);
      if (!speed) {
        return report(speed.takeFailure());
      }
      speed_.beginCycle(*speed);
    }
    if (const auto steps = hole::stepsOf(*begun); !steps) {
      report(steps.failure());
    }
  }

  /// How far the tool stands above a place along its axis; none where that is not known or it
  /// turns.
  [[nodiscard]] std::optional<double> heightOver(const Pose& pose) const {
    if (!here_ || (here_->axis - pose.axis).norm() > tolerance::symmetric) {
      return std::nullopt;
    }
    return (here_->point - pose.point).dot(pose.axis) / millimeters_;
  }

  /// A location under a cycle: over the hole, down and up again along the tool, move by move.
  void drill(const Pose& pose, const hole::Cycle& cycle) {
    const auto steps = hole::stepsOf(cycle);
    if (!steps || !feedIsKnown(pose)) {
      return;
    }
    const auto go = [&](const Vec3& point, bool rapid) {
      Pose at = pose;
      at.point = point;
      const bool stands = here_ && (here_->point - point).norm() <= tolerance::symmetric &&
                          (here_->axis - pose.axis).norm() <= tolerance::symmetric;
      if (!stands) {
        rapid_ = rapid;
        moveTo(at, false);
      }
    };
    const Vec3 between = pose.point + cycle.retract * millimeters_ * pose.axis;
    if (here_ && (here_->axis - pose.axis).norm() <= tolerance::symmetric) {
      for (const Vec3& point : hole::wayOver(here_->point, between, pose.axis)) {
        go(point, true);
      }
    } else {
      go(between, true);
    }
    for (const hole::Step& step : *steps) {
      if (step.kind == hole::Step::Kind::dwell) {
        line(fmt::format("DELAY {}", numberText(step.seconds)));
      } else {
        go(pose.point + step.height * millimeters_ * pose.axis,
           step.kind == hole::Step::Kind::rapid);
      }
    }
    rapid_ = false;
  }

  bool feedIsKnown(const Pose& to) {
    if (speed_.now() <= 0.0 && !feedMissed_) {
      feedMissed_ = true;
      const Vec3 place = to.point / millimeters_;
      report(fail(diag::NgcFeedMissing, place.x(), place.y(), place.z()));
    }
    return speed_.now() > 0.0;
  }

  void moveTo(const Pose& pose, bool isFrom) {
    const std::string place = fmt::format("location {}", location_);
    vplus::HeldTool held;
    if (auto objection = vplus::hold(machine_, pose, place, held)) {
      return reach_.refuse(std::move(objection->failure), objection->excess);
    }
    wantedTilt_ = held.tiltWord;
    const bool over = rapid_ && !isFrom && machine_.vplus.approach > 0.0 && !cycles_.now();
    const bool joint = isFrom || !here_;  // nothing is known of where the robot stands
    if (!joint && !rapid_) {
      feedIsKnown(pose);
    }
    if (!stands_ && machine_.scara) {
      line(machine_.scara->lefty ? "LEFTY" : "RIGHTY");
    }
    setSpeed(place);
    const std::string there = "f:" + transText(pose.point, eulerOf(toolFrame(held.written)));
    if (over) {
      approach(held.inBase, there, place, joint);
    }
    reach_.moveTo(held.inBase, place, !joint || over);
    motion((joint && !over ? "MOVE " : "MOVES ") + there);
    turnTiltAxis();
    here_ = pose;
    stands_ = held.inBase;
  }

  /// A motion instruction; outputs that change on the fly do so as it begins.
  void motion(std::string text) {
    line(std::move(text));
    switchOutputs();
  }
  void switchOutputs() {
    for (std::string& signal : signalsAfterMove_) {
      line(std::move(signal));
    }
    signalsAfterMove_.clear();
  }

  /// Away from the place before and over the next one, along the tool.
  void approach(const Pose& pose, const std::string& there, const std::string& place, bool joint) {
    const double away = machine_.vplus.approach;
    depart("the way up before " + place);
    motion(fmt::format("{} {}, {}", joint ? "APPRO" : "APPROS", there, numberText(away)));
    turnTiltAxis();
    reach_.moveTo(vplus::raised(pose, away), "the approach to " + place, !joint);
  }
  void depart(const std::string& way) {
    const double away = machine_.vplus.approach;
    if (stands_ && away > 0.0) {
      motion("DEPARTS " + numberText(away));
      reach_.moveTo(vplus::raised(*stands_, away), way, true);
    }
  }

  /// Behind the instruction of the move: that starts it and the program goes on, so that the axis
  /// turns during this move. Before it, it would turn during the move that is still under way.
  void turnTiltAxis() {
    if (wantedTilt_ != tiltWord_) {
      line(fmt::format("BITS {}, {} = {}", machine_.tilt->firstOutput, bitsOfTilt, wantedTilt_));
      tiltWord_ = wantedTilt_;
    }
  }

  void setSpeed(const std::string& place) {
    const double speed = rapid_ ? machine_.rapid : speed_.now();
    rapid_ = false;
    if (speed > std::max(fastest_.speed, machine_.speed)) {
      fastest_ = {speed, place, record_->origin};
    }
    if (speed > 0.0 && speed < slowestSpeed) {
      return report(fail(diag::VplusSlow, place, speed, slowestSpeed));
    }
    if (speed > 0.0 && speedText(speed) != written_) {
      written_ = speedText(speed);
      line(fmt::format("SPEED {}, 100 MMPS ALWAYS", written_));
    }
  }

  /// The fastest move, of which a factor on all speeds can be told.
  struct Fastest {
    double speed = 0.0;
    std::string place;
    Span origin;
  };

  static constexpr std::size_t mostReports = 20;
  std::ostream& out_;
  DiagnosticSink& sink_;
  Machine machine_;
  ReachCheck reach_{machine_};
  vplus::ProgramLines program_{machine_.vplus};
  hole::Cycles cycles_;
  const cl::Record* record_ = nullptr;
  std::vector<std::string> signalsAfterMove_;
  std::set<std::string> told_;
  std::string name_;
  std::string written_;  // the speed in force
  double millimeters_ = 1.0;
  hole::CycleFeed<double> speed_;
  bool rapid_ = false;
  double turns_ = 0.0;       // of a spindle that the robot carries, a minute
  bool feedMissed_ = false;  // told once
  Fastest fastest_;
  int tiltWord_ = 0;    // in force
  int wantedTilt_ = 0;  // of the location under way
  std::size_t location_ = 0;
  std::size_t reported_ = 0;
  std::optional<Pose> here_;    // seen from the frame
  std::optional<Pose> stands_;  // as the robot holds it, seen from its base
};
}  // namespace

std::unique_ptr<Writer> makeVplusWriter(std::ostream& out,
                                        const Context& context,
                                        DiagnosticSink& sink) {
  if (context.machine != nullptr && context.machine->vplus.format != VplusStyle::Format::program) {
    return makeBlankWriter(out, *context.machine, sink);
  }
  return std::make_unique<VplusWriter>(out, context, sink);
}

}  // namespace arelem::backend
