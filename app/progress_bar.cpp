#include "app/progress_bar.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace arelem::app {

namespace {
constexpr std::size_t widest = 40;  // of the bar
constexpr std::size_t narrowest = 8;
constexpr int usualColumns = 80;
constexpr std::chrono::milliseconds quiet{1000};
constexpr std::chrono::milliseconds between{100};

int columnsOfTerminal() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col
                                                                           : usualColumns;
}

/// A terminal whose cursor goes back and whose lines can be erased.
bool isTerminal() {
  const char* const kind = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe)
  return ::isatty(STDERR_FILENO) != 0 && (kind == nullptr || std::string_view(kind) != "dumb");
}

std::string timeText(double seconds) {
  return seconds < 100.0 ? fmt::format(", {:.0f} s left", std::ceil(seconds))
                         : fmt::format(", {:.0f} min left", std::ceil(seconds / 60.0));
}
}  // namespace

std::string progressLine(
    std::string_view what, std::size_t done, std::size_t all, int columns, double secondsLeft) {
  const std::size_t room =
      static_cast<std::size_t>(std::max(columns, 2)) - 1;  // no line is wrapped
  const std::string count = fmt::format(" {}/{}", done, all);
  const std::string left = timeText(secondsLeft);
  const std::size_t words = what.size() + count.size();
  const std::size_t frame = 3;  // " [" and "]"
  if (room >= words + frame + narrowest) {
    const bool timed = room >= words + left.size() + frame + narrowest;
    const std::size_t width = std::min(widest, room - words - frame - (timed ? left.size() : 0));
    const std::string bar(all > 0 ? width * done / all : 0, '#');
    return fmt::format("{} [{:<{}}]{}{}", what, bar, width, count, timed ? left : "");
  }
  return (std::string(what) + count).substr(0, room);
}

runtime::ProgressCall progressOnTerminal() {
  using Clock = std::chrono::steady_clock;
  if (!isTerminal()) {
    return {};
  }
  struct Bar {
    Clock::time_point begun = Clock::now();
    Clock::time_point next = begun + quiet;
    std::size_t before = 0;  ///< steps of the work in hand that were done at the last call
    bool shown = false;
  };
  auto state = std::make_shared<Bar>();
  return [state](std::string_view what, std::size_t done, std::size_t all) {
    const Clock::time_point now = Clock::now();
    if (done <= state->before) {  // other work
      state->begun = now;
    }
    state->before = done;
    if (done == all) {
      // Erased at its end, so that messages begin on a clean line.
      std::cerr << (state->shown ? "\r\x1b[K" : "") << std::flush;
      state->shown = false;
      state->before = 0;
    } else if (now >= state->next) {
      state->next = now + between;
      state->shown = true;
      const double spent = std::chrono::duration<double>(now - state->begun).count();
      const double ahead =
          static_cast<double>(all - done) / static_cast<double>(std::max<std::size_t>(done, 1));
      std::cerr << '\r' << progressLine(what, done, all, columnsOfTerminal(), spent * ahead)
                << "\x1b[K" << std::flush;
    }
  };
}

}  // namespace arelem::app
