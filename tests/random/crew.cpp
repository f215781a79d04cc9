#include "tests/random/crew.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "tests/random/cpu_clock.h"

namespace arelem::scenes {

Crew::Crew(unsigned threads)
    : threads_(threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency())) {}

void Crew::tryAll(std::span<const SceneId> ids, const std::function<bool(const Finding&)>& take) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> goOn{true};
  std::mutex mutex;
  std::map<std::size_t, Finding> done;  // and not handed over yet
  std::size_t handedOver = 0;
  const auto hand = [&](std::size_t i, Finding finding) {
    const std::scoped_lock lock(mutex);
    done.emplace(i, std::move(finding));
    while (!done.empty() && done.begin()->first == handedOver) {
      if (!take(done.begin()->second)) {
        goOn = false;
      }
      done.erase(done.begin());
      ++handedOver;
    }
  };
  std::vector<std::jthread> workers;
  for (std::size_t t = 0; t < std::min(threads_, ids.size()); ++t) {
    workers.emplace_back([&] {
      const Folder folder;
      for (std::size_t i = 0; goOn && (i = next++) < ids.size();) {
        const double start = cpuSeconds();
        Finding finding = tryScene(drawScene(ids[i]), folder);
        finding.seconds = cpuSeconds() - start;
        hand(i, std::move(finding));
      }
    });
  }
}

}  // namespace arelem::scenes
