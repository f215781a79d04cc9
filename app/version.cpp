#include "app/version.h"

namespace arelem::app {

std::string versionText() {
  const std::string commit = ARELEM_COMMIT;
  return ARELEM_VERSION + (commit.empty() ? std::string{} : " (" + commit + ")");
}

}  // namespace arelem::app
