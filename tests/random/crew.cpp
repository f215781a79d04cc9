#include "tests/random/crew.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iterator>
#include <mutex>
#include <optional>
#include <thread>

#include "tests/random/cpu_clock.h"

namespace arelem::scenes {

namespace {
/// For one scene, processor seconds. What a scene does is bounded by NUMPTS, the same on every
/// machine; this only ends what hangs.
constexpr double longest = 60.0;

/// What the watch knows of a thread.
struct Place {
  InterruptFlag interrupted{false};
  std::mutex mutex;                ///< guards what follows
  std::optional<clockid_t> clock;  ///< of the thread; none while it is at no scene
  double began = 0.0;

  void begin() {
    const std::lock_guard lock(mutex);
    interrupted = false;
    clock = ownClock();
    began = cpuSeconds();
  }
  void end() {
    const std::lock_guard lock(mutex);
    clock.reset();
  }
  void stopSlow() {
    const std::lock_guard lock(mutex);
    interrupted = interrupted || (clock && cpuSeconds(*clock) - began > longest);
  }
};

void stopSlow(std::vector<Place>& places, const std::atomic<bool>& done) {
  while (!done) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    for (Place& place : places) {
      place.stopSlow();
    }
  }
}

std::vector<Finding> trySlice(const Slice& slice, const Folder& folder, Place& place) {
  std::vector<Finding> findings;
  double spent = 0.0;
  for (std::uint64_t k = 0; k < slice.count && spent <= slice.seconds; ++k) {
    SceneId id = slice.first;
    id.number += k;
    place.begin();
    const double start = cpuSeconds();
    findings.push_back(tryScene(drawScene(id), folder, place.interrupted));
    spent += cpuSeconds() - start;
    place.end();
  }
  return findings;
}
}  // namespace

Crew::Crew(unsigned threads)
    : threads_(threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency())) {}

std::vector<Finding> Crew::tryAll(std::span<const Slice> slices) {
  std::vector<std::vector<Finding>> findings(slices.size());
  std::vector<Place> places(threads_);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> done{false};
  std::jthread watch([&] { stopSlow(places, done); });
  {
    std::vector<std::jthread> workers;
    for (unsigned t = 0; t < threads_; ++t) {
      workers.emplace_back([&, t] {
        const Folder folder;
        for (std::size_t i = next++; i < slices.size(); i = next++) {
          findings[i] = trySlice(slices[i], folder, places[t]);
        }
      });
    }
  }
  done = true;
  std::vector<Finding> all;
  for (std::vector<Finding>& of : findings) {
    std::ranges::move(of, std::back_inserter(all));
  }
  return all;
}

}  // namespace arelem::scenes
