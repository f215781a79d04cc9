#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "ir/diag/result.h"
#include "ir/space/vector.h"

namespace arelem::backend::ngc {

/// A control and its machine, as a TOML file describes them (docs/manual/controls.md). Lengths in
/// mm.
struct Machine {
  enum class Turning { none, tableAc, tableBc, headAc, headBc };
  bool inches = false;          ///< G20
  int decimals = 4;             ///< of lengths
  int angleDecimals = 4;        ///< of A, B, C
  double blend = 0.0;           ///< G64 P; 0: exact path G61
  double arcTolerance = 0.002;  ///< points may be off the arc that replaces them
  bool arcs = true;             ///< G2 and G3
  bool cycles = true;           ///< G81, G82, G83
  bool toolLength = true;       ///< G43 behind a tool change
  bool lineNumbers = false;
  std::string end = "M2";
  std::size_t lineLimit = 255;  ///< characters of a line
  Turning turning = Turning::none;
  bool toolPoint = true;       ///< the control keeps the tool end where the program says
  Vec3 center = Vec3::Zero();  ///< of the turning table
  double pivotLength = 0.0;    ///< from the tool end to the pivot of a turning head
};

/// Reads a control file. Errors name the key.
[[nodiscard]] Result<Machine> readMachine(std::string_view toml);

/// Angles in degrees that turn the tool axis (a unit vector), next to the angles before.
struct Angles {
  double tilt = 0.0;  ///< A or B
  double turn = 0.0;  ///< C
};
[[nodiscard]] Angles anglesOf(const Machine& machine, const Vec3& axis, const Angles& before);
/// Where the linear axes stand for a tool end, mm.
[[nodiscard]] Vec3 axesOf(const Machine& machine,
                          const Vec3& toolEnd,
                          const Vec3& axis,
                          const Angles& angles);

}  // namespace arelem::backend::ngc
