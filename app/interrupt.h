#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "app/exit_code.h"

#include "ir/limits.h"

namespace arelem::app {

/// Turns SIGINT and SIGTERM into a flag that long computations look at, and guarantees that the
/// process ends: if it is still at work `grace` after the signal, `lastWill` runs on the watching
/// thread (it must remove temporary files) and the process exits at once. One object lives in main;
/// it must be made before any other thread.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  [[nodiscard]] const InterruptFlag& flag() const { return interrupted_; }
  /// `ok` when no signal came, else `interrupted` or `terminated`.
  [[nodiscard]] ExitCode result() const;
  void setLastWill(std::function<void()> lastWill);

  /// From now on SIGINT ends a computation, not the process: it sets the flag and calls `onSignal`,
  /// on the watching thread. SIGTERM does the same and still ends the process.
  void converse(std::function<void(int)> onSignal);
  /// Forgets a SIGINT, before the next computation.
  void forget();

 private:
  void watch();
  bool tell(int number);

  InterruptFlag interrupted_{false};
  std::atomic<int> signal_{0};
  std::mutex mutex_;
  std::condition_variable finished_;
  bool done_ = false;
  std::function<void()> lastWill_;
  std::function<void(int)> onSignal_;  ///< set while there is a conversation
  std::thread thread_;
};

}  // namespace arelem::app
