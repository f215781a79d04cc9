#pragma once
#include <pthread.h>
#include <time.h>

/// Time of the processor, which other programs on the machine do not change.
namespace arelem::scenes {

/// Of a thread, in seconds.
[[nodiscard]] inline double cpuSeconds(clockid_t clock = CLOCK_THREAD_CPUTIME_ID) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// The clock of the calling thread, for others to read while it lives.
[[nodiscard]] inline clockid_t ownClock() {
  clockid_t clock = CLOCK_THREAD_CPUTIME_ID;
  pthread_getcpuclockid(pthread_self(), &clock);
  return clock;
}

}  // namespace arelem::scenes
