#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace arelem::scenes {

/// What the command line asks for.
struct Request {
  std::uint64_t seed = 1, each = 1, first = 0;
  std::string pair, only;
  std::vector<std::string> kinds;  ///< only pairs of these; empty: of all
  unsigned jobs = 0;               ///< 0: one for each core
  std::string found, table, failures, commit;
  bool again = false, anew = false, times = false;
  std::optional<double> minutes;
  double slow = 1e9;
};

/// Runs the scenes and prints what failed. True when none did. Throws std::runtime_error for what
/// it does not understand.
[[nodiscard]] bool run(const Request& request);

}  // namespace arelem::scenes
