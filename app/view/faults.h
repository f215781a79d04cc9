#pragma once
#include <vector>

#include "app/pipeline.h"

#include "backend/fault_mark.h"
#include "ir/cl/record.h"

namespace arelem::app {

/// Finds the motion statements of the program itself that have errors, in the order of the path,
/// while the records of what could be computed pass by. Errors stand in the log of the job before
/// the records of later statements come.
class FaultTrace : public cl::RecordSink {
 public:
  explicit FaultTrace(const Compilation& job) : job_(job) {}
  void accept(const cl::Record& record) override;
  /// At most `mostFaults`, after the last record.
  [[nodiscard]] std::vector<backend::FaultMark> marks() const;

 private:
  /// The places of one record.
  struct Way {
    bool here = false;        ///< of a statement of the program itself
    std::uint32_t begin = 0;  ///< of that statement
    Vec3 first, last;
  };
  const Compilation& job_;
  std::vector<Way> ways_;  ///< the last one, and all from the first error on
};

inline constexpr std::size_t mostFaults = 60;

}  // namespace arelem::app
