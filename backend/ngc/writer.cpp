#include "backend/ngc/writer.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "backend/ngc/moves.h"
#include "backend/robot/machine.h"
#include "ir/cl/post_word.h"
#include "ir/cl/vendor.h"
#include "ir/diag/ngc.h"
#include "ir/words/units.h"

namespace arelem::backend {

namespace {

using ngc::BlockWriter;
using ngc::Control;

constexpr int secondsDecimals = 3;
constexpr int speedDecimals = 1;
constexpr double secondsOfAMinute = 60.0;

/// OUTTOL before any statement, part unit.
constexpr double defaultBand = 0.0005;

class NgcWriter : public Writer {
 public:
  NgcWriter(std::ostream& out,
            Control control,
            std::optional<robot::Turning> turning,
            DiagnosticSink& sink)
      : control_(std::move(control)),
        turning_(std::move(turning)),
        sink_(sink),
        block_(out, control_),
        moves_(block_, control_, turning_ ? &*turning_ : nullptr, sink) {}

  void accept(const cl::Record& record) override {
    record_ = &record;
    moves_.setRecord(record);
    if (ended_) {
      return behindEnd(record);
    }
    std::visit(*this, record.body);
  }

  void finish() override {
    start();
    end();
    block_.raw("%");
    block_.finish();
  }

  void operator()(const cl::Motion& motion) {
    start();
    moves_.move(motion);
  }
  void operator()(const cl::Surface& body) { moves_.setSurface(body.surface); }
  void operator()(const cl::Units& body) {
    unit_ = millimetersOf(body.unit);
    moves_.setUnit(unit_);
    outer_ = toleranceRead_ ? outer_ : defaultBand * unit_;
    moves_.setBand(inner_ + outer_);
  }
  void operator()(const cl::Values& body) {
    const double value = body.values.empty() ? 0.0 : std::abs(body.values.front()) * unit_;
    inner_ = body.word == Word::INTOL ? value : inner_;
    outer_ = body.word == Word::OUTTOL ? value : outer_;
    toleranceRead_ = toleranceRead_ || body.word != Word::CUTTER;
    moves_.setBand(inner_ + outer_);
  }
  void operator()(const cl::Text& body) {
    if (body.word == Word::INSERT) {
      start();
      insert(body.text);
    } else {
      if (body.word == Word::PARTNO && !started_) {
        block_.raw("%");
        percent_ = true;
      } else {
        start();
      }
      comment(body.text);
    }
  }
  void operator()(const cl::Fini&) {
    start();
    end();
  }
  void operator()(const cl::Post& post) {
    start();
    const std::string_view name = cl::nameOf(post);
    if (name == "SMOOTH" || name == "MACHLM") {
      return;  // done before, or for others
    }
    if (const auto apt = cl::inApt(post)) {
      return word(*apt);
    }
    if (!post.foreign.empty()) {
      return ignored(post.foreign);
    }
    word(post);
  }
  void operator()(const cl::Switch&) {}
  void operator()(const cl::Multax&) {}
  void operator()(const cl::Diagnostic&) {}
  void operator()(const cl::Listing&) {}
  void operator()(const cl::Card&) {}
  void operator()(const cl::Raw&) { ignored("a record of an unknown class"); }

 private:
  void start() {
    if (started_) {
      return;
    }
    started_ = true;
    if (!percent_) {
      block_.raw("%");
    }
    block_.code(control_.inches ? "G20" : "G21");
    for (const char* code : {"G40", "G49", "G80", "G90", "G91.1"}) {
      block_.code(code);
    }
    block_.modal('p', "G17");
    block_.modal('f', "G94");
    block_.end();
    if (!control_.offset.empty()) {
      line(control_.offset);
    }
    if (control_.blend > 0.0) {
      block_.code("G64");
      block_.length('P', control_.blend);
      block_.length('Q', 0.5 * control_.blend);
    } else {
      block_.code("G61");
    }
    block_.end();
  }

