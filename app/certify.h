#pragma once
#include <optional>
#include <string>

#include "app/exit_code.h"
#include "app/settings.h"

#include "ir/limits.h"

namespace arelem::app {

struct CertifyRequest {
  std::string program;
  std::string path;     ///< a CL file; "" for the path that the program itself gives
  std::optional<double> slack;  ///< part unit; without it, as certify::Options says
  bool json = false;
};

/// `arelem verify PART [CL]`: the certificate of a path, as a table or as JSON on standard output.
[[nodiscard]] ExitCode certify(const CertifyRequest& request,
                               const Settings& settings,
                               const InterruptFlag& interrupted);

}  // namespace arelem::app
