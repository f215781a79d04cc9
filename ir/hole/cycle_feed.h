#pragma once
#include <optional>
#include <utility>

namespace arelem::hole {

/// The feed in force where canned cycles come between. A cycle may have a feed of its own, which
/// ends with it; what changes meanwhile holds behind it too.
template <class Feed>
class CycleFeed {
 public:
  [[nodiscard]] const Feed& now() const { return now_; }
  /// `change` is called with every feed that it concerns.
  template <class Change>
  void alter(const Change& change) {
    change(now_);
    if (outside_) {
      change(*outside_);
    }
  }
  void set(const Feed& feed) {
    alter([&](Feed& old) { old = feed; });
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

}  // namespace arelem::hole
