#pragma once
#include <optional>
#include <unordered_map>
#include <vector>

#include "ir/diag/result.h"
#include "runtime/interpret/action.h"

namespace arelem::motion {

/// Whether a startup or a motion along a surface stands between the CUTTER at `index` and the next.
[[nodiscard]] bool cutterIsUsed(const std::vector<runtime::Action>& actions, std::size_t index);

/// Where TRANTO and labelled check surfaces go on.
class Labels {
 public:
  explicit Labels(const std::vector<runtime::Action>& actions);
  /// The next place with this label, or, where there is none ahead, the last one behind. Going back
  /// is refused after an error, which might come again for ever, and more often than `most` times.
  [[nodiscard]] Result<std::size_t> from(std::uint64_t key,
                                         std::size_t index,
                                         bool failed,
                                         std::uint64_t most);

 private:
  std::uint64_t goneBack_ = 0;
  std::unordered_multimap<std::uint64_t, std::size_t> places_;
};

}  // namespace arelem::motion
