#pragma once
#include <time.h>

/// Time of the processor, which other programs on the machine do not change.
namespace arelem::scenes {

/// Of the calling thread, in seconds.
[[nodiscard]] inline double cpuSeconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace arelem::scenes
