#pragma once
#include <optional>

#include "ir/cl/record.h"
#include "ir/hole/cycle.h"
#include "ir/space/vector.h"

namespace arelem::hole {

/// Hands records on with the holes of cycles move by move: over the hole, down, peck by peck, and
/// up again, for pictures and the like. RAPID, FEDRAT and DELAY stand before the moves that they
/// concern; all moves of a hole but the first continue its statement. Cycles that are no known
/// holes go on as they are.
class Drilled : public cl::RecordSink {
 public:
  explicit Drilled(cl::RecordSink& next) : next_(next) {}
  void accept(const cl::Record& record) override;

 private:
  void change(const cl::Record& record, const cl::Post& post);
  void drill(const cl::Record& record, const cl::Motion& motion);
  void say(const cl::Record& from, cl::Post post);

  cl::RecordSink& next_;
  Cycles cycles_;
  std::optional<cl::Post> feed_;  ///< in force outside of cycles
  bool passed_ = false;           ///< a cycle that is no known hole went on, and has not ended
  bool ownFeed_ = false;          ///< the cycle's feed was handed on last
  std::optional<Vec3> at_;
};

}  // namespace arelem::hole
