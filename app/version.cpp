#include "app/version.h"

namespace arelem::app {

std::string releaseText() {
  return ARELEM_VERSION;
}

std::string versionText() {
  const std::string commit = ARELEM_COMMIT;
  return releaseText() + (commit.empty() ? std::string{} : " (" + commit + ")");
}

}  // namespace arelem::app
