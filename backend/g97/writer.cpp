#include "backend/g97/writer.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>

#include "backend/g97/block.h"
#include "backend/robot/machine.h"
#include "backend/text/clean.h"
#include "ir/diag/g97.h"

namespace arelem::backend {

namespace {
using namespace g97;

constexpr double secondsOfAMinute = 60.0;
constexpr double millimetersOfAnInch = 25.4;
constexpr int largestSpeed = 9999;

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
    if (blocks_.empty()) {
      sink_.accept(diagnose(nowhere, diag::G97Empty));
      return;
    }
    const std::vector<std::vector<Block>> programs = split();
    const robot::G97Style& style = machine_.g97;
    if (programs.size() > 1) {
      const int last = style.program + static_cast<int>(programs.size()) - 1;
      if (!style.programLine || last > largestSpeed) {
        sink_.accept(diagnose(nowhere, diag::G97TooLong, blocks_.size(), mostBlocks));
        return;
      }
      sink_.accept(diagnose(nowhere, diag::G97Split, blocks_.size(), mostBlocks, programs.size(),
                            style.program, last));
    }
    int number = style.program;
    for (const std::vector<Block>& program : programs) {
      if (style.programLine) {
        out_ << fmt::format("O{:04}\r\n", number++);
      }
      for (std::size_t i = 0; i < program.size(); ++i) {
        out_ << textOf(program[i], static_cast<int>(i) + 1, i + 1 == program.size());
      }
    }
    out_.flush();
  }

  void operator()(const cl::Motion& motion) {
    const std::size_t stride = motion.stride();
    for (std::size_t i = 0; i + stride <= motion.coordinates.size(); i += stride) {
      const double* c = motion.coordinates.data() + i;
      const Vec3 axis = motion.withAxis ? Vec3(c[3], c[4], c[5]) : Vec3(Vec3::UnitZ());
      const std::optional<Vec3> side =
          motion.withSide ? std::optional(Vec3(c[6], c[7], c[8])) : std::nullopt;
      moveTo(millimeters_ * Vec3(c[0], c[1], c[2]), axis, side);
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
      case Word::TRACUT:
      case Word::COPY:
      case Word::INDEX:
      case Word::MACHIN:
      case Word::END:
        return;  // done already, or said by the program itself
      default:
        without(spell(post.word));
    }
  }
  void operator()(const cl::Text& text) {
    if (text.word == Word::INSERT) {
      without("INSERT");
    }
  }
  void operator()(const cl::Units& units) {
    millimeters_ = units.unit == Word::CM       ? 10.0
                   : units.unit == Word::INCHES ? millimetersOfAnInch
                   : units.unit == Word::FEET   ? 12.0 * millimetersOfAnInch
                                                : 1.0;
  }
  template <class Other>
  void operator()(const Other&) {
  }  // what tells of surfaces, tolerances and the cutter moves nothing

 private:
  void report(Failure failure) {
    constexpr std::size_t most = 20;
    if (reported_++ < most) {
      sink_.accept(at(record_->origin, std::move(failure)));
    }
  }
  void without(std::string_view word) {
    if (told_.insert(std::string(word)).second) {
      sink_.accept(diagnose(record_->origin, diag::G97Without, printableAscii(word)));
    }
  }
  static const double* numberAt(const cl::Post& post, std::size_t i) {
    return i < post.arguments.size() ? std::get_if<double>(&post.arguments[i]) : nullptr;
  }
  static bool has(const cl::Post& post, Word word) {
    return std::find(post.arguments.begin(), post.arguments.end(), cl::Value(word)) !=
           post.arguments.end();
  }

  void feed(const cl::Post& post) {
    const double* value = numberAt(post, 0);
    if (value == nullptr || has(post, Word::IPR) || has(post, Word::MMPR)) {
      report(fail(diag::G97Speed, value == nullptr ? 0.0 : *value));
      return;
    }
    speed_ = has(post, Word::MMPS)   ? *value
             : has(post, Word::MMPM) ? *value / secondsOfAMinute
             : has(post, Word::IPM)  ? *value * millimetersOfAnInch / secondsOfAMinute
                                     : *value * millimeters_ / secondsOfAMinute;
    rapid_ = false;
  }

  /// At the target of the block before; a second change there needs a block of its own.
  void spray(const cl::Post& post) {
    const double* output = numberAt(post, 1);
    const Block::Switch change{output == nullptr ? 1 : static_cast<int>(*output),
                               has(post, Word::ON)};
    if (blocks_.empty()) {
      report(fail(diag::G97NoPlace, change.on ? "SPRAY/ON" : "SPRAY/OFF"));
      return;
    }
    if (on_.count(change.output) == static_cast<std::size_t>(change.on)) {
      return;  // it is so already
    }
    change.on ? void(on_.insert(change.output)) : void(on_.erase(change.output));
    if (blocks_.back().change) {
      blocks_.push_back(blocks_.back());
    }
    blocks_.back().change = change;
  }

