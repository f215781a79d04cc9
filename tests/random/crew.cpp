#include "tests/random/crew.h"

#include <algorithm>
#include <atomic>
#include <thread>

#include "tests/random/cpu_clock.h"

namespace arelem::scenes {

Crew::Crew(unsigned threads)
    : threads_(threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency())) {}

std::vector<Finding> Crew::tryAll(std::span<const SceneId> ids) {
  std::vector<Finding> findings(ids.size());
  std::atomic<std::size_t> next{0};
  std::vector<std::jthread> workers;
  for (std::size_t t = 0; t < std::min(threads_, ids.size()); ++t) {
    workers.emplace_back([&] {
      const Folder folder;
      for (std::size_t i = next++; i < ids.size(); i = next++) {
        const double start = cpuSeconds();
        findings[i] = tryScene(drawScene(ids[i]), folder);
        findings[i].seconds = cpuSeconds() - start;
      }
    });
  }
  workers.clear();
  return findings;
}

}  // namespace arelem::scenes
