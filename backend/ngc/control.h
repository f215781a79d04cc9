#pragma once
#include <cstddef>
#include <string>

namespace arelem::backend::ngc {

/// How a control reads RS-274: [control] of a machine file (docs/manual/machines.md). Lengths in
/// mm.
struct Control {
  bool inches = false;          ///< G20
  int decimals = 4;             ///< of lengths
  int angleDecimals = 4;        ///< of A, B, C
  double blend = 0.0;           ///< G64 P; 0: exact path G61
  double arcTolerance = 0.002;  ///< points may be off the arc that replaces them
  bool arcs = true;             ///< G2 and G3
  bool cycles = true;           ///< G81, G82, G83; false: their moves one by one
  bool toolLength = true;       ///< G43 behind a tool change
  bool lineNumbers = false;
  std::string offset = "G54";  ///< work offset of the header
  std::string end = "M2";
  std::size_t lineLimit = 255;  ///< characters of a line
};

}  // namespace arelem::backend::ngc