  void end() {
    if (ended_) {
      return;
    }
    line(control_.end);
    ended_ = true;
  }

  void line(std::string_view code) {
    block_.code(code);
    block_.end();
  }

  /// The program ended; a move that comes now would be lost.
  void behindEnd(const cl::Record& record) {
    const auto* motion = std::get_if<cl::Motion>(&record.body);
    if (motion != nullptr && motion->kind != cl::Motion::Kind::from && !lost_) {
      lost_ = true;
      sink_.accept(diagnose(record.origin, diag::NgcAfterEnd));
    }
  }

  void comment(const std::string& text) {
    const std::size_t most = control_.lineLimit - 2;
    if (text.size() > most) {
      sink_.accept(diagnose(record_->origin, diag::NgcLineCut, text.size(), control_.lineLimit));
    }
    block_.comment(text);
  }

  void insert(const std::string& text) {
    std::string own = text.substr(0, control_.lineLimit);
    if (own.size() < text.size()) {
      sink_.accept(diagnose(record_->origin, diag::NgcLineCut, text.size(), control_.lineLimit));
    }
    block_.raw(own);
    forgetAll();
  }

  /// What a line of the program's own changed is not known.
  void forgetAll() {
    for (const char group : {'m', 'p', 'f', 'F'}) {
      block_.forget(group);
    }
    block_.forgetAxes();
  }

  void ignored(std::string_view what) {
    if (warned_.insert(std::string(what)).second) {
      sink_.accept(diagnose(record_->origin, diag::NgcWordIgnored, what));
    }
    block_.comment(what);
  }

  static std::optional<double> firstNumber(const cl::Post& post) {
    for (const cl::Value& value : post.arguments) {
      if (const double* number = std::get_if<double>(&value)) {
        return *number;
      }
    }
    return std::nullopt;
  }
  /// The number behind a word.
  static std::optional<double> after(const cl::Post& post, Word wanted) {
    for (std::size_t i = 0; i + 1 < post.arguments.size(); ++i) {
      const Word* word = std::get_if<Word>(&post.arguments[i]);
      const double* number = std::get_if<double>(&post.arguments[i + 1]);
      if (word != nullptr && *word == wanted && number != nullptr) {
        return *number;
      }
    }
    return std::nullopt;
  }
  static bool has(const cl::Post& post, std::string_view wanted) {
    return std::any_of(post.arguments.begin(), post.arguments.end(), [&](const cl::Value& value) {
      const Word* word = std::get_if<Word>(&value);
      const std::string* text = std::get_if<std::string>(&value);
      return (word != nullptr && spell(*word) == wanted) || (text != nullptr && *text == wanted);
    });
  }

  void word(const cl::Post& post) {
    switch (post.word) {
      case Word::RAPID:
        return moves_.rapid();
      case Word::FEDRAT:
        return moves_.feed(post);
      case Word::CYCLE:
        return moves_.cycle(post);
      case Word::SPINDL:
        return spindle(post);
      case Word::COOLNT:
        return coolant(post);
      case Word::LOADTL:
      case Word::TURRET:
        return tool(post);
      case Word::DELAY:
        return delay(post);
      case Word::AUXFUN:
      case Word::PREFUN:
        return function(post);
      case Word::STOP:
        return line("M0");
      case Word::OPSTOP:
        return line("M1");
      case Word::END:
        return end();
      case Word::TRACUT:
      case Word::COPY:
      case Word::INDEX:
      case Word::VTLAXS:
      case Word::WCORN:
      case Word::MACHIN:
        return;  // done before, or for others
      default:
        break;
    }
    if (spell(post.word) == "SPRAY") {
      return spray(post);
    }
    ignored(spell(post.word));
  }

