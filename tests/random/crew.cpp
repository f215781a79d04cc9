#include "tests/random/crew.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iterator>
#include <thread>

namespace arelem::scenes {

namespace {
using Clock = std::chrono::steady_clock;
/// For one scene. Other programs may keep the machine busy.
constexpr std::chrono::seconds longest{30};

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

std::vector<Finding> trySlice(const Slice& slice, const Folder& folder, Place& place) {
  std::vector<Finding> findings;
  double spent = 0.0;
  for (std::uint64_t k = 0; k < slice.count && spent <= slice.seconds; ++k) {
    SceneId id = slice.first;
    id.number += k;
    place.interrupted = false;
    const Clock::time_point start = Clock::now();
    place.began = start.time_since_epoch().count();
    findings.push_back(tryScene(drawScene(id), folder, place.interrupted));
    place.began = 0;
    spent += std::chrono::duration<double>(Clock::now() - start).count();
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
