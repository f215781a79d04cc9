#include "backend/g97/writer.h"

#include <cmath>
#include <ostream>
#include <set>

#include "backend/g97/divide.h"
#include "backend/robot/envelope.h"
#include "backend/robot/feed.h"
#include "backend/robot/objections.h"
#include "ir/cl/post_word.h"
#include "ir/diag/render_text.h"
#include "ir/diag/robot.h"
#include "ir/hole/cycle.h"
#include "ir/words/units.h"

namespace arelem::backend {

namespace {
using namespace g97;
using robot::Pose;

constexpr int fastest = 9999;
constexpr double halfTurn = 180.0;

class G97Writer : public Writer {
 public:
  G97Writer(std::ostream& out, const Context& context, DiagnosticSink& sink)
      : out_(out), sink_(sink) {
    if (context.machine != nullptr) {
      machine_ = *context.machine;
    }
  }

  void accept(const cl::Record& record) override {
    record_ = &record;
    std::visit(*this, record.body);
  }

  void finish() override {
    switchOffAtEnd();
    objections_.report(location_, sink_);
    if (steps_.empty()) {
      if (reported_ == 0 && objections_.empty()) {
        sink_.accept(diagnose(nowhere, diag::G97NoBlock));
      }
      return;
    }
    if (worstOff_ > 0.01) {
      sink_.accept(diagnose(nowhere, diag::G97CompatOff, worstOff_));
    }
    const std::size_t count = steps_.size();
    Result<std::vector<Program>> programs = divided(std::move(steps_), machine_.g97);
    if (!programs) {
      sink_.accept(at(nowhere, programs.takeFailure()));
      return;
    }
    if (programs->size() > 1) {
      const int first = machine_.g97.program;
      const int last = first + static_cast<int>(programs->size()) - 1;
      sink_.accept(diagnose(nowhere, diag::G97Split, count, machine_.g97.blocks, programs->size(),
                            first, last));
    }
    out_ << textOf(*programs, machine_.g97);
    out_.flush();
  }

  void operator()(const cl::Motion& motion) {
    for (const Pose& pose : robot::posesOf(motion, millimeters_)) {
      ++location_;
      moveTo(pose, motion.kind == cl::Motion::Kind::from);
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
      case Word::MACHIN:
      case Word::END:
        return;  // for others, or said by the program's end
      default:
        other(post);
    }
  }
  void operator()(const cl::Text& text) {
    if (text.word != Word::PARTNO) {
      without(spell(text.word));
    }
  }
  void operator()(const cl::Units& units) { millimeters_ = millimetersOf(units.unit); }
  template <class Other>
  void operator()(const Other&) {
  }  // what tells of surfaces, tolerances and the cutter moves nothing

 private:
  /// What the robot cannot do is told once of a kind, with its worst location.
  void object(Failure failure, double excess) {
    objections_.add({std::move(failure), excess}, location_, record_->origin);
  }
  void report(Failure failure) {
    if (reported_++ < mostReports) {
      sink_.accept(at(record_->origin, std::move(failure)));
    }
  }
  /// A word that the controller has no use for: told once.
  void without(std::string_view word) {
    if (told_.insert(std::string(word)).second) {
      sink_.accept(diagnose(record_->origin, diag::G97Without, word));
    }
  }

  /// A sequence code at the location reached last; a second one there needs a block of its own.
  void code(std::string text) {
    if (!steps_.back().block.code.empty()) {
      steps_.push_back({steps_.back().block, spraying()});
    }
    steps_.back().block.code = std::move(text);
  }
  [[nodiscard]] bool spraying() const { return !on_.empty(); }

  /// Words for which the machine file has a literal.
  void other(const cl::Post& post) {
    const auto found = machine_.g97.words.find(std::string(spell(post.word)));
    const bool known = found != machine_.g97.words.end() && !steps_.empty();
    if (auto lost =
            known || post.word != Word::CYCLE ? std::nullopt : hole::objectionToDrilling(post)) {
      return report(*std::move(lost));
    }
    if (!known) {
      return without(spell(post.word));
    }
    std::string text = found->second;
    if (const std::size_t hole = text.find("{1}"); hole != std::string::npos) {
      const double* number = robot::numberAt(post, 0);
      if (number == nullptr) {
        return without(spell(post.word));
      }
      text.replace(hole, 3, fmt::format("{:.6g}", *number));
    }
    code(std::move(text));
  }

  void feed(const cl::Post& post) {
    const double* value = robot::numberAt(post, 0);
    const std::optional<double> speed = robot::speedOf(post, millimeters_);
    if (!speed) {
      report(fail(diag::G97FeedWord, value == nullptr  ? "no number"
                                     : !(*value > 0.0) ? fmt::format("{:.6g}", *value)
                                                       : std::string("a feed per turn")));
      return;
    }
    speed_ = *speed;
    rapid_ = false;
  }

