#pragma once
#include <atomic>
#include <cstdint>
#include <string_view>

namespace arelem {

/// Every bound on work or size, with its default.
struct Limits {
#define ARELEM_LIMIT(name, flag, standard, what) std::uint64_t name = standard;
#include "ir/limits.def"
#undef ARELEM_LIMIT
};

/// A row of limits.def: for the flag and for the manual.
struct LimitRow {
  std::string_view flag;  ///< "--max-steps"
  std::uint64_t Limits::*member;
  std::string_view what;
};
inline constexpr LimitRow limitTable[] = {
#define ARELEM_LIMIT(name, flag, standard, what) {flag, &Limits::name, what},
#include "ir/limits.def"
#undef ARELEM_LIMIT
};

/// Set by a signal handler; long computations look at it and stop.
using InterruptFlag = std::atomic<bool>;

}  // namespace arelem
