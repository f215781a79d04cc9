#include "backend/robot/reach_check.h"

#include "backend/robot/envelope.h"
#include "backend/robot/reach.h"

namespace arelem::robot {

void ReachCheck::refuse(Failure failure, double excess) {
  objections_.add({std::move(failure), excess}, location_, origin_);
}

void ReachCheck::moveTo(const Pose& pose, std::string_view place, bool straight) {
  const auto add = [&](std::optional<Objection> objection) {
    const bool objects = objection.has_value();
    if (objects) {
      objections_.add(*std::move(objection), location_, origin_);
    }
    return objects;
  };
  if (machine_.envelope) {
    add(objectionToPlace(*machine_.envelope, pose, place));
  }
  const std::optional<Vec3> from = std::exchange(before_, pose.point);
  if (!machine_.scara) {
    return;
  }
  const std::optional<Upright> upright = uprightOf(pose);
  const double heading = upright ? upright->heading : 0.0;
  if (add(objectionToPlace(*machine_.scara, pose.point, heading, joint4_, place))) {
    return;
  }
  joint4_ = jointsOf(*machine_.scara, pose.point, heading, joint4_).joint4;
  if (from && straight) {
    add(objectionToLine(*machine_.scara, *from, pose.point, place));
  }
}

}  // namespace arelem::robot
