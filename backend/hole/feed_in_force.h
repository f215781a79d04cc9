#pragma once
#include <optional>
#include <utility>

namespace arelem::backend::hole {

/// The feed in force. A canned cycle may have one of its own, which ends with the cycle; a feed
/// that comes meanwhile holds behind it too.
template <class Feed>
class FeedInForce {
 public:
  [[nodiscard]] const Feed& now() const { return now_; }
  /// FEDRAT.
  void set(const Feed& feed) {
    now_ = feed;
    if (outside_) {
      outside_ = feed;
    }
  }
  void beginCycle(const Feed& own) {
    endCycle();
    outside_ = std::exchange(now_, own);
  }
  void endCycle() { now_ = std::exchange(outside_, std::nullopt).value_or(now_); }

 private:
  Feed now_{};
  std::optional<Feed> outside_;
};

}  // namespace arelem::backend::hole
