#pragma once
#include <string>

#include "app/exit_code.h"
#include "app/settings.h"

#include "ir/limits.h"

namespace arelem::app {

struct CertifyRequest {
  std::string program;
  std::string path;     ///< a CL file; "" for the path that the program itself gives
  double slack = 1e-6;  ///< part unit
  bool json = false;
};

/// `arelem verify PART [CL]`: the certificate of a path, as a table or as JSON on standard output.
[[nodiscard]] ExitCode certify(const CertifyRequest& request,
                               const Settings& settings,
                               const InterruptFlag& interrupted);

}  // namespace arelem::app
