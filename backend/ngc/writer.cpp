#include "backend/ngc/writer.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "backend/ngc/moves.h"
#include "ir/cl/vendor.h"
#include "ir/diag/ngc.h"

namespace arelem::backend {

namespace {

using ngc::BlockWriter;
using ngc::Machine;

constexpr int secondsDecimals = 3;
constexpr int speedDecimals = 1;
constexpr double secondsOfAMinute = 60.0;

double millimetersOf(Word unit) {
  switch (unit) {
    case Word::CM:
      return 10.0;
    case Word::INCHES:
      return 25.4;
    case Word::FEET:
      return 304.8;
    default:
      return 1.0;
  }
}

/// OUTTOL before any statement, part unit.
constexpr double defaultBand = 0.0005;

class NgcWriter : public Writer {
 public:
  NgcWriter(std::ostream& out, Machine machine, DiagnosticSink& sink)
      : machine_(std::move(machine)),
        sink_(sink),
        block_(out, machine_),
        moves_(block_, machine_, sink) {}

  void accept(const cl::Record& record) override {
    record_ = &record;
    moves_.setRecord(record);
    if (ended_) {
      return;
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
    const std::string_view name = post.foreign.empty() ? spell(post.word) : post.foreign;
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
    block_.code(machine_.inches ? "G20" : "G21");
    for (const char* code : {"G40", "G49", "G80", "G90", "G91.1"}) {
      block_.code(code);
    }
    block_.modal('p', "G17");
    block_.modal('f', "G94");
    block_.end();
    if (machine_.blend > 0.0) {
      block_.code("G64");
      block_.length('P', machine_.blend);
    } else {
      block_.code("G61");
    }
    block_.end();
  }

  void end() {
    if (ended_) {
      return;
    }
    line(machine_.end);
    ended_ = true;
  }

  void line(std::string_view code) {
    block_.code(code);
    block_.end();
  }

  void comment(const std::string& text) {
    const std::size_t most = machine_.lineLimit - 2;
    if (text.size() > most) {
      sink_.accept(diagnose(record_->origin, diag::NgcLineCut, text.size(), machine_.lineLimit));
    }
    block_.comment(text);
  }

  void insert(const std::string& text) {
    std::string own = text.substr(0, machine_.lineLimit);
    if (own.size() < text.size()) {
      sink_.accept(diagnose(record_->origin, diag::NgcLineCut, text.size(), machine_.lineLimit));
    }
    block_.raw(own);
    // What it changed is not known.
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
      case Word::STOP:
        return line("M0");
      case Word::OPSTOP:
        return line("M1");
      case Word::END:
        return end();
      case Word::TRACUT:
      case Word::COPY:
      case Word::INDEX:
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
      return line("M5");
    }
    if (const auto turns = firstNumber(post)) {
      moves_.setSpindle(*turns);
      block_.number('S', *turns, speedDecimals);
      running_ = true;
    }
    if (running_) {
      counter_ = has(post, "CCLW") || (counter_ && !has(post, "CLW"));
      line(counter_ ? "M4" : "M3");
    }
  }

  void coolant(const cl::Post& post) {
    line(has(post, "OFF") ? "M9" : has(post, "MIST") ? "M7" : "M8");
  }

  void tool(const cl::Post& post) {
    const auto number = firstNumber(post);
    if (!number || *number < 1.0 || *number != std::floor(*number)) {
      return ignored(fmt::format("{} without a whole number", spell(post.word)));
    }
    const auto whole = static_cast<long long>(*number);
    line(fmt::format("T{} M6", whole));
    if (machine_.toolLength) {
      line(fmt::format("G43 H{}", whole));
    }
  }

  void delay(const cl::Post& post) {
    const double value = firstNumber(post).value_or(0.0);
    const double speed = moves_.spindle();
    const bool turns = has(post, "REV") && speed > 0.0;
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

  Machine machine_;
  DiagnosticSink& sink_;
  BlockWriter block_;
  ngc::Moves moves_;
  const cl::Record* record_ = nullptr;
  double unit_ = 1.0;
  double inner_ = 0.0, outer_ = defaultBand;
  bool toleranceRead_ = false;
  bool started_ = false, percent_ = false, ended_ = false;
  bool running_ = false, counter_ = false;
  std::set<std::string> warned_;
};

}  // namespace

std::unique_ptr<Writer> makeNgcWriter(std::ostream& out, const Context&, DiagnosticSink& sink) {
  return std::make_unique<NgcWriter>(out, Machine{}, sink);
}

}  // namespace arelem::backend
