#pragma once
#include "backend/robot/pose.h"
#include "ir/diag/result.h"

namespace arelem::robot {

/// Whether the tool point, seen from the base, lies in the machine file's envelope. Error E0667.
[[nodiscard]] std::optional<Failure> objectionToPlace(const Envelope& envelope,
                                                      const Pose& inBase,
                                                      std::string_view place);

}  // namespace arelem::robot
