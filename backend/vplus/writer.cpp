#include "backend/vplus/writer.h"

#include <cmath>
#include <numbers>
#include <ostream>
#include <set>

#include "backend/robot/envelope.h"
#include "backend/robot/feed.h"
#include "backend/robot/machine.h"
#include "backend/robot/reach.h"
#include "backend/text/clean.h"
#include "backend/vplus/blank.h"
#include "backend/vplus/name.h"
#include "backend/vplus/reader.h"
#include "ir/diag/ngc.h"
#include "ir/diag/robot.h"
#include "ir/words/units.h"

namespace arelem::backend {

namespace {
using namespace robot;

constexpr int bitsOfTilt = 8;
constexpr std::size_t indent = 2;

/// Numbers as V+ takes them, three decimals, never "-0.000".
std::string number(double value) {
  const double rounded = std::round(value * 1e3) / 1e3;
  return fmt::format("{:.3f}", rounded == 0.0 ? 0.0 : rounded);
}

std::string trans(const std::array<double, 6>& v) {
  return fmt::format("TRANS({}, {}, {}, {}, {}, {})", number(v[0]), number(v[1]), number(v[2]),
                     number(v[3]), number(v[4]), number(v[5]));
}

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
    if (machine_.speed > 0.0 && fastest_.speed > machine_.speed) {
      sink_.accept(diagnose(fastest_.origin, diag::RobotSpeed, fastest_.place, fastest_.speed,
                            machine_.speed, machine_.speed / fastest_.speed));
    }
    const std::string end = machine_.vplus.crlf ? "\r\n" : "\n";
    std::string text = ".PROGRAM " + vplus::programName(name_) + "()" + end;
    text += "  ; made by arelem from CL data" + end;
    text += "  AUTO f" + end;
    const Frame& f = machine_.frame;
    text += "  SET f = " +
            trans({f.shift.x(), f.shift.y(), f.shift.z(), f.angles[0], f.angles[1], f.angles[2]}) +
            end;
    if (machine_.vplus.tool) {
      text += "  TOOL " + trans(*machine_.vplus.tool) + end;
    }
    text += "  ACCEL 100, 100" + end;
    for (const std::string& line : lines_) {
      text += "  " + line + end;
    }
    if (machine_.vplus.approach > 0.0 && before_) {
      text += "  DEPARTS " + number(machine_.vplus.approach) + end;
    } else if (!signalsAfterMove_.empty()) {
      text += "  BREAK" + end;
    }
    for (const std::string& line : signalsAfterMove_) {
      text += "  " + line + end;
    }
    text += "  BREAK" + end + "  RETURN" + end + ".END" + end;
    if (machine_.vplus.controlZ) {
      text += "\f\x1a";
    }
    out_ << text;
    out_.flush();
  }

  void operator()(const cl::Motion& motion) {
    for (const Pose& pose : posesOf(motion, millimeters_)) {
      ++location_;
      moveTo(pose, motion.kind == cl::Motion::Kind::from);
    }
  }
  void operator()(const cl::Post& post) {
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
      case Word::TRACUT:
      case Word::COPY:
      case Word::INDEX:
      case Word::MACHIN:
      case Word::END:
        return;  // done already, or said by the program itself
      case Word::CYCLE:
        cycle_ = !hasWord(post, Word::OFF);
        return without("CYCLE");
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
    comment(std::move(clean));
  }
  void operator()(const cl::Units& units) { millimeters_ = millimetersOf(units.unit); }
  template <class Other>
  void operator()(const Other&) {
  }  // what tells of surfaces, tolerances and the cutter moves nothing

 private:
  /// An instruction. V+ has no way to go on with one on a further line.
  void line(std::string text) {
    const std::size_t columns = indent + text.size();
    if (columns > vplus::longestLine) {
      return report(fail(diag::VplusLineLength, columns, vplus::longestLine));
    }
    lines_.push_back(std::move(text));
  }
  void comment(std::string text) {
    text.resize(
        std::min(text.size(), static_cast<std::size_t>(machine_.vplus.columns) - indent - 2));
    lines_.push_back("; " + std::move(text));
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
    comment(fmt::format("{} is left out", printableAscii(word)));
  }

  void feed(const cl::Post& post) {
    Result<double> speed = robot::neededSpeed(post, millimeters_);
    if (!speed) {
      return report(speed.takeFailure());
    }
    speed_ = *speed;
    rapid_ = false;
  }

  void delay(const cl::Post& post) {
    const double* seconds = numberAt(post, 0);
    if (seconds == nullptr || *seconds < 0.0 || hasWord(post, Word::REV)) {
      return report(fail(diag::VplusDelay, seconds == nullptr ? 0.0 : *seconds,
                         hasWord(post, Word::REV) ? " turns" : " s"));
    }
    // The robot stands while it waits: what is to change at this place does so before.
    if (!signalsAfterMove_.empty()) {
      line("BREAK");
      switchOutputs();
    }
    line(fmt::format("DELAY {}", number(*seconds)));
  }

  /// SPRAY/ON, n and SPRAY/OFF, n: at the location before, or on the way from it.
  void spray(const cl::Post& post) {
    const double* output = numberAt(post, 1);
    const bool on = hasWord(post, Word::ON);
    const double number = output == nullptr ? 1.0 : *output;
    if (number != std::round(number) || !vplus::isOutput(number)) {
      return report(fail(diag::VplusOutput, number));
    }
    const int n = static_cast<int>(number);
    const std::string signal = fmt::format("SIGNAL {}", on ? n : -n);
    if (machine_.vplus.onTheFly) {
      signalsAfterMove_.push_back(signal);
      return;
    }
    line("BREAK");
    line(signal);
  }

