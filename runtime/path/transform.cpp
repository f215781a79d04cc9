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
#include "runtime/path/cut_side.h"

namespace arelem::path {

namespace {

constexpr std::size_t deepestNesting = 3;
constexpr int mostCopies = 3;  ///< COPY statements that share one INDEX
constexpr std::uint64_t pollMask = 0xFFF;
constexpr std::string_view indexForm = "INDEX/i or INDEX/i,NOMORE";

/// The matrices of one COPY statement.
struct CopyPlan {
  double index = 0.0;
  std::uint64_t times = 0;
  Word mode = Word::SAME;
  Vec3 shift = Vec3::Zero();
  double angle = 0.0;
  Affine matrix;

  /// The matrix of the k-th copy. Shifts and angles are multiplied, not added up, so that no error
  /// grows.
  [[nodiscard]] Affine step(std::uint64_t k, const Affine& previous) const {
    switch (mode) {
      case Word::TRANSL:
        return Affine::translation(static_cast<double>(k) * shift);
      case Word::XYROT:
        return Affine::rotation(static_cast<double>(k) * angle);
      case Word::MODIFY:
        return matrix.after(previous);
      default:
        return {};
    }
  }
};

/// Reads COPY/i,SAME,n | i,TRANSL,x,y,z,n | i,XYROT,degrees,n | i,MODIFY,matrix,n.
class CopyReader {
 public:
  explicit CopyReader(const std::vector<cl::Value>& values) : values_(values) {}

  Result<CopyPlan> read() {
    CopyPlan plan;
    const double* index = number(0);
    if (index == nullptr) {
      return fail(diag::CopyCount, "COPY", values_.size(), "COPY/i,mode,...,n");
    }
    plan.index = *index;
    const Word* mode = values_.size() > 1 ? std::get_if<Word>(&values_[1]) : nullptr;
    if (mode != nullptr && *mode == Word::MIRROR) {
      return fail(diag::CopyMirror);
    }
    if (mode == nullptr) {
      return fail(diag::CopyMode, plan.index);
    }
    plan.mode = *mode;
    switch (*mode) {
      case Word::SAME:
        return counted(plan, 2, "COPY/i,SAME,n");
      case Word::TRANSL:
        if (number(2) != nullptr && number(3) != nullptr && number(4) != nullptr) {
          plan.shift = {*number(2), *number(3), *number(4)};
        }
        return counted(plan, 5, "COPY/i,TRANSL,x,y,z,n");
      case Word::XYROT:
        plan.angle = number(2) != nullptr ? *number(2) : 0.0;
        return counted(plan, 3, "COPY/i,XYROT,degrees,n");
      case Word::MODIFY:
        if (const auto* matrix =
                values_.size() > 2 ? std::get_if<cl::SurfaceValue>(&values_[2]) : nullptr;
            matrix != nullptr && matrix->canon.size() == 12) {
          plan.matrix = Affine::fromRows(matrix->canon);
          return counted(plan, 3, "COPY/i,MODIFY,matrix,n");
        }
        return fail(diag::CopyCount, "COPY", values_.size(), "COPY/i,MODIFY,matrix,n");
      default:
        return fail(diag::CopyMode, plan.index);
    }
  }

 private:
  [[nodiscard]] const double* number(std::size_t i) const {
    return i < values_.size() ? std::get_if<double>(&values_[i]) : nullptr;
  }

  /// The number of copies stands last, at `at`; everything before it but mode and matrix is a
  /// number.
  Result<CopyPlan> counted(CopyPlan plan, std::size_t at, std::string_view form) const {
    bool good = values_.size() == at + 1 && number(at) != nullptr;
    for (std::size_t i = 2; i < at && plan.mode != Word::MODIFY; ++i) {
      good = good && number(i) != nullptr;
    }
    if (!good) {
      return fail(diag::CopyCount, "COPY", values_.size(), form);
    }
    const double times = *number(at);
    constexpr double mostTimes = 1e15;
    if (times < 0.0 || times != std::floor(times) || times > mostTimes) {
      return fail(diag::CopyNegative, times);
    }
    plan.times = static_cast<std::uint64_t>(times);
    return plan;
  }

  const std::vector<cl::Value>& values_;
};

/// One INDEX range. It is open until INDEX/i,NOMORE or its first COPY.
struct Range {
  double index = 0.0;
  Span origin;
  std::vector<cl::Record> records;
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

  /// INDEX/i,NOMORE belongs to the range, as its last record.
  void endRange(const cl::Record& record, double number) {
    if (close(record, number, "INDEX", &record)) {
      next(record);
      keep(record);
    } else {
      emit(record);
    }
  }

  /// Moves the innermost range to the closed ones, if it is the wanted one.
  bool close(const cl::Record& record,
             double number,
             std::string_view word,
             const cl::Record* last) {
    if (open_.empty() || open_.back().index != number) {
      report(record, known(number) && closed_.count(number) == 0
                         ? fail(diag::CopyOverlap, number, open_.back().index)
                         : fail(diag::CopyWithoutIndex, word, number));
      return false;
    }
    if (last != nullptr) {
      open_.back().records.push_back(*last);
    }
    closed_.insert_or_assign(number, std::move(open_.back()));
    open_.pop_back();
    return true;
  }

  void copy(const cl::Record& record, const cl::Post& post) {
    Result<CopyPlan> plan = CopyReader(post.arguments).read();
    if (!plan) {
      report(record, plan.takeFailure());
      emit(record);
      return;
    }
    const bool isClosed = closed_.count(plan->index) != 0;
    if (!isClosed && !close(record, plan->index, "COPY", nullptr)) {
      emit(record);
      return;
    }
    Range& range = closed_.at(plan->index);
    if (++range.copies > mostCopies) {
      report(record, fail(diag::CopyTooOften, plan->index, range.copies));
    } else {
      repeat(record, *plan, range);
    }
    emit(record);
  }

  void repeat(const cl::Record& record, const CopyPlan& plan, const Range& range) {
    cl::Record head = record;
    head.body = cl::Post{Word::INDEX, "", {plan.index}};
    // Nests of COPY multiply: what cannot be written is told before it is begun.
    const double all =
        static_cast<double>(plan.times) * static_cast<double>(range.records.size() + 1);
    if (!stopped_ && static_cast<double>(written_) + all > static_cast<double>(limits_.records)) {
      report(record, fail(diag::LimitRecords, limits_.records));
      stopped_ = true;
      return;
    }
    Affine matrix;
    for (std::uint64_t k = 1; k <= plan.times && !stopped_; ++k) {
      matrix = plan.step(k, matrix);
      emit(head);
      for (const cl::Record& original : range.records) {
        if (stopped_) {
          return;
        }
        warnOfTilt(original, matrix, Word::COPY, record.origin);
        if (const std::optional<Word> side = sideOf(original)) {
          warnOfSide(record.origin, matrix, Word::COPY, *side);
        }
        cl::Record moved = original;
        move(moved, matrix);
        emit(moved);
      }
    }
  }

  void emit(const cl::Record& record) {
    next(record);
    keep(record);
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

  void keep(const cl::Record& record) {
    for (Range& range : open_) {
      if (!stopped_) {
        range.records.push_back(record);
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
