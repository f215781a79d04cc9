#pragma once
#include <optional>

#include "backend/robot/machine.h"
#include "backend/robot/objections.h"
#include "backend/robot/pose.h"

namespace arelem::robot {

/// Whether the robot of a machine file can go through a path: envelope, reach and joints at every
/// pose, joints on the straight ways between. What it cannot is told at the end, each kind once.
class ReachCheck {
 public:
  explicit ReachCheck(const Machine& machine) : machine_(machine) {}

  /// A location of the path begins; its poses follow.
  void begin(const Span& origin) {
    origin_ = origin;
    ++location_;
  }
  /// The robot goes to a pose, seen from its base; straight, or by its joints. `place` tells it in
  /// messages.
  void moveTo(const Pose& pose, std::string_view place, bool straight);
  /// An objection that another part of the machine has to the location.
  void refuse(Failure failure, double excess);
  void report(DiagnosticSink& sink) const { objections_.report(location_, sink); }

 private:
  const Machine& machine_;
  Objections objections_;
  Span origin_;
  std::size_t location_ = 0;
  double joint4_ = 0.0;
  std::optional<Vec3> before_;
};

}  // namespace arelem::robot
