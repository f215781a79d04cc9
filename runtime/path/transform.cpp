#include "runtime/path/transform.h"

#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "ir/diag/curves.h"
#include "ir/diag/interpret.h"
#include "ir/diag/limits.h"
#include "ir/diag/result.h"
#include "ir/space/tolerance.h"
#include "runtime/path/affine.h"
#include "runtime/path/copy_plan.h"
#include "runtime/path/cut_side.h"

namespace arelem::path {

namespace {

constexpr std::size_t deepestNesting = 3;
constexpr int mostCopies = 3;  ///< COPY statements that share one INDEX
constexpr std::uint64_t pollMask = 0xFFF;
constexpr std::string_view indexForm = "INDEX/i or INDEX/i,NOMORE";

/// A record of a range. `copied`: what the copies inside of the range did to it.
struct Kept {
  cl::Record record;
  Affine copied;
};

/// One INDEX range. It is open until INDEX/i,NOMORE or the first motion behind its COPY.
struct Range {
  double index = 0.0;
  Span origin;
  std::vector<Kept> records;
  int copies = 0;
};

class Chain : public Transformer {
 public:
  Chain(cl::RecordSink& next, DiagnosticSink& sink, const Limits& limits, const InterruptFlag* flag)
      : next_(next), sink_(sink), limits_(limits), interrupted_(flag) {}

  void accept(const cl::Record& record) override {
    if (stopped_) {
      return;
    }
    if (std::holds_alternative<cl::Motion>(record.body)) {
      closeCopied();
    }
    if (const auto* post = std::get_if<cl::Post>(&record.body);
        post != nullptr && post->foreign.empty()) {
      switch (post->word) {
        case Word::TRACUT:
          return tracut(record, *post);
        case Word::INDEX:
          return index(record, *post);
        case Word::COPY:
          return copy(record, *post);
        case Word::CUTCOM:
          side_ = sideOf(record);
          if (tracut_ && side_) {
            warnOfSide(record.origin, *tracut_, Word::TRACUT, *side_);
          }
          break;
        default:
          break;
      }
    }
    pass(record);
  }

  void finish() override {
    if (stopped_) {
      return;  // what stands behind the limit was not looked at
    }
    closeCopied();
    for (const Range& range : open_) {
      sink_.accept(diagnose(range.origin, diag::IndexUnused, range.index));
    }
    for (const auto& [number, range] : closed_) {
      if (range.copies == 0) {
        sink_.accept(diagnose(range.origin, diag::IndexUnused, number));
      }
    }
  }

 private:
  void tracut(const cl::Record& record, const cl::Post& post) {
    const auto* matrix =
        post.arguments.size() == 1 ? std::get_if<cl::SurfaceValue>(&post.arguments[0]) : nullptr;
    const Word* word = post.arguments.size() == 1 ? std::get_if<Word>(&post.arguments[0]) : nullptr;
    if (matrix != nullptr && matrix->canon.size() == 12) {
      tracut_ = Affine::fromRows(matrix->canon);
      tracutOrigin_ = record.origin;
      if (side_) {
        warnOfSide(record.origin, *tracut_, Word::TRACUT, *side_);
      }
    } else if (word != nullptr && *word == Word::NOMORE) {
      tracut_.reset();
    } else {
      report(record, fail(diag::TracutForm, fmt::format("{} parameters", post.arguments.size())));
    }
    emit(record);
  }

  void pass(const cl::Record& record) {
    if (!tracut_) {
      emit(record);
      return;
    }
    warnOfTilt(record, *tracut_, Word::TRACUT, tracutOrigin_);
    cl::Record moved = record;
    move(moved, *tracut_);
    emit(moved);
  }

  /// A location without its axis cannot tell that the matrix tilted the tool. Told once a
  /// statement.
  void warnOfTilt(const cl::Record& record, const Affine& by, Word word, const Span& statement) {
    const auto* motion = std::get_if<cl::Motion>(&record.body);
    if (motion == nullptr || motion->withAxis || tilted_.count(statement) != 0) {
      return;
    }
    const Vec3 turned = by.direction(Vec3::UnitZ());
    if ((turned - Vec3::UnitZ()).lpNorm<Eigen::Infinity>() > tolerance::nullDirection) {
      sink_.accept(at(statement, fail(diag::TiltedWithoutAxis, spell(word))));
      tilted_.insert(statement);
    }
  }

  /// The side of CUTCOM is a word for the machine and stays, where a mirror changes it. Told once a
  /// statement.
  void warnOfSide(const Span& statement, const Affine& by, Word word, Word side) {
    if (by.linear.determinant() < 0.0 && mirrored_.insert(statement).second) {
      sink_.accept(at(statement, fail(diag::MirroredSide, spell(word), spell(side))));
    }
  }

  void index(const cl::Record& record, const cl::Post& post) {
    closeCopied();
    const std::vector<cl::Value>& v = post.arguments;
    const double* number = v.empty() ? nullptr : std::get_if<double>(&v[0]);
    const Word* end = v.size() == 2 ? std::get_if<Word>(&v[1]) : nullptr;
    if (number == nullptr || v.size() > 2 || (v.size() == 2 && (!end || *end != Word::NOMORE))) {
      report(record, fail(diag::CopyCount, "INDEX", v.size(), indexForm));
    } else if (end != nullptr) {
      endRange(record, *number);
      return;
    } else if (known(*number)) {
      report(record, fail(diag::IndexAgain, *number));
    } else if (open_.size() >= deepestNesting) {
      report(record, fail(diag::CopyNesting, *number, open_.size() + 1));
    } else {
      emit(record);
      open_.push_back({*number, record.origin, {}, 0});
      return;
    }
    emit(record);
  }

