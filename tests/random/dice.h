#pragma once
#include <cstdint>
#include <initializer_list>
#include <iterator>

#include "ir/space/vector.h"

namespace arelem::scenes {

/// Random numbers that are the same on every machine: splitmix64. One sequence for each scene.
class Dice {
 public:
  Dice(std::uint64_t seed, std::uint64_t pair, std::uint64_t number) : state_(seed) {
    for (const std::uint64_t key : {pair, number}) {
      state_ = next() ^ (key * 0x9E3779B97F4A7C15U);
    }
    static_cast<void>(next());
  }

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
  }
  /// A number from `low` to `high`, in steps of a 4096th of the range: programs stay readable.
  double among(double low, double high) {
    return low + (high - low) * static_cast<double>(next() >> 52U) / 4096.0;
  }
  bool chance(double share) { return among(0.0, 1.0) < share; }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() >> 11U) % count; }
  template <class T>
  T choice(std::initializer_list<T> list) {
    return *std::next(list.begin(), static_cast<std::ptrdiff_t>(below(list.size())));
  }
  /// Evenly over all directions, nearly.
  Vec3 direction() {
    for (;;) {
      const double x = among(-1.0, 1.0), y = among(-1.0, 1.0), z = among(-1.0, 1.0);
      const Vec3 v(x, y, z);
      if (v.squaredNorm() > 0.01 && v.squaredNorm() < 1.0) {
        return v.normalized();
      }
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace arelem::scenes
