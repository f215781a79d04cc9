#include "runtime/motion/reporter.h"

#include "ir/diag/limits.h"
#include "ir/diag/motion.h"

namespace arelem::motion {

namespace {
/// The surfaces that a statement speaks of.
std::vector<EntityPtr> involved(const runtime::Action& action) {
  std::vector<EntityPtr> list;
  if (const auto* follow = std::get_if<runtime::Follow>(&action.body)) {
    list.push_back(follow->drive);
    for (const runtime::CheckUse& c : follow->checks) {
      list.push_back(c.use.surface);
    }
  } else if (const auto* startup = std::get_if<runtime::Startup>(&action.body)) {
    for (const runtime::SurfaceUse& s : startup->surfaces) {
      list.push_back(s.surface);
    }
  }
  return list;
}

void putRecord(RecordWriter& writer, const DiagRow& row) {
  if (row.legacy.empty()) {
    return;
  }
  const int number = std::stoi(std::string(row.legacy));
  if (number >= 0) {
    writer.put(cl::Diagnostic{number});
    return;
  }
  writer.put(cl::Listing{true});
  writer.put(cl::Diagnostic{number});
  writer.put(cl::Listing{false});
}
}  // namespace

std::optional<Failure> ofMotion(State& state, std::optional<Failure> failure) {
  const bool wasAdrift = state.adrift;
  state.adrift = failure.has_value();
  if (!failure || !wasAdrift) {
    return failure;
  }
  const DiagRow* row = failure->row;
  const bool ofPlace = row == diag::OffPartSurface.row || row == diag::OffDriveSurface.row ||
                       row == diag::NoForwardDirection.row ||
                       row == diag::PerpendicularDirection.row;
  return ofPlace ? fail(diag::AfterFailure) : std::move(failure);
}

void Reporter::report(const runtime::Action& action, Failure failure) {
  const DiagRow& row = *failure.row;
  failed_ = failed_ || row.severity == Severity::error;
  fatal_ = fatal_ || &row == diag::Interrupted.row || &row == diag::LimitTransfers.row;
  putRecord(writer_, row);
  Diagnostic d = at(action.origin, std::move(failure));
  for (auto call = action.calls; call; call = call->outer) {
    d.calledFrom.push_back(call->call);
  }
  for (const EntityPtr& entity : involved(action)) {
    if (entity && !entity->name.empty() && entity->definition.length > 0) {
      d.labels.push_back({entity->definition, "`" + entity->name + "` defined here"});
    }
  }
  sink_.accept(std::move(d));
}

}  // namespace arelem::motion
