#pragma once
#include <optional>
#include <string>

#include "backend/ngc/block.h"
#include "ir/cl/record.h"
#include "ir/diag/result.h"

namespace arelem::backend::ngc {

/// CUTCOM: the control offsets the path to one side by what a register holds (G41, G42, G40). The
/// codes stand in the block of the next straight move, on which the control comes to the offset or
/// leaves it.
class Compensation {
 public:
  explicit Compensation(BlockWriter& block) : block_(block) {}

  /// CUTCOM/LEFT or RIGHT [,XYPLAN] [,n], CUTCOM/ON, CUTCOM/OFF. Without n it is the register of
  /// the number of the tool. Errors: E0670.
  [[nodiscard]] std::optional<Failure> accept(const cl::Post& post);
  void setTool(long long number) { tool_ = number; }

  /// Whether the path is offset, or will be from the next straight move on.
  [[nodiscard]] bool isOn() const { return wanted_.has_value(); }
  /// Whether the next move must be a straight one.
  [[nodiscard]] bool isPending() const { return wanted_ != written_; }
  /// The register in force, 0 where there is none.
  [[nodiscard]] long long reg() const { return wanted_ ? wanted_->reg : 0; }
  /// Adds the codes that are due to the block of a straight move.
  void put();
  /// Ends it in a block of its own, before the end of the program.
  void finish();

 private:
  struct State {
    bool left = true;
    long long reg = 0;
    bool operator==(const State&) const = default;
  };

  BlockWriter& block_;
  std::optional<State> wanted_, written_;
  std::optional<State> last_;  // what CUTCOM/ON turns on again
  long long tool_ = 0;
};

}  // namespace arelem::backend::ngc
