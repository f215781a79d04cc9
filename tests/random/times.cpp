#include "tests/random/times.h"

#include <algorithm>

#include <fmt/format.h>

namespace arelem::scenes {

std::string Times::table() const {
  std::string text =
      fmt::format("{:<22}{:>8}{:>10}{:>10}{:>10}{:>10}  milliseconds of the processor\n",
                  "part,drive", "scenes", "median", "90 %", "99 %", "longest");
  const auto line = [&](const std::string& name, std::vector<Time> times) {
    if (times.empty()) {
      return;
    }
    std::ranges::sort(times, {}, &Time::seconds);
    const auto at = [&](double share) {
      return 1e3 *
             times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))].seconds;
    };
    text += fmt::format("{:<22}{:>8}{:>10.1f}{:>10.1f}{:>10.1f}{:>10.1f}  {}\n", name, times.size(),
                        at(0.5), at(0.9), at(0.99), at(1.0), spell(times.back().id));
  };
  std::vector<Time> all;
  for (const std::vector<Time>& times : of_) {
    all.insert(all.end(), times.begin(), times.end());
    if (!times.empty()) {
      const SceneId& id = times.front().id;
      line(fmt::format("{},{}", kinds[id.part()], kinds[id.drive()]), times);
    }
  }
  line("all", all);
  return text;
}

}  // namespace arelem::scenes
