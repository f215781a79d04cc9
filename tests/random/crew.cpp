#include "tests/random/crew.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace arelem::scenes {

namespace {
using Clock = std::chrono::steady_clock;
/// For one scene. Other programs may keep the machine busy.
constexpr std::chrono::seconds longest{120};

/// What the watch knows of a thread.
struct Place {
  InterruptFlag interrupted{false};
  std::atomic<Clock::rep> began{0};  ///< 0: at no scene
};

void stopSlow(std::vector<Place>& places, const std::atomic<bool>& done) {
  while (!done) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const auto limit = (Clock::now() - longest).time_since_epoch().count();
    for (Place& place : places) {
      const Clock::rep began = place.began;
      if (began != 0 && began < limit) {
        place.interrupted = true;
      }
    }
  }
}
}  // namespace

Crew::Crew(unsigned threads)
    : threads_(threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency())) {}

std::vector<Finding> Crew::tryAll(std::span<const SceneId> ids) {
  std::vector<Finding> findings(ids.size());
  std::vector<Place> places(threads_);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> done{false};
  std::jthread watch([&] { stopSlow(places, done); });
  {
    std::vector<std::jthread> workers;
    for (unsigned t = 0; t < threads_; ++t) {
      workers.emplace_back([&, t] {
        const Folder folder;
        Place& place = places[t];
        for (std::size_t i = next++; i < ids.size(); i = next++) {
          place.interrupted = false;
          place.began = Clock::now().time_since_epoch().count();
          findings[i] = tryScene(drawScene(ids[i]), folder, place.interrupted);
          place.began = 0;
        }
      });
    }
  }
  done = true;
  return findings;
}

}  // namespace arelem::scenes
