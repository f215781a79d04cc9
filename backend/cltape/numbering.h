#pragma once
#include <cstdint>
#include <string>

#include "ir/cl/record.h"

namespace arelem::backend {

/// Counts the records of a CLTAPE: 1, 2, 3, ... over the whole file. A 1000 record precedes the
/// records of each statement and counts too; the JSON lines, which fold it into `isn`, count the
/// same way.
class Numbering {
 public:
  /// Tells whether a 1000 record has to stand before this record, and counts it if so.
  bool opensStatement(const cl::Record& record);
  /// The number of the record written next; call once for each.
  std::int64_t next() { return ++last_; }
  [[nodiscard]] std::int64_t last() const { return last_; }

 private:
  std::int64_t last_ = 0;
  bool any_ = false;
  int isn_ = 0;
  std::string cardId_;
};

}  // namespace arelem::backend
