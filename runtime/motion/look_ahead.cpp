#include "runtime/motion/look_ahead.h"

#include <algorithm>

#include "ir/diag/limits.h"
#include "ir/diag/motion.h"

namespace arelem::motion {

bool cutterIsUsed(const std::vector<runtime::Action>& actions, std::size_t index) {
  for (std::size_t i = index + 1; i < actions.size(); ++i) {
    const auto& body = actions[i].body;
    if (std::holds_alternative<runtime::Startup>(body) ||
        std::holds_alternative<runtime::Follow>(body) ||
        std::holds_alternative<runtime::Pocket>(body) ||
        std::holds_alternative<runtime::Transfer>(body)) {
      return true;
    }
    const auto* parameter = std::get_if<runtime::Parameter>(&body);
    if (parameter != nullptr && parameter->word == Word::CUTTER) {
      return false;
    }
  }
  return false;
}

Labels::Labels(const std::vector<runtime::Action>& actions) {
  for (std::size_t i = 0; i < actions.size(); ++i) {
    if (const auto* label = std::get_if<runtime::Label>(&actions[i].body)) {
      places_.emplace(label->key, i);
    }
  }
}

Result<std::size_t> Labels::from(std::uint64_t key,
                                 std::size_t index,
                                 bool failed,
                                 std::uint64_t most) {
  std::optional<std::size_t> ahead, behind;
  const auto [first, last] = places_.equal_range(key);
  for (auto i = first; i != last; ++i) {
    if (i->second > index) {
      ahead = std::min(ahead.value_or(i->second), i->second);
    } else {
      behind = std::max(behind.value_or(i->second), i->second);
    }
  }
  if (ahead) {
    return *ahead;
  }
  if (!behind) {
    return fail(diag::TransferTarget);
  }
  if (failed) {
    return fail(diag::NotGoneBack);
  }
  return ++goneBack_ > most ? Result<std::size_t>(fail(diag::LimitTransfers, most)) : *behind;
}

}  // namespace arelem::motion