  [[nodiscard]] bool known(double number) const {
    for (const Range& range : open_) {
      if (range.index == number) {
        return true;
      }
    }
    return closed_.count(number) != 0;
  }

  /// INDEX/i,NOMORE belongs to the range, as its last record. Behind a COPY it ends nothing more.
  void endRange(const cl::Record& record, double number) {
    if (closed_.count(number) == 0 && isInnermost(record, number, "INDEX")) {
      open_.back().records.push_back({record, {}});
      close();
    }
    emit(record);
  }

  bool isInnermost(const cl::Record& record, double number, std::string_view word) {
    if (!open_.empty() && open_.back().index == number) {
      return true;
    }
    report(record, known(number) ? fail(diag::CopyOverlap, number, open_.back().index)
                                 : fail(diag::CopyWithoutIndex, word, number));
    return false;
  }

  /// Moves the innermost range to the closed ones.
  void close() {
    closed_.insert_or_assign(open_.back().index, std::move(open_.back()));
    open_.pop_back();
  }

  /// Another COPY may follow a COPY at once and then copies its copies too; what follows a motion
  /// does not, so that no range grows for ever.
  void closeCopied() {
    while (!open_.empty() && open_.back().copies > 0) {
      close();
    }
  }

  void copy(const cl::Record& record, const cl::Post& post) {
    Result<CopyPlan> plan = readCopy(post.arguments);
    if (!plan) {
      report(record, plan.takeFailure());
      emit(record);
      return;
    }
    while (!open_.empty() && open_.back().copies > 0 && open_.back().index != plan->index) {
      close();
    }
    const bool isClosed = closed_.count(plan->index) != 0;
    if (isClosed || isInnermost(record, plan->index, "COPY")) {
      Range& range = isClosed ? closed_.at(plan->index) : open_.back();
      if (++range.copies > mostCopies) {
        report(record, fail(diag::CopyTooOften, plan->index, range.copies));
      } else {
        repeat(record, *plan, range);
      }
    }
    emit(record);
  }

  void repeat(const cl::Record& record, const CopyPlan& plan, const Range& range) {
    cl::Record head = record;
    head.body = cl::Post{Word::INDEX, "", {plan.index}};
    // An open range takes its own copies in.
    const std::size_t count = range.records.size();
    // Nests of COPY multiply: what cannot be written is told before it is begun.
    const double all = static_cast<double>(plan.times) * static_cast<double>(count + 1);
    if (!stopped_ && static_cast<double>(written_) + all > static_cast<double>(limits_.records)) {
      report(record, fail(diag::LimitRecords, limits_.records));
      stopped_ = true;
      return;
    }
    Affine matrix;
    for (std::uint64_t k = 1; k <= plan.times && !stopped_; ++k) {
      matrix = plan.step(k, matrix);
      emit(head);
      for (std::size_t i = 0; i < count && !stopped_; ++i) {
        const Kept original = range.records[i];
        warnOfTilt(original.record, matrix, Word::COPY, record.origin);
        if (const std::optional<Word> side = sideOf(original.record)) {
          warnOfSide(record.origin, matrix, Word::COPY, *side);
        }
        // The outer copy moves what the inner ones then move on, as the old system did.
        const Kept copy{original.record, original.copied.after(matrix)};
        cl::Record moved = copy.record;
        move(moved, copy.copied);
        next(moved);
        keep(copy);
      }
    }
  }

  void emit(const cl::Record& record) {
    next(record);
    keep({record, {}});
  }

  void next(const cl::Record& record) {
    if (stopped_) {
      return;
    }
    if (written_ >= limits_.records) {
      report(record, fail(diag::LimitRecords, limits_.records));
      stopped_ = true;
      return;
    }
    if ((++written_ & pollMask) == 0 && interrupted_ != nullptr &&
        interrupted_->load(std::memory_order_relaxed)) {
      stopped_ = true;
      return;
    }
    next_.accept(record);
  }

  void keep(const Kept& kept) {
    for (Range& range : open_) {
      if (!stopped_) {
        range.records.push_back(kept);
      }
    }
  }

  void report(const cl::Record& record, Failure failure) {
    sink_.accept(at(record.origin, std::move(failure)));
  }

  cl::RecordSink& next_;
  DiagnosticSink& sink_;
  Limits limits_;
  const InterruptFlag* interrupted_;
  std::optional<Affine> tracut_;
  Span tracutOrigin_;
  std::set<Span> tilted_;           // statements whose tilt was told
  std::set<Span> mirrored_;         // statements that mirror CUTCOM, as told
  std::optional<Word> side_;        // of CUTCOM, where it is on
  std::vector<Range> open_;         // outermost first
  std::map<double, Range> closed_;  // by number, for this and later COPYs
  std::uint64_t written_ = 0;
  bool stopped_ = false;
};

}  // namespace

std::unique_ptr<Transformer> makeTransformer(cl::RecordSink& next,
                                             DiagnosticSink& sink,
                                             const Limits& limits,
                                             const InterruptFlag* interrupted) {
  return std::make_unique<Chain>(next, sink, limits, interrupted);
}

}  // namespace arelem::path
