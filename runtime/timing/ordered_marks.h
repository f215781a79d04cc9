#pragma once
#include <bit>
#include <cstdint>
#include <vector>

namespace arelem::timing {

/// A set of whole numbers below a bound that finds its next smaller and larger member in a few
/// steps: bits in 64-way levels.
class OrderedMarks {
 public:
  explicit OrderedMarks(std::size_t bound) {
    do {
      bound = (bound + 63) / 64;
      levels_.emplace_back(bound, 0);
    } while (bound > 1);
  }
  void insert(std::size_t i) {
    for (auto& level : levels_) {
      level[i / 64] |= std::uint64_t{1} << (i % 64);
      i /= 64;
    }
  }
  [[nodiscard]] bool contains(std::size_t i) const {
    return (levels_[0][i / 64] >> (i % 64) & 1U) != 0;
  }
  /// The largest member below i. There is one.
  [[nodiscard]] std::size_t before(std::size_t i) const {
    for (std::size_t k = 0;; ++k) {
      const std::uint64_t bits = levels_[k][i / 64] & ((std::uint64_t{1} << (i % 64)) - 1);
      i /= 64;
      if (bits != 0) {
        return descend(k, i, bits, true);
      }
    }
  }
  /// The smallest member above i. There is one.
  [[nodiscard]] std::size_t after(std::size_t i) const {
    for (std::size_t k = 0;; ++k) {
      const std::uint64_t mask = i % 64 == 63 ? 0 : ~std::uint64_t{0} << (i % 64 + 1);
      const std::uint64_t bits = levels_[k][i / 64] & mask;
      i /= 64;
      if (bits != 0) {
        return descend(k, i, bits, false);
      }
    }
  }

 private:
  [[nodiscard]] std::size_t descend(std::size_t k,
                                    std::size_t word,
                                    std::uint64_t bits,
                                    bool last) const {
    for (;; --k) {
      const auto bit =
          static_cast<std::size_t>(last ? 63 - std::countl_zero(bits) : std::countr_zero(bits));
      word = word * 64 + bit;
      if (k == 0) {
        return word;
      }
      bits = levels_[k - 1][word];
    }
  }

  std::vector<std::vector<std::uint64_t>> levels_;
};

}  // namespace arelem::timing
