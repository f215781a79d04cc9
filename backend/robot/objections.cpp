#include "backend/robot/objections.h"

#include <algorithm>

#include <fmt/ranges.h>

namespace arelem::robot {

namespace {
constexpr std::size_t mostListed = 5;
}  // namespace

void Objections::add(Objection objection, std::size_t location, const Span& origin) {
  auto kind = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& one) {
    return one.worst.failure.row == objection.failure.row;
  });
  if (kind == kinds_.end()) {
    kind = kinds_.insert(kinds_.end(), Kind{objection, origin, 0, {}, 0});
  } else if (objection.excess > kind->worst.excess) {
    kind->worst = std::move(objection);
    kind->origin = origin;
  }
  if (kind->count > 0 && kind->last == location) {
    return;
  }
  ++kind->count;
  kind->last = location;
  if (kind->first.size() < mostListed) {
    kind->first.push_back(location);
  }
}

void Objections::report(std::size_t locations, DiagnosticSink& sink) const {
  for (const Kind& kind : kinds_) {
    Diagnostic told = at(kind.origin, kind.worst.failure);
    if (kind.count > 1) {
      told.notes.push_back(fmt::format("{} of {} locations are so, this one is the worst: {}{}",
                                       kind.count, locations, fmt::join(kind.first, ", "),
                                       kind.count > kind.first.size() ? ", ..." : ""));
    }
    sink.accept(std::move(told));
  }
}

}  // namespace arelem::robot