  /// SPRAY/ON, n and SPRAY/OFF, n at the location before; only where the state changes.
  void spray(const cl::Post& post) {
    const double* number = robot::numberAt(post, 1);
    const int wanted = number == nullptr ? 1 : static_cast<int>(*number);
    const std::vector<int>& outputs = machine_.g97.outputs;
    if (wanted < 1 || (!outputs.empty() && static_cast<std::size_t>(wanted) > outputs.size())) {
      report(fail(diag::G97Output,
                  fmt::format("output {}; the machine file has {}", wanted, outputs.size())));
      return;
    }
    const int output = outputs.empty() ? wanted : outputs[static_cast<std::size_t>(wanted) - 1];
    const bool on = cl::has(post, Word::ON);
    if (on == (on_.count(output) != 0)) {
      return;
    }
    if (steps_.empty()) {
      if (location_ == 0) {  // else it was refused, and said so
        report(fail(diag::G97Output, "no location before it: a block belongs to a location"));
      }
      return;
    }
    code(fmt::format("{},{}", on ? "RON" : "ROF", output));
    on ? void(on_.insert(output)) : void(on_.erase(output));
  }

  void switchOffAtEnd() {
    const std::set<int> left = on_;
    for (const int output : left) {
      sink_.accept(diagnose(nowhere, diag::G97LeftOn, output));
      code(fmt::format("ROF,{}", output));
      on_.erase(output);
    }
  }

  void moveTo(const Pose& pose, bool isFrom) {
    const std::string place = fmt::format("location {}", location_);
    if (machine_.envelope) {
      if (auto objection = robot::objectionToPlace(*machine_.envelope,
                                                   robot::inBase(machine_.frame, pose), place)) {
        return objections_.add(*std::move(objection), location_, record_->origin);
      }
    }
    Result<BlockPose> written = blockOf(machine_, pose, place);
    if (!written) {
      return object(written.takeFailure(), pose.point.cwiseAbs().maxCoeff());
    }
    if (machine_.g97.robopaint) {
      const Vec3 axis = poseOf(machine_, *written).axis;
      worstOff_ =
          std::max(worstOff_, std::atan2(axis.cross(pose.axis).norm(), axis.dot(pose.axis)) *
                                  halfTurn / std::numbers::pi);
    }
    const bool traverse = rapid_ || isFrom || location_ == 1;
    Step step;
    step.block.straight = !traverse;
    step.block.pose = *written;
    step.block.speed = speedOf(traverse ? machine_.rapid : speed_, place);
    step.spraying = spraying();
    if (!traverse && !steps_.empty()) {
      checkSwing(steps_.back().block.pose.angles, written->angles, place);
    }
    rapid_ = false;
    steps_.push_back(std::move(step));
  }

  int speedOf(double speed, std::string_view place) {
    const double rounded = std::round(speed);
    if (!(rounded >= 1.0 && rounded <= fastest)) {
      Failure bad = fail(diag::G97Feed, place, speed);
      object(speed > 0.0 ? bad : std::move(bad).withHelp("no FEDRAT came before it"),
             std::max(speed, 1.0 / speed));
      return 1;
    }
    if (machine_.speed > 0.0 && rounded > machine_.speed) {
      object(fail(diag::RobotSpeed, place, speed, machine_.speed, machine_.speed / speed), speed);
    }
    return static_cast<int>(rounded);
  }

  /// The turn numbers stay; an angle that jumps by more than half a turn may go the long way.
  void checkSwing(const Angles& from, const Angles& to, std::string_view place) {
    for (const auto& [name, a, b] : {std::tuple{"P", from.p, to.p}, {"R", from.r, to.r}}) {
      if (std::abs(a - b) > halfTurn && told_.insert("swing").second) {
        sink_.accept(diagnose(record_->origin, diag::G97Swing, place, name, a, b));
      }
    }
  }

  static constexpr std::size_t mostReports = 20;
  std::ostream& out_;
  DiagnosticSink& sink_;
  robot::Machine machine_;
  const cl::Record* record_ = nullptr;
  std::vector<Step> steps_;
  std::set<std::string> told_;
  std::set<int> on_;
  double millimeters_ = 1.0;
  double speed_ = 0.0;
  bool rapid_ = false;
  std::size_t location_ = 0;
  std::size_t reported_ = 0;
  robot::Objections objections_;
  double worstOff_ = 0.0;
};
}  // namespace

std::unique_ptr<Writer> makeG97Writer(std::ostream& out,
                                      const Context& context,
                                      DiagnosticSink& sink) {
  return std::make_unique<G97Writer>(out, context, sink);
}

}  // namespace arelem::backend
