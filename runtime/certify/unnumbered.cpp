// Paths whose records carry no statement numbers: how much of the path belongs to each statement.
#include <algorithm>
#include <array>

#include "runtime/certify/association.h"

namespace arelem::certify {

using runtime::Action;
using runtime::Follow;

/// How many of the locations from `used` belong to the action: one, or for a motion those up to the
/// first that stands at a check surface.
std::size_t Association::lengthOf(const Action& action, const Run& all, std::size_t used) {
  if (const auto* along = std::get_if<runtime::FollowSpline>(&action.body)) {
    return lengthAlong(*along, all, used);
  }
  const auto* follow = std::get_if<Follow>(&action.body);
  const auto drive = follow != nullptr ? named(follow->drive) : Result<Named>(Named{});
  if (follow == nullptr || !drive) {
    return 1;
  }
  ++index_;  // what comes behind it implies check surfaces
  const std::vector<Goal> goals = goalsOf(*follow);
  --index_;
  std::array<Location, 2> last{Location{modal_.toolEnd, modal_.axis}, {}};
  for (std::size_t i = used; i < all.locations.size(); ++i) {
    last[1] = order_.programmed(all.locations[i]);
    if (!all.withAxis) {
      last[1].axis = modal_.axisAt(last[1].toolEnd, drive->surface);
    }
    for (std::size_t g = 0; g < goals.size(); ++g) {
      if (check_.missed(modal_, goals[g], g, last, drive->surface) == 0.0) {
        return i + 1 - used;
      }
    }
    last[0] = last[1];
  }
  return all.locations.size() - used;
}

void Association::takeAll(const Run& all) {
  std::size_t used = 0;
  while (used < all.locations.size()) {
    const Action* action = advance();
    const bool copies = order_.expectsCopy();
    if (action == nullptr && !copies) {
      break;
    }
    const std::size_t wanted = copies ? order_.copyLength() : lengthOf(*action, all, used);
    const std::size_t count = std::min(wanted, all.locations.size() - used);
    const auto from = all.locations.begin() + static_cast<std::ptrdiff_t>(used);
    const Run run{{from, from + static_cast<std::ptrdiff_t>(count)}, all.withAxis};
    used += count;
    if (copies) {
      judgeCopy(run);
    } else {
      judge(*action, order_.programmed(run));
    }
    order_.keep(run);
  }
  surplus(std::span(all.locations).subspan(used));
}

}  // namespace arelem::certify
