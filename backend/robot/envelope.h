#pragma once
#include "backend/robot/objections.h"
#include "backend/robot/pose.h"

namespace arelem::robot {

/// Whether the tool point, seen from the base, lies in the machine file's envelope. Error E0667, by
/// how much.
[[nodiscard]] std::optional<Objection> objectionToPlace(const Envelope& envelope,
                                                        const Pose& inBase,
                                                        std::string_view place);

}  // namespace arelem::robot
