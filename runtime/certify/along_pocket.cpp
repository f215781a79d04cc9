// POCKET: its locations against bottom, walls and what is to be cleared.
#include "ir/diag/verify.h"
#include "runtime/certify/association.h"

namespace arelem::certify {

using runtime::Action;

void Association::takePocket(const Action& action, const Run& run) {
  if (!pocket_) {
    pocket_ = OpenPocket{&action, pocketTask(std::get<runtime::Pocket>(action.body), modal_), {}};
  }
  for (const Location& l : pathOf(run)) {
    pocket_->path.push_back(l.toolEnd);
    moveTo(l);
  }
  if (pocket_->task && endsWithOutline(*pocket_->task, pocket_->path, options_.slack)) {
    judgePocket();
  }
}

void Association::judgePocket() {
  if (!pocket_) {
    return;
  }
  const OpenPocket open = *std::exchange(pocket_, std::nullopt);
  ++index_;
  StatementResult result;
  result.origin = open.action->origin;
  result.isn = open.action->isn;
  result.statement = "POCKET";
  result.cutVectors = open.path.size();
  const auto objection = [&](Failure failure) {
    check_.report(result, *open.action, std::move(failure));
  };
  if (!open.task) {
    objection(open.task.failure());
    add(std::move(result));
    return;
  }
  const PocketTask& task = *open.task;
  const PocketStray off = offBottom(task, open.path);
  const WallStray beyond = beyondWalls(task, open.path);
  const bool flat = off.away <= options_.slack;
  const bool inside = beyond.away <= options_.slack;
  result.stops.push_back({"its bottom", "ON", off.away, flat});
  result.stops.push_back({"its walls", "TO", beyond.away, inside});
  if (!flat) {
    objection(fail(diag::PocketOffBottom, std::uint64_t{off.location + 1}, off.away));
  }
  if (!inside) {
    objection(fail(diag::PocketBeyondWall, std::uint64_t{beyond.location + 1}, beyond.away,
                   std::uint64_t{beyond.point + 1}));
  }
  if (!endsWithOutline(task, open.path, options_.slack)) {
    objection(fail(diag::PocketOutline, std::uint64_t{task.corners.size()}));
  } else if (const auto left =
                 task.reach ? uncleared(task, open.path, options_.slack) : std::nullopt) {
    objection(fail(left->certain ? diag::PocketUncleared : diag::PocketUndecided, left->place.x(),
                   left->place.y(), left->place.z(), left->away, *task.reach));
  }
  add(std::move(result));
}

}  // namespace arelem::certify
