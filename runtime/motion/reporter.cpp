#include "runtime/motion/reporter.h"

#include <algorithm>
#include <limits>

#include "ir/diag/limits.h"
#include "ir/diag/motion.h"
#include "runtime/motion/told.h"

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

/// The part surface stands in an earlier statement: it is shown where the message names it.
bool isTold(const EntityPtr& part, std::string_view message) {
  return part && !part->name.empty() &&
         message.find("`" + part->name + "`") != std::string_view::npos;
}

/// Where a mesh ends its contact does: how far it reaches, for faults of the path.
std::optional<std::string> reachOf(const Entity& mesh) {
  const auto count = mesh.canon.empty() ? std::size_t{0} : static_cast<std::size_t>(mesh.canon[0]);
  constexpr std::size_t head = 2;  // the numbers of vertices and triangles
  if (mesh.type != EntityType::mesh || count == 0 || mesh.canon.size() < head + 3 * count) {
    return std::nullopt;
  }
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 v(mesh.canon[head + 3 * i], mesh.canon[head + 3 * i + 1],
                 mesh.canon[head + 3 * i + 2]);
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  low = told(low);
  high = told(high);
  return fmt::format(
      "the mesh `{}` reaches from ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g})", mesh.name,
      low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
}

/// Faults that a mesh may cause by its end.
bool mayBeBeyondEnd(const DiagRow* row) {
  return row == diag::CheckNotReached.row || row == diag::NoTangency.row ||
         row == diag::StartupDiverges.row || row == diag::ContactLost.row ||
         row == diag::CutterDoesNotFit.row || row == diag::CutVectorLimit.row;
}

void noteReach(const EntityPtr& entity, Failure& failure) {
  if (entity && mayBeBeyondEnd(failure.row)) {
    auto reach = reachOf(*entity);
    auto& notes = failure.notes;
    if (reach && std::find(notes.begin(), notes.end(), *reach) == notes.end()) {
      notes.push_back(*std::move(reach));
    }
  }
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
  if (failure && state.part) {
    noteReach(state.part->entity, *failure);
  }
  if (!failure || !wasAdrift) {
    return failure;
  }
  const DiagRow* row = failure->row;
  const bool ofPlace = row == diag::OffPartSurface.row || row == diag::OffDriveSurface.row ||
                       row == diag::NoForwardDirection.row ||
                       row == diag::PerpendicularDirection.row;
  return ofPlace ? fail(diag::AfterFailure) : std::move(failure);
}

void Reporter::report(const runtime::Action& action, Failure failure, const EntityPtr& part) {
  const DiagRow& row = *failure.row;
  failed_ = failed_ || row.severity == Severity::error;
  fatal_ = fatal_ || &row == diag::Interrupted.row || &row == diag::LimitTransfers.row;
  putRecord(writer_, row);
  std::vector<EntityPtr> shown = involved(action);
  for (const EntityPtr& entity : shown) {
    noteReach(entity, failure);
  }
  if (isTold(part, failure.message)) {
    shown.push_back(part);
  }
  Diagnostic d = at(action.origin, std::move(failure));
  for (auto call = action.calls; call; call = call->outer) {
    d.calledFrom.push_back(call->call);
  }
  for (auto it = shown.begin(); it != shown.end(); ++it) {
    const EntityPtr& entity = *it;
    const bool again = std::find(shown.begin(), it, entity) != it;
    if (entity && !again && !entity->name.empty() && entity->definition.length > 0) {
      d.labels.push_back({entity->definition, "`" + entity->name + "` defined here"});
    }
  }
  sink_.accept(std::move(d));
}

}  // namespace arelem::motion
