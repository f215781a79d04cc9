#include "runtime/certify/follow_proof.h"

#include <algorithm>
#include <cmath>

#include "ir/space/motion_tolerance.h"

namespace arelem::certify {

namespace {
/// Cut vectors end anywhere in both bands, whose surfaces may meet at a small angle: a way of no
/// more bands than this may lead across the path, and does not tell from where the tool came.
constexpr double bandsAcross = 10.0;

double bandOf(const GuideTask& task) {
  return task.allowed.inner + task.allowed.outer;
}
}  // namespace

FollowProof::FollowProof(MotionCheck& check,
                         const Modal& modal,
                         const Named& drive,
                         std::span<const Goal> goals,
                         const Location& first,
                         const InterruptFlag* interrupted)
    : check_(check),
      modal_(modal),
      first_(first),
      drive_(driveTask(drive), first),
      part_(partTask(), first),
      end_(first, bandsAcross * std::max(bandOf(drive_.task()), bandOf(part_.task()))),
      interrupted_(interrupted) {
  const double pathBand = bandOf(drive_.task()) + bandOf(part_.task());
  const Vec3 path = drive_.result().firstNormal.cross(part_.result().firstNormal).normalized();
  for (std::size_t i = 0; i < goals.size(); ++i) {
    counts_.push_back(check_.countOf(modal, goals[i], i, pathBand, path, first));
  }
}

GuideTask FollowProof::driveTask(const Named& drive) const {
  GuideTask task = check_.taskOf(modal_, driveRole, drive, modal_.toolOnDrive());
  if (!modal_.driveRelation && modal_.startedOffDrive != drive.name) {
    // No tool position was ever given: ON if the tool end is on the drive surface.
    const Touch end = touch(drive.surface, {nullptr, 1.0, 0.0}, first_, task.allowed);
    if (std::abs(end.high) <= bandOf(task) + tolerance::startLength) {
      task.cutter = nullptr;
      task.thick = 0.0;
    }
  }
  return task;
}

GuideTask FollowProof::partTask() const {
  GuideTask task = check_.taskOf(modal_, partRole, modal_.partSurface(), modal_.toolOnPart());
  if (!modal_.partRelation && !modal_.startedOffPart) {
    // No such word was ever given: ON if the tool end is on the part surface and the cutter is not.
    const double slack = tolerance::startLength + bandOf(task);
    const surface::AnySurface& part = task.surface.surface;
    const auto isOff = [&](const Relation& r) {
      return std::abs(touch(part, r, first_, task.allowed).high) > slack;
    };
    if (isOff({task.cutter, 1.0, task.thick}) && isOff({task.cutter, -1.0, task.thick}) &&
        !isOff({nullptr, 1.0, 0.0})) {
      task.cutter = nullptr;
      task.thick = 0.0;
    }
  }
  return task;
}

bool FollowProof::isOff(const GuideTask& task, const Location& at, double most) {
  const auto isFar = [&](double side) {
    const Relation relation{task.cutter, side, task.thick};
    return std::abs(touch(task.surface.surface, relation, at, task.allowed).high) > most;
  };
  return isFar(1.0) && (task.cutter == nullptr || isFar(-1.0));
}

bool FollowProof::strays(const Location& at) const {
  const auto isAstray = [&](const GuideTask& task) {
    return isOff(task, at, 2.0 * bandOf(task) + task.startSlack + task.allowed.slack);
  };
  return isAstray(drive_.task()) || isAstray(part_.task());
}

void FollowProof::add(const Location& next) {
  if (interrupted_ != nullptr && interrupted_->load(std::memory_order_relaxed)) {
    return;
  }
  if (cutVectors_ == 0) {
    firstStep_ = next.toolEnd - first_.toolEnd;
  }
  drive_.add(next);
  part_.add(next);
  end_.moveTo(next);
  for (auto& count : counts_) {
    if (count) {
      count->add(next);
    }
  }
  ++cutVectors_;
}

StatementResult FollowProof::finish(const runtime::Action& action,
                                    std::span<const Goal> goals,
                                    std::size_t met) {
  const auto figures = [](const GuideStream& s) {
    return GuideFigures{s.task().surface.name, s.task().allowed, s.result()};
  };
  StatementResult result;
  result.origin = action.origin;
  result.isn = action.isn;
  result.statement = spell(std::get<runtime::Follow>(action.body).heading);
  result.cutVectors = cutVectors_;
  result.drive = figures(drive_);
  result.part = figures(part_);
  check_.judge(result, action, *result.part);
  check_.judge(result, action, *result.drive);
  if (drive_.task().cutter != nullptr) {
    check_.judgeHand(modal_, action, *result.drive, firstStep_, first_.axis);
  }
  if (met < goals.size()) {
    check_.judgeStop(result, modal_, action, goals[met], met, end_, drive_.task().surface.surface);
  }
  for (std::size_t i = 0; i < goals.size(); ++i) {
    // A stop that is missed is told as such.
    if (counts_[i] && (i != met || result.stops.back().good)) {
      check_.judgeCount(result, action, goals[i], *counts_[i], i == met);
    }
  }
  return result;
}

}  // namespace arelem::certify
