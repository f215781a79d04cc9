#pragma once
#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace arelem::parallel {

inline constexpr unsigned mostThreads = 16;

/// Calls `work` on as many threads at once as the machine has and `portions` keep busy, the
/// caller's among them, and waits for all. They share the portions out among themselves; `work`
/// must not throw.
template <class Work>
void withCrew(std::size_t portions, const Work& work) {
  const unsigned processors = std::clamp(std::thread::hardware_concurrency(), 1U, mostThreads);
  std::vector<std::thread> crew;
  for (std::size_t i = 1; i < std::min<std::size_t>(processors, portions); ++i) {
    crew.emplace_back(work);
  }
  work();
  for (std::thread& one : crew) {
    one.join();
  }
}

}  // namespace arelem::parallel
