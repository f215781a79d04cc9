#include "app/exit_code.h"

#include <algorithm>
#include <array>

namespace arelem::app {

ExitCode exitCodeFor(const DiagRow& row) {
  if (row.severity != Severity::error) {
    return ExitCode::ok;
  }
  // A control byte: not a text file. Code files and machine files that are no TOML or say what does
  // not exist, V+ and G97 programs that are none.
  constexpr std::array<std::string_view, 7> unreadable = {"E0102", "E0605", "E0630", "E0645",
                                                          "E0650", "E0651", "E0652"};
  if (std::find(unreadable.begin(), unreadable.end(), row.code) != unreadable.end()) {
    return ExitCode::inputUnreadable;
  }
  // Limits that belong to a room: nested calls, cut vectors, actions and records of the motion,
  // bytes of a data file, poses of a stencil, points, passes, trials and corners of spraying.
  constexpr std::array<std::string_view, 11> limits = {"E0239", "E0358", "E0359", "E0375",
                                                       "E0393", "E0418", "E0513", "E0525",
                                                       "E0551", "E0564", "E0732"};
  if (std::find(limits.begin(), limits.end(), row.code) != limits.end()) {
    return ExitCode::limitReached;
  }
  const std::string_view room = row.code.substr(0, 3);
  if (room == "E03" || room == "E05") {
    return ExitCode::geometryUnsolvable;
  }
  if (room == "E06") {
    return ExitCode::outputNotWritten;
  }
  if (room == "E07") {
    return ExitCode::inputUnreadable;
  }
  if (room == "E09") {
    return ExitCode::verificationFailed;
  }
  if (room == "E08") {
    return ExitCode::limitReached;
  }
  return ExitCode::programHasErrors;
}

ExitCode worse(ExitCode a, ExitCode b) {
  constexpr std::array order = {ExitCode::internalError,
                                ExitCode::interrupted,
                                ExitCode::terminated,
                                ExitCode::limitReached,
                                ExitCode::wrongUse,
                                ExitCode::inputUnreadable,
                                ExitCode::programHasErrors,
                                ExitCode::geometryUnsolvable,
                                ExitCode::verificationFailed,
                                ExitCode::outputNotWritten,
                                ExitCode::ok};
  return *std::find_if(order.begin(), order.end(), [&](ExitCode c) { return c == a || c == b; });
}

}  // namespace arelem::app
