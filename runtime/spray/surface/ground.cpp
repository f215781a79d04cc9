#include "runtime/spray/surface/ground.h"

#include <algorithm>
#include <queue>

namespace arelem::spray {

Ground::Ground(std::vector<LevelSpan> spans, double low, double high) {
  std::erase_if(spans, [&](const LevelSpan& s) {
    return !(s.high > s.low) || s.high <= low || s.low >= high;
  });
  std::sort(spans.begin(), spans.end(),
            [](const LevelSpan& a, const LevelSpan& b) { return a.low < b.low; });
  std::vector<double> stops = {low, high};
  for (const LevelSpan& s : spans) {
    stops.push_back(std::clamp(s.low, low, high));
    stops.push_back(std::clamp(s.high, low, high));
  }
  std::sort(stops.begin(), stops.end());
  stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  const auto lower = [](const LevelSpan& a, const LevelSpan& b) { return a.apart < b.apart; };
  std::priority_queue<LevelSpan, std::vector<LevelSpan>, decltype(lower)> open(lower);
  std::size_t next = 0;
  levels_ = {low};
  ways_ = {0.0};
  for (std::size_t i = 1; i < stops.size(); ++i) {
    for (; next < spans.size() && spans[next].low <= stops[i - 1]; ++next) {
      open.push(spans[next]);
    }
    while (!open.empty() && open.top().high <= stops[i - 1]) {
      open.pop();
    }
    const double step = stops[i] - stops[i - 1];
    levels_.push_back(stops[i]);
    ways_.push_back(ways_.back() + (open.empty() ? 0.0 : open.top().apart * step));
  }
}

double Ground::levelAt(double way) const {
  const auto above = std::lower_bound(ways_.begin(), ways_.end(), way);
  if (above == ways_.begin()) {
    return levels_.front();
  }
  if (above == ways_.end()) {
    return levels_.back();
  }
  const auto i = static_cast<std::size_t>(above - ways_.begin());
  const double share = (way - ways_[i - 1]) / (ways_[i] - ways_[i - 1]);
  return levels_[i - 1] + share * (levels_[i] - levels_[i - 1]);
}

}  // namespace arelem::spray
