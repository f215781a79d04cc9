#include "app/spray_progress.h"

#include <chrono>
#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <unistd.h>

namespace arelem::app {

namespace {
constexpr std::size_t width = 40;
constexpr std::chrono::milliseconds quiet{1000};
constexpr std::chrono::milliseconds between{100};
}  // namespace

runtime::ProgressCall progressOnTerminal() {
  using Clock = std::chrono::steady_clock;
  if (::isatty(STDERR_FILENO) == 0) {
    return {};
  }
  struct Bar {
    Clock::time_point next = Clock::now() + quiet;
    bool shown = false;
  };
  auto state = std::make_shared<Bar>();
  return [state](std::string_view what, std::size_t done, std::size_t all) {
    const Clock::time_point now = Clock::now();
    if (done == all) {
      // Erased at its end, so that messages begin on a clean line.
      std::cerr << (state->shown ? "\r\x1b[K" : "") << std::flush;
      state->shown = false;
    } else if (now >= state->next) {
      state->next = now + between;
      state->shown = true;
      const std::string bar(width * done / all, '#');
      std::cerr << fmt::format("\r{} [{:<{}}] {}/{}", what, bar, width, done, all) << std::flush;
    }
  };
}

}  // namespace arelem::app