  std::optional<Angles> anglesFor(const Vec3& axis, const std::optional<Vec3>& side) {
    const robot::G97Style& style = machine_.g97;
    if (style.source) {
      std::optional<Angles> angles = sourceAngles(axis.normalized());
      if (!angles) {
        report(fail(diag::G97SourceAxis, axis.x(), axis.y(), axis.z()));
      }
      return angles;
    }
    return anglesOf(axis, side, style.fixedAxes ? Reading::fixed : Reading::moving);
  }

  void moveTo(const Vec3& place, const Vec3& axis, const std::optional<Vec3>& side) {
    const std::optional<Angles> angles = anglesFor(axis, side);
    const bool joint = rapid_ || blocks_.empty();  // nothing is known of where the robot stands
    const double speed = joint ? machine_.rapid : speed_;
    rapid_ = false;
    const std::size_t number = ++location_;
    if (!angles || !inReach(place, number)) {
      return;
    }
    const double rounded = std::round(speed);
    if (!(rounded >= 1.0 && rounded <= largestSpeed)) {
      report(fail(diag::G97Speed, speed));
      return;
    }
    if (machine_.speed > 0.0 && speed > machine_.speed) {
      report(fail(diag::G97Fast, number, speed, machine_.speed));
    }
    const robot::G97Style& style = machine_.g97;
    blocks_.push_back({!joint,
                       static_cast<int>(rounded),
                       {style.wrist, style.arm, style.turns},
                       place,
                       *angles,
                       std::nullopt});
  }

  bool inReach(const Vec3& place, std::size_t number) {
    constexpr std::array names = {"X", "Y", "Z"};
    for (int i = 0; i < 3; ++i) {
      const robot::Range& range = machine_.g97.envelope[static_cast<std::size_t>(i)];
      if (!range.has(place[i])) {
        report(fail(diag::G97Reach, number, names[static_cast<std::size_t>(i)], place[i], range.low,
                    range.high));
        return false;
      }
    }
    return true;
  }

  /// Programs of at most 9999 blocks. Divided before a P block, where the gun is off; a line
  /// longer than a program is divided anywhere: the gun is switched off at the end of a program,
  /// and the next one begins at that place and switches it on again.
  [[nodiscard]] std::vector<std::vector<Block>> split() const {
    constexpr std::size_t spare = 8;  // for the switching of outputs
    constexpr std::size_t room = mostBlocks - spare;
    std::vector<std::vector<Block>> programs;
    std::size_t from = 0;
    std::set<int> on;
    while (from < blocks_.size()) {
      std::size_t to = std::min(blocks_.size(), from + room);
      if (blocks_.size() - from <= mostBlocks && on.empty()) {
        to = blocks_.size();
      }
      std::size_t division = to;
      while (to < blocks_.size() && division > from + 1 && blocks_[division].linear) {
        --division;
      }
      to = to < blocks_.size() && division > from + 1 ? division : to;
      std::vector<Block> program;
      for (const int output : on) {
        program.push_back(blocks_[from - 1]);
        program.back().linear = false;
        program.back().change = Block::Switch{output, true};
      }
      program.insert(program.end(), blocks_.begin() + static_cast<long>(from),
                     blocks_.begin() + static_cast<long>(to));
      on = onAtEnd(program);
      release(program, on);
      programs.push_back(std::move(program));
      from = to;
    }
    return programs;
  }
  static std::set<int> onAtEnd(const std::vector<Block>& program) {
    std::set<int> on;
    for (const Block& b : program) {
      if (b.change) {
        b.change->on ? void(on.insert(b.change->output)) : void(on.erase(b.change->output));
      }
    }
    return on;
  }
  static void release(std::vector<Block>& program, const std::set<int>& on) {
    for (const int output : on) {
      if (program.back().change) {
        program.push_back(program.back());
      }
      program.back().change = Block::Switch{output, false};
    }
  }

  std::ostream& out_;
  DiagnosticSink& sink_;
  robot::Machine machine_;
  const cl::Record* record_ = nullptr;
  std::vector<Block> blocks_;
  std::set<std::string> told_;
  std::set<int> on_;
  double millimeters_ = 1.0;
  double speed_ = 0.0;
  bool rapid_ = false;
  std::size_t location_ = 0;
  std::size_t reported_ = 0;
};
}  // namespace

std::unique_ptr<Writer> makeG97Writer(std::ostream& out,
                                      const Context& context,
                                      DiagnosticSink& sink) {
  return std::make_unique<G97Writer>(out, context, sink);
}

}  // namespace arelem::backend
