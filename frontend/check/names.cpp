#include "frontend/check/names.h"

#include <algorithm>

namespace arelem::frontend {

namespace {
constexpr std::size_t longestCompared = 32;

/// Edits (insert, delete, replace, swap neighbors) from a to b.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    last[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, replace});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        now[j] = std::min(now[j], before[j - 2] + 1);
      }
    }
    std::swap(before, last);
    std::swap(last, now);
  }
  return last[b.size()];
}
}  // namespace

NameFacts* Names::find(std::string_view name) {
  const auto found = facts_.find(name);
  return found == facts_.end() ? nullptr : &found->second;
}

NameFacts& Names::at(std::string_view name) {
  const auto found = facts_.find(name);
  return found != facts_.end() ? found->second : facts_[std::string(name)];
}

std::vector<std::string> Names::similar(std::string_view name, bool wordsToo) const {
  std::vector<std::pair<std::size_t, std::string>> near;
  const std::size_t most = std::max<std::size_t>(1, name.size() / 3);
  const auto consider = [&](std::string_view other) {
    const bool far = other.size() > name.size() + most || name.size() > other.size() + most;
    if (far || other == name || name.size() > longestCompared ||
        (name.size() < 2 && other.size() < 2)) {
      return;
    }
    const std::size_t distance = editDistance(name, other);
    if (distance <= most) {
      near.emplace_back(distance, std::string(other));
    }
  };
  constexpr std::size_t mostNames = 20'000;
  if (facts_.size() <= mostNames) {
    for (const auto& [other, facts] : facts_) {
      if (facts.defined && !facts.poisoned) {
        consider(other);
      }
    }
  }
  for (int w = 0; wordsToo && w < static_cast<int>(Word::count); ++w) {
    consider(spell(static_cast<Word>(w)));
  }
  std::sort(near.begin(), near.end());
  std::vector<std::string> best;
  for (const auto& [distance, other] : near) {
    if (best.size() < 3 && std::find(best.begin(), best.end(), other) == best.end()) {
      best.push_back(other);
    }
  }
  return best;
}

}  // namespace arelem::frontend