  void spindle(const cl::Post& post) {
    if (has(post, "OFF")) {
      moves_.setSpindle(ngc::Moves::Spindle::off);
      return line("M5");
    }
    for (const std::string_view mode : {"SFM", "SMM", "ORIENT", "LOCK", "MAXRPM"}) {
      if (has(post, mode)) {
        sink_.accept(diagnose(record_->origin, diag::NgcSpindleMode, mode));
        return;
      }
    }
    if (const auto turns = firstNumber(post)) {
      moves_.setSpindle(std::abs(*turns));
      block_.number('S', std::abs(*turns), speedDecimals);
      counter_ = *turns < 0.0;
      running_ = true;
    }
    if (running_) {
      counter_ = has(post, "CCLW") || (counter_ && !has(post, "CLW"));
      moves_.setSpindle(counter_ ? ngc::Moves::Spindle::counterclockwise
                                 : ngc::Moves::Spindle::clockwise);
      line(counter_ ? "M4" : "M3");
    }
  }

  void coolant(const cl::Post& post) {
    line(has(post, "OFF") ? "M9" : has(post, "MIST") ? "M7" : "M8");
  }

  /// AUXFUN/n and PREFUN/n: the codes Mn and Gn of the control, as the program says.
  void function(const cl::Post& post) {
    const auto number = firstNumber(post);
    if (!number || *number < 0.0 || *number > 999.0 || post.arguments.size() != 1) {
      return ignored(fmt::format("{} without a code from 0 to 999", spell(post.word)));
    }
    line(fmt::format("{}{:g}", post.word == Word::AUXFUN ? 'M' : 'G', *number));
    forgetAll();
  }

  void tool(const cl::Post& post) {
    const auto number = firstNumber(post);
    if (!number || *number < 1.0 || *number != std::floor(*number)) {
      return ignored(fmt::format("{} without a whole number", spell(post.word)));
    }
    const auto whole = static_cast<long long>(*number);
    line(fmt::format("T{} M6", whole));
    if (control_.toolLength) {
      line(fmt::format("G43 H{}",
                       static_cast<long long>(after(post, Word::ADJUST).value_or(*number))));
    }
    // Where the changer leaves the axes is not known.
    block_.forgetAxes();
  }

  void delay(const cl::Post& post) {
    const double value = firstNumber(post).value_or(0.0);
    const double speed = moves_.spindle();
    const bool turns = has(post, "REV") && speed > 0.0;
    if (value < 0.0) {
      sink_.accept(
          at(record_->origin,
             fail(diag::NgcValue, fmt::format("DELAY/{:.9g}: a control waits 0 or more", value))));
      return;
    }
    block_.code("G4");
    block_.number('P', turns ? value * secondsOfAMinute / speed : value, secondsDecimals);
    block_.end();
  }

  /// SPRAY/ON,n and SPRAY/OFF,n: outputs that switch with the next move.
  void spray(const cl::Post& post) {
    const double number = firstNumber(post).value_or(1.0);
    line(fmt::format("{} P{}", has(post, "OFF") ? "M63" : "M62",
                     std::max(0LL, static_cast<long long>(number) - 1)));
  }

  Control control_;
  std::optional<robot::Turning> turning_;
  DiagnosticSink& sink_;
  BlockWriter block_;
  ngc::Moves moves_;
  const cl::Record* record_ = nullptr;
  double unit_ = 1.0;
  double inner_ = 0.0, outer_ = defaultBand;
  bool toleranceRead_ = false;
  bool started_ = false, percent_ = false, ended_ = false, lost_ = false;
  bool running_ = false, counter_ = false;
  std::set<std::string> warned_;
};

}  // namespace

std::unique_ptr<Writer> makeNgcWriter(std::ostream& out,
                                      const Context& context,
                                      DiagnosticSink& sink) {
  const robot::Machine none;
  const robot::Machine& machine = context.machine != nullptr ? *context.machine : none;
  return std::make_unique<NgcWriter>(out, machine.control.value_or(Control{}), machine.turning,
                                     sink);
}

}  // namespace arelem::backend
