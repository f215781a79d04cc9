#include "backend/ngc/writer.h"

#include <cmath>

#include "backend/ngc/moves.h"
#include "backend/ngc/parameters.h"
#include "backend/ngc/statements.h"
#include "backend/robot/machine.h"
#include "ir/cl/post_word.h"
#include "ir/cl/vendor.h"
#include "ir/diag/ngc.h"
#include "ir/space/motion_tolerance.h"
#include "ir/words/units.h"

namespace arelem::backend {

namespace {

using ngc::BlockWriter;
using ngc::Control;

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
        moves_(block_, control_, turning_ ? &*turning_ : nullptr, sink),
        statements_(block_, control_, moves_, sink) {}

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
    outer_ = toleranceRead_ ? outer_ : tolerance::defaultOutside * unit_;
    moves_.setBand(inner_ + outer_);
  }
  void operator()(const cl::Values& body) {
    const double value = body.values.empty() ? 0.0 : std::abs(body.values.front()) * unit_;
    inner_ = body.word == Word::INTOL ? value : inner_;
    outer_ = body.word == Word::OUTTOL ? value : outer_;
    if (body.word == Word::CUTTER) {
      moves_.setCutter(value / unit_);
    }
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
    if (cl::isApplied(post) || cl::nameOf(post) == "MACHLM") {
      return;  // the time law has read the limits
    }
    if (const auto apt = cl::inApt(post)) {
      return word(*apt);
    }
    if (!post.foreign.empty()) {
      return statements_.ignored(post.foreign, ngc::written(post), record_->origin);
    }
    word(post);
  }
  void operator()(const cl::Switch&) {}
  void operator()(const cl::Multax&) {}
  void operator()(const cl::Diagnostic&) {}
  void operator()(const cl::Listing&) {}
  void operator()(const cl::Card&) {}
  void operator()(const cl::Raw&) {
    constexpr std::string_view what = "a record of an unknown class";
    statements_.ignored(what, what, record_->origin);
  }

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
    moves_.compensation().finish();
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
    block_.forgetAll();
  }

  void word(const cl::Post& post) {
    switch (post.word) {
      case Word::RAPID:
        return moves_.rapid();
      case Word::FEDRAT:
        return moves_.feed(post);
      case Word::CYCLE:
        return moves_.cycle(post);
      case Word::END:
        return end();
      case Word::MACHIN:
        return;  // for others
      default:
        return statements_.accept(post, record_->origin);
    }
  }

  Control control_;
  std::optional<robot::Turning> turning_;
  DiagnosticSink& sink_;
  BlockWriter block_;
  ngc::Moves moves_;
  ngc::Statements statements_;
  const cl::Record* record_ = nullptr;
  double unit_ = 1.0;
  double inner_ = 0.0, outer_ = tolerance::defaultOutside;
  bool toleranceRead_ = false;
  bool started_ = false, percent_ = false, ended_ = false, lost_ = false;
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
