#pragma once
#include <random>
#include <string>
#include <vector>

namespace arelem::fuzz {

/// Changes part programs: bytes, lines, words of the vocabulary, numbers, pieces of other programs.
/// The same seed gives the same texts.
class Mutator {
 public:
  Mutator(std::vector<std::string> corpus, std::uint64_t seed)
      : corpus_(std::move(corpus)), random_(seed) {}
  /// A program of the corpus with one to eight changes.
  [[nodiscard]] std::string next();

 private:
  [[nodiscard]] std::size_t below(std::size_t bound) {
    return bound == 0 ? 0 : std::uniform_int_distribution<std::size_t>(0, bound - 1)(random_);
  }
  [[nodiscard]] std::string token();
  [[nodiscard]] std::pair<std::size_t, std::size_t> line(const std::string& text);
  void change(std::string& text);

  std::vector<std::string> corpus_;
  std::mt19937_64 random_;
};

}  // namespace arelem::fuzz
