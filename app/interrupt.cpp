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

void InterruptWatch::converse(std::function<void(int)> onSignal) {
  const std::lock_guard lock(mutex_);
  onSignal_ = std::move(onSignal);
}

void InterruptWatch::forget() {
  int interrupt = SIGINT;
  if (signal_.compare_exchange_strong(interrupt, 0)) {
    interrupted_.store(false);
  }
}

/// Whether the process may go on after this signal.
bool InterruptWatch::tell(int number) {
  signal_.store(number);
  interrupted_.store(true);
  std::function<void(int)> call;
  {
    const std::lock_guard lock(mutex_);
    call = onSignal_;
  }
  if (call) {
    call(number);
  }
  return call && number == SIGINT;
}

void InterruptWatch::watch() {
  const sigset_t set = watched();
  int number = 0;
  do {
    while (sigwait(&set, &number) != 0) {
    }
    if (number == wakeUp) {
      return;
    }
  } while (tell(number));
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
