#pragma once
#include "ir/cl/record.h"

namespace arelem::app {

/// Passes records on and sees to how many decimals the places of a CL file are written.
class DecimalsSeen : public cl::RecordSink {
 public:
  explicit DecimalsSeen(cl::RecordSink& next) : next_(next) {}
  void accept(const cl::Record& record) override;
  /// 0 where the numbers have too many decimals to be rounded, or hardly any: those are written by
  /// hand.
  [[nodiscard]] int decimals() const {
    return decimals_ < fewest || decimals_ > most ? 0 : decimals_;
  }

 private:
  static constexpr int fewest = 2, most = 6;
  cl::RecordSink& next_;
  int decimals_ = 0;  ///< that all numbers so far need; above `most`: exact numbers
};

}  // namespace arelem::app
