#pragma once
#include <optional>

#include "runtime/motion/arc.h"
#include "runtime/motion/records.h"
#include "runtime/motion/state.h"
#include "runtime/path/cl_spline.h"

namespace arelem::motion {

struct CurveFact {
  const char* statement = "";
  double length = 0.0;  ///< of the path, part unit
  std::vector<Failure> warnings;
};

/// Arcs and splines of CL files: the tool moves along them as they are, without cut vectors. An arc
/// waits for the GOTO of its end; a spline ends where another statement than KNOT and CNTRL stands.
class ClCurves {
 public:
  ClCurves(State& state, RecordWriter& writer) : state_(state), writer_(writer) {}

  /// A warning where an arc waits already.
  [[nodiscard]] std::optional<Failure> begin(const runtime::Arc& arc);
  [[nodiscard]] bool waits() const { return arc_.has_value(); }
  /// Forgets the arc that waits, with a warning.
  [[nodiscard]] Failure drop();
  /// Moves the tool along the arc and writes circles and ends.
  [[nodiscard]] Result<CurveFact> goAlong(const runtime::Locate& to);

  /// Told of all records that pass: NURBS, KNOT and CNTRL are a spline.
  void look(const cl::Body& body);
  [[nodiscard]] bool endsSpline(const runtime::Action& next) const;
  /// Moves the tool to the end of the spline, whose posts were written before.
  [[nodiscard]] Result<CurveFact> goAlong();

 private:
  State& state_;
  RecordWriter& writer_;
  std::optional<runtime::Arc> arc_;
  path::ClSpline spline_;
};

/// An axis that is not z is written even without MULTAX: CL files of CAM systems have none.
void showAxis(State& state, RecordWriter& writer);

}  // namespace arelem::motion
