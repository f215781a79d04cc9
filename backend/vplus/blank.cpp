#include "backend/vplus/blank.h"

#include <cmath>
#include <numbers>
#include <ostream>
#include <set>

#include "backend/robot/feed.h"
#include "ir/cl/post_word.h"
#include "ir/diag/ngc.h"
#include "ir/diag/robot.h"
#include "ir/hole/cycle.h"
#include "ir/space/robot_tolerance.h"
#include "ir/words/units.h"

namespace arelem::backend {

namespace {
class BlankWriter : public Writer {
 public:
  BlankWriter(std::ostream& out, robot::VplusStyle::Format format, DiagnosticSink& sink)
      : out_(out), format_(format), sink_(sink) {}

  void accept(const cl::Record& record) override {
    if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
      if (!motion->withSide) {
        if (!refused_) {
          sink_.accept(diagnose(record.origin, diag::VplusPose));
          refused_ = true;
        }
        return;
      }
      for (std::size_t i = 0; i + 9 <= motion->coordinates.size(); i += 9) {
        speed();
        origin_ = record.origin;
        move(motion->coordinates.data() + i);
      }
    } else if (const auto* units = std::get_if<cl::Units>(&record.body)) {
      millimeters_ = millimetersOf(units->unit);
    } else if (const auto* post = std::get_if<cl::Post>(&record.body)) {
      word(*post, record.origin);
    } else if (const auto* text = std::get_if<cl::Text>(&record.body);
               text != nullptr && text->word == Word::INSERT) {
      without("INSERT", record.origin);
    } else if (std::holds_alternative<cl::Raw>(record.body)) {
      without("a record of an unknown class", record.origin);
    }
  }
  void finish() override {
    speed();
    out_ << text_;
    out_.flush();
  }

 private:
  static double plain(double value) { return std::abs(value) < 0.05 ? 0.0 : value; }

  void word(const cl::Post& post, const Span& origin) {
    if (cl::isApplied(post)) {
      return;
    }
    switch (post.foreign.empty() ? post.word : Word::INSERT) {
      case Word::FEDRAT:
        return feed(post, origin);
      case Word::RAPID:
        return without("RAPID, the way between strokes has the speed of the stroke before,",
                       origin);
      case Word::SPRAY:
        return without("SPRAY, the robot switches its gun by itself,", origin);
      case Word::CYCLE:
        if (auto failure = hole::objectionToDrilling(post)) {
          sink_.accept(at(origin, *std::move(failure)));
        }
        return;
      case Word::MACHIN:
      case Word::END:
        return;
      default:
        without(cl::nameOf(post), origin);
    }
  }
  void feed(const cl::Post& post, const Span& origin) {
    if (Result<double> speed = robot::neededSpeed(post, millimeters_)) {
      speed_ = *speed;
    } else {
      sink_.accept(at(origin, speed.takeFailure()));
    }
  }
  void without(std::string_view what, const Span& origin) {
    if (told_.insert(std::string(what)).second) {
      sink_.accept(diagnose(origin, diag::VplusWithout, what));
    }
  }

  void move(const double* c) {
    const double angle = plain(std::atan2(c[7], c[6]) * 180.0 / std::numbers::pi);
    if (std::hypot(c[3], c[4]) > tolerance::uprightAxis) {
      without("the tilt of the tool", origin_);
    }
    text_ += fmt::format("move trans({:5.1f},{:5.1f},({:5.1f}+offset),", plain(millimeters_ * c[0]),
                         plain(millimeters_ * c[1]), plain(millimeters_ * c[2]));
    place_ = {c[0], c[1], c[2]};
    text_ += format_ == robot::VplusStyle::Format::pathS ? fmt::format("0,180,{:5.1f})\n", angle)
                                                         : fmt::format("{:5.1f},180,0)\n", angle);
    moved_ = true;
  }
  void speed() {
    if (moved_) {
      if (speed_ <= 0.0 && !slow_) {
        sink_.accept(diagnose(origin_, diag::NgcFeedMissing, place_.x(), place_.y(), place_.z()));
        slow_ = true;
      }
      text_ += fmt::format("speed ({:5.1f}*scale), rotate MMPS \n", speed_);
    }
  }

  std::ostream& out_;
  robot::VplusStyle::Format format_;
  DiagnosticSink& sink_;
  std::string text_;
  double speed_ = 0.0;
  double millimeters_ = 1.0;
  Vec3 place_ = Vec3::Zero();
  Span origin_;
  std::set<std::string> told_;
  bool slow_ = false;  // a missing feed is told once
  bool moved_ = false;
  bool refused_ = false;
};
}  // namespace

std::unique_ptr<Writer> makeBlankWriter(std::ostream& out,
                                        const robot::Machine& machine,
                                        DiagnosticSink& sink) {
  return std::make_unique<BlankWriter>(out, machine.vplus.format, sink);
}

}  // namespace arelem::backend
