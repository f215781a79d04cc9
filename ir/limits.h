#pragma once
#include <atomic>
#include <cstdint>

namespace arelem {

/// Every bound on work or size, with the name of its flag (`--max-steps N` and so on: app/limit_options.cpp) and its default.
struct Limits {
  std::uint64_t steps = 200'000'000;    ///< executed statements
  std::uint64_t depth = 64;             ///< active macro calls
  std::uint64_t records = 200'000'000;  ///< CL records written
  std::uint64_t errors = 200;           ///< errors shown before the rest is only counted
  std::uint64_t nesting = 200;          ///< nested parentheses
  std::uint64_t elements = 100'000;     ///< tokens of one statement
  std::uint64_t line = 10'000'000;      ///< bytes of one line
  std::uint64_t bytes = 2'000'000'000;  ///< bytes of one source file
  std::uint64_t points = 10'000'000;    ///< cut vectors of one motion statement
  std::uint64_t array = 10'000'000;     ///< elements of one RESERV array
  std::uint64_t definitions = 1'000'000;  ///< rows of `arelem geometry`
};

/// Set by a signal handler; long computations look at it and stop.
using InterruptFlag = std::atomic<bool>;

}  // namespace arelem
