#include "runtime/path/swarf.h"

#include <functional>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "ir/cl/post_word.h"
#include "ir/diag/interpret.h"
#include "runtime/interpret/passed_post.h"
#include "runtime/path/swarf_section.h"
#include "runtime/path/upright_section.h"

namespace arelem::path {

namespace {
/// `Section` tilts the tool, or makes it upright again.
template <class Section>
class Swarf : public SwarfStage {
 public:
  using Make = std::function<Section(const cl::Post& on)>;
  Swarf(cl::RecordSink& next, Make make, DiagnosticSink& sink)
      : next_(next), make_(std::move(make)), sink_(sink) {}

  void accept(const cl::Record& record) override {
    const auto* any = std::get_if<cl::Post>(&record.body);
    const bool swarf = any != nullptr && (cl::is(*any, Word::VTLAXS) || cl::is(*any, Word::WCORN));
    if (swarf && !hasSwarfForm(*any)) {
      check(record, fail(diag::SwarfSection,
                         fmt::format("{} has not the parameters of its form", cl::nameOf(*any))));
    } else if (const cl::Post* post = cl::postOf(record.body, Word::VTLAXS)) {
      std::get<Word>(post->arguments.at(0)) == Word::ON ? on(record, *post) : off(record, *post);
    } else if (section_) {
      inside(record);
    } else {
      pass(record);
    }
  }

  void finish() override {
    if (section_) {
      report(began_, fail(diag::SwarfSection, "VTLAXS/ON has no VTLAXS/OFF"));
    }
    flush();
  }

 private:
  /// Holds the last motion back: it may turn out to be the first location of a section.
  void pass(const cl::Record& record) {
    if (cl::postOf(record.body, Word::WCORN) != nullptr && !dropped_) {
      report(record, fail(diag::SwarfSection, "WCORN stands outside of VTLAXS/ON and VTLAXS/OFF"));
    }
    if (std::holds_alternative<cl::Motion>(record.body)) {
      flush();
      ended_.reset();
      lost_ = false;
    } else if (held_.empty()) {
      return next_.accept(record);
    }
    held_.push_back(record);
  }
  void flush() {
    for (const cl::Record& record : held_) {
      next_.accept(record);
    }
    held_.clear();
  }

  void on(const cl::Record& record, const cl::Post& post) {
    if (section_) {
      report(record, fail(diag::SwarfSection, "VTLAXS/ON stands twice without VTLAXS/OFF between"));
      return;
    }
    if (held_.empty() && !ended_) {
      if (!lost_) {
        report(record, fail(diag::SwarfSection, "no location stands before VTLAXS/ON"));
      }
      dropped_ = true;
      return;
    }
    began_ = record;
    section_.emplace(make_(post));
    check(record, ended_ ? section_->begin(*ended_) : section_->begin(held_.front()));
    for (std::size_t i = 1; i < held_.size() && section_; ++i) {
      inside(held_[i]);
    }
    if (section_) {
      held_.clear();
      inside(record);
    }
  }

  void inside(const cl::Record& record) {
    if (cl::postOf(record.body, Word::WCORN) != nullptr) {
      return check(record, section_->corner(record));
    }
    for (const Word word : {Word::TRACUT, Word::COPY, Word::INDEX}) {
      if (cl::postOf(record.body, word) != nullptr) {
        return check(record, fail(diag::SwarfSection,
                                  fmt::format("{} stands in a section of VTLAXS", spell(word))));
      }
    }
    const auto* motion = std::get_if<cl::Motion>(&record.body);
    if (motion != nullptr && motion->kind == cl::Motion::Kind::from) {
      return check(record, fail(diag::SwarfSection, "FROM stands in a section of VTLAXS"));
    }
    check(record, section_->add(record));
  }

  void off(const cl::Record& record, const cl::Post& post) {
    if (dropped_) {
      dropped_ = false;  // what was wrong has been said
      return;
    }
    if (!section_) {
      report(record, fail(diag::SwarfSection, "VTLAXS/OFF has no VTLAXS/ON before it"));
      return;
    }
    check(record, section_->finish(post));
    if (!section_) {
      dropped_ = false;
      return;
    }
    ended_ = SwarfSection::End{section_->last(), swarfTilt(post, 1)};
    for (const cl::Record& done : section_->records()) {
      next_.accept(done);
    }
    section_.reset();
    next_.accept(record);
  }

  void check(const cl::Record& record, std::optional<Failure> failure) {
    if (failure) {
      report(record, *std::move(failure));
      section_.reset();
      dropped_ = lost_ = true;
    }
  }
  void report(const cl::Record& record, Failure failure) {
    sink_.accept(at(record.origin, std::move(failure)));
  }

  cl::RecordSink& next_;
  Make make_;
  DiagnosticSink& sink_;
  std::vector<cl::Record> held_;  ///< the last motion and what came behind it
  std::optional<Section> section_;
  std::optional<SwarfSection::End> ended_;  ///< until the next motion
  cl::Record began_;
  bool dropped_ = false;  ///< an error ended the section before its VTLAXS/OFF
  bool lost_ = false;     ///< so did it one that ended here, and no location came since
};
}  // namespace

std::unique_ptr<SwarfStage> makeSwarfStage(cl::RecordSink& next, DiagnosticSink& sink) {
  return std::make_unique<Swarf<SwarfSection>>(
      next, [](const cl::Post& on) { return SwarfSection(on); }, sink);
}

std::unique_ptr<SwarfStage> makeUprightStage(cl::RecordSink& next,
                                             double slack,
                                             DiagnosticSink& sink) {
  return std::make_unique<Swarf<UprightSection>>(
      next, [slack](const cl::Post& on) { return UprightSection(on, slack); }, sink);
}

std::optional<Span> firstSwarf(const std::vector<runtime::Action>& actions) {
  for (const runtime::Action& action : actions) {
    const cl::Post* post = runtime::passedPost(action);
    if (post != nullptr && (cl::is(*post, Word::VTLAXS) || cl::is(*post, Word::WCORN))) {
      return action.origin;
    }
  }
  return std::nullopt;
}

}  // namespace arelem::path
