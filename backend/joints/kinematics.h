#pragma once
#include <array>
#include <string_view>

#include "backend/joints/trajectory.h"

namespace arelem::joints {

/// The two joints of an arm that reaches out and turns: actuator of a pantograph (mm) or half the
/// angle of an elbow (degrees), and the turn about its axis (degrees).
struct JointState {
  std::array<double, 2> place{};
  std::array<double, 2> speed{};
  std::array<double, 2> acceleration{};
};

/// The arm of a machine file: a pantograph, whose actuator goes r = R / ratio (Blank 2.25, 2.26),
/// or an elbow of two equal links, cos phi = R / (2 link) (listing pathS.c, corrected; its encoders
/// count both angles).
class Arm {
 public:
  explicit Arm(const robot::Machine& machine);

  [[nodiscard]] bool isPantograph() const { return pantograph_.has_value(); }
  [[nodiscard]] std::string_view name() const { return isPantograph() ? "pantograph" : "elbow"; }
  /// "actuator" or "elbow", and "turn".
  [[nodiscard]] std::string_view jointName(std::size_t joint) const;
  /// "mm" or "deg", "deg".
  [[nodiscard]] std::string_view unit(std::size_t joint) const;
  [[nodiscard]] robot::Range range(std::size_t joint) const;
  [[nodiscard]] double mostSpeed(std::size_t joint) const;
  [[nodiscard]] double mostAcceleration(std::size_t joint) const;
  /// Encoder counts for one mm or degree of a joint; 0: not stated.
  [[nodiscard]] double counts(std::size_t joint) const;
  /// Radii between which the tool can be, mm.
  [[nodiscard]] robot::Range reach() const;

  /// Joints of a state of the tool, whose radius lies within the reach and above 0. The turn is the
  /// one nearest to `turnBefore`, degrees.
  [[nodiscard]] JointState jointsOf(const State& tool, double turnBefore) const;
  /// Where the tool is, from joints.
  [[nodiscard]] Eigen::Vector2d placeOf(const JointState& joints) const;

 private:
  std::optional<robot::Pantograph> pantograph_;
  robot::Elbow elbow_;
};

}  // namespace arelem::joints
