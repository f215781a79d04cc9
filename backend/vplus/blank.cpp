#include "backend/vplus/blank.h"

#include <cmath>
#include <numbers>
#include <ostream>

#include "ir/diag/robot.h"

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
        move(motion->coordinates.data() + i);
      }
    } else if (const auto* post = std::get_if<cl::Post>(&record.body)) {
      const double* value =
          post->word == Word::FEDRAT && post->foreign.empty() && !post->arguments.empty()
              ? std::get_if<double>(&post->arguments[0])
              : nullptr;
      speed_ = value != nullptr ? *value : speed_;
    }
  }
  void finish() override {
    speed();
    out_ << text_;
    out_.flush();
  }

 private:
  static double plain(double value) { return std::abs(value) < 0.05 ? 0.0 : value; }

  void move(const double* c) {
    const double angle = plain(std::atan2(c[7], c[6]) * 180.0 / std::numbers::pi);
    text_ += fmt::format("move trans({:5.1f},{:5.1f},({:5.1f}+offset),", plain(c[0]), plain(c[1]),
                         plain(c[2]));
    text_ += format_ == robot::VplusStyle::Format::pathS ? fmt::format("0,180,{:5.1f})\n", angle)
                                                         : fmt::format("{:5.1f},180,0)\n", angle);
    moved_ = true;
  }
  void speed() {
    if (moved_) {
      text_ += fmt::format("speed ({:5.1f}*scale), rotate MMPS \n", speed_);
    }
  }

  std::ostream& out_;
  robot::VplusStyle::Format format_;
  DiagnosticSink& sink_;
  std::string text_;
  double speed_ = 0.0;
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
