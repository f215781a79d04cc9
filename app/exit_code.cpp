#include "app/exit_code.h"

#include <algorithm>
#include <array>
#include <utility>

namespace arelem::app {

ExitCode exitCodeFor(const DiagRow& row) {
  if (row.severity != Severity::error) {
    return ExitCode::ok;
  }
  // Rows whose hundreds tell something else.
  constexpr std::array<std::pair<std::string_view, ExitCode>, 2> exceptions = {
      {{"E0102", ExitCode::inputUnreadable},  // a control byte: not a text file
       {"E0613", ExitCode::limitReached}}};   // records of a CL tape
  for (const auto& [code, result] : exceptions) {
    if (row.code == code) {
      return result;
    }
  }
  if (row.code.starts_with("E061")) {  // damaged CL tapes
    return ExitCode::inputUnreadable;
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
