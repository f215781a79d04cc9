#include "app/interrupt.h"

#include <chrono>
#include <csignal>

#include <pthread.h>
#include <unistd.h>

namespace arelem::app {

namespace {
constexpr std::chrono::milliseconds grace{120};  // the promise is 200 ms, with the unwinding inside
constexpr int wakeUp = SIGUSR2;                  // ends the watching thread

sigset_t watched() {
  sigset_t set;
  sigemptyset(&set);
  for (const int number : {SIGINT, SIGTERM, wakeUp}) {
    sigaddset(&set, number);
  }
  return set;
}
}  // namespace

InterruptWatch::InterruptWatch() {
  const sigset_t set = watched();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  thread_ = std::thread([this] { watch(); });
}

InterruptWatch::~InterruptWatch() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  finished_.notify_all();
  pthread_kill(thread_.native_handle(), wakeUp);
  thread_.join();
}

ExitCode InterruptWatch::result() const {
  switch (signal_.load()) {
    case 0:
      return ExitCode::ok;
    case SIGTERM:
      return ExitCode::terminated;
    default:
      return ExitCode::interrupted;
  }
}

void InterruptWatch::setLastWill(std::function<void()> lastWill) {
  const std::lock_guard lock(mutex_);
  lastWill_ = std::move(lastWill);
}

void InterruptWatch::watch() {
  const sigset_t set = watched();
  int number = 0;
  while (sigwait(&set, &number) != 0) {
  }
  if (number == wakeUp) {
    return;
  }
  signal_.store(number);
  interrupted_.store(true);
  std::unique_lock lock(mutex_);
  if (finished_.wait_for(lock, grace, [this] { return done_; })) {
    return;
  }
  if (lastWill_) {
    lastWill_();
  }
  _exit(static_cast<int>(result()));
}

}  // namespace arelem::app