  void moveTo(const Pose& pose, bool isFrom) {
    const std::string place = fmt::format("location {}", location_);
    const Pose inRobot = inBase(machine_.frame, pose);
    Pose written = pose;
    const bool upright = machine_.scara || machine_.tilt;
    if (upright && !standUpright(inRobot, place, written)) {
      return;
    }
    check(inRobot, place, isFrom);
    const bool over = rapid_ && !isFrom && machine_.vplus.approach > 0.0;
    const bool joint = isFrom || location_ == 1;  // nothing is known of where the robot stands
    if (!joint && !rapid_ && !cycle_ && speed_ <= 0.0 && !feedMissed_) {
      feedMissed_ = true;
      report(fail(diag::NgcFeedMissing, pose.point.x() / millimeters_,
                  pose.point.y() / millimeters_, pose.point.z() / millimeters_));
    }
    setSpeed(place);
    const Euler e = eulerOf(toolFrame(written));
    const std::string there =
        "f:" + trans({pose.point.x(), pose.point.y(), pose.point.z(), e.yaw, e.pitch, e.roll});
    if (over) {
      approach(inRobot, there, place, joint);
    }
    motion((joint && !over ? "MOVE " : "MOVES ") + there);
    turnTiltAxis();
    before_ = inRobot;
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
    if (before_) {
      motion("DEPARTS " + number(away));
    }
    motion(fmt::format("{} {}, {}", joint ? "APPRO" : "APPROS", there, number(away)));
    turnTiltAxis();
    Pose raised = pose;
    raised.point += away * pose.axis.normalized();
    check(raised, "the approach to " + place, true);
  }

  /// Splits the pose into what the robot holds upright and what its tilt axis does.
  bool standUpright(const Pose& inRobot, const std::string& place, Pose& written) {
    const std::optional<Upright> upright = uprightOf(inRobot);
    const double lean =
        std::acos(std::clamp(inRobot.axis.normalized().z(), -1.0, 1.0)) * 180.0 / std::numbers::pi;
    constexpr double straight = 1e-4;  // degrees
    if (!upright || (!machine_.tilt && lean > straight)) {
      report(fail(diag::ToolNotUpright, place, lean,
                  machine_.tilt ? " but for the tilt along its side" : ""));
      return false;
    }
    if (machine_.tilt) {
      if (std::abs(upright->tilt) > machine_.tilt->most + straight) {
        report(fail(diag::TiltRange, place, upright->tilt, machine_.tilt->most));
        return false;
      }
      wantedTilt_ = tiltWord(*machine_.tilt, upright->tilt);
    }
    if (written.side) {
      const Vec3 third = written.axis.cross(*written.side);
      written.axis =
          matrixOf({machine_.frame.angles[0], machine_.frame.angles[1], machine_.frame.angles[2]})
              .transpose() *
          Vec3::UnitZ();
      written.side = third.cross(written.axis);
    }
    return true;
  }

  /// Behind the instruction of the move: that starts it and the program goes on, so that the axis
  /// turns during this move. Before it, it would turn during the move that is still under way.
  void turnTiltAxis() {
    if (wantedTilt_ != tiltWord_) {
      line(fmt::format("BITS {}, {} = {}", machine_.tilt->firstOutput, bitsOfTilt, wantedTilt_));
      tiltWord_ = wantedTilt_;
    }
  }

  void check(const Pose& pose, const std::string& place, bool isFrom) {
    if (machine_.envelope) {
      if (auto failure = robot::objectionToPlace(*machine_.envelope, pose, place)) {
        report(*std::move(failure));
      }
    }
    if (!machine_.scara) {
      return;
    }
    const std::optional<Upright> upright = uprightOf(pose);
    auto joints =
        jointsOf(*machine_.scara, pose.point, upright ? upright->heading : 0.0, joint4_, place);
    if (!joints) {
      report(joints.takeFailure());
    } else {
      joint4_ = joints->joint4;
      if (before_ && !isFrom) {
        if (auto failure = objectionToLine(*machine_.scara, before_->point, pose.point, place)) {
          report(*std::move(failure));
        }
      }
    }
  }

  void setSpeed(const std::string& place) {
    const double speed = rapid_ || (cycle_ && speed_ <= 0.0) ? machine_.rapid : speed_;
    rapid_ = false;
    if (speed > std::max(fastest_.speed, machine_.speed)) {
      fastest_ = {speed, place, record_->origin};
    }
    if (speed > 0.0 && number(speed) != written_) {
      written_ = number(speed);
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
  const cl::Record* record_ = nullptr;
  std::vector<std::string> lines_;
  std::vector<std::string> signalsAfterMove_;
  std::set<std::string> told_;
  std::string name_;
  std::string written_;  // the speed in force
  double millimeters_ = 1.0;
  double speed_ = 0.0;
  bool rapid_ = false;
  bool cycle_ = false;       // between its holes the tool goes as at RAPID
  bool feedMissed_ = false;  // told once
  Fastest fastest_;
  double joint4_ = 0.0;
  int tiltWord_ = 0;    // in force
  int wantedTilt_ = 0;  // of the location under way
  std::size_t location_ = 0;
  std::size_t reported_ = 0;
  std::optional<Pose> before_;
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
