#include "runtime/path/copy_plan.h"

#include <cmath>

#include "ir/diag/interpret.h"

namespace arelem::path {

namespace {
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
}  // namespace

Result<CopyPlan> readCopy(const std::vector<cl::Value>& values) {
  return CopyReader(values).read();
}

}  // namespace arelem::path
