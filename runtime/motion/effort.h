#pragma once
#include <algorithm>
#include <cstdint>

namespace arelem::motion {

/// Gaps that the calling thread has measured so far: what a motion costs, on every machine the
/// same.
[[nodiscard]] std::uint64_t gapsMeasured();

/// What a motion may cost: so many gaps for each cut vector on the average, and as many as for a
/// hundred of them to find the first.
class Effort {
 public:
  explicit Effort(std::uint64_t each)
      : each_(std::clamp<std::uint64_t>(each, 1, mostEach)), began_(gapsMeasured()) {
    allow(0);
  }

  void allow(std::uint64_t cutVectors) { allowed_ = each_ * (beforeFirst + cutVectors); }
  [[nodiscard]] bool isSpent() const { return gapsMeasured() - began_ >= allowed_; }

 private:
  static constexpr std::uint64_t beforeFirst = 100;
  static constexpr std::uint64_t mostEach = 1ULL << 30U;  ///< which nothing takes
  std::uint64_t each_, began_, allowed_ = 0;
};

}  // namespace arelem::motion
