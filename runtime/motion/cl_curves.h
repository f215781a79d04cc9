#pragma once
#include <optional>

#include "runtime/motion/arc.h"
#include "runtime/motion/records.h"
#include "runtime/motion/reporter.h"
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
  /// `text`: the program is a CL file, where a chord of an arc may be meant as a part of it.
  ClCurves(State& state, RecordWriter& writer, Reporter& reporter, bool text)
      : state_(state), writer_(writer), reporter_(reporter), tellsChords_(text) {}

  /// Told of every action before it is performed, null at the end of all. An arc that waits is
  /// forgotten with a warning where that is neither its GOTO nor a statement that moves nothing.
  void tellLost(const runtime::Action* next);
  void begin(const runtime::Action& arc) { waiting_ = arc; }
  /// The location is the end of the arc that waits, or one more point of the arc before it, of
  /// which it is the next statement. `step` counts statements.
  [[nodiscard]] bool takes(const runtime::Locate& to, std::uint64_t step);
  /// Moves the tool along the arc and writes circles and ends.
  [[nodiscard]] Result<CurveFact> goAlong(const runtime::Locate& to);

  /// Told of all records that pass: NURBS, KNOT and CNTRL are a spline.
  void look(const cl::Body& body);
  [[nodiscard]] bool endsSpline(const runtime::Action& next) const;
  /// Moves the tool to the end of the spline, whose posts were written before.
  [[nodiscard]] Result<CurveFact> goAlong();

 private:
  /// The arc of the statement before.
  struct Divided {
    runtime::Arc arc;
    std::uint64_t step = 0;
    double turned = 0.0;  ///< radians since the arc began
    bool fine = false;    ///< its chord is as near to it as those of Creo's POINTS_&_ARC
  };
  [[nodiscard]] std::optional<double> levelTurn(const ArcMove& move) const;
  [[nodiscard]] static double riseOf(const ArcMove& move, double turn);

  State& state_;
  RecordWriter& writer_;
  Reporter& reporter_;
  std::optional<runtime::Action> waiting_;
  std::optional<Divided> divided_;
  const runtime::Action* now_ = nullptr;
  bool tellsChords_;
  bool creo_ = false;  ///< the program names features as Creo does
  std::uint64_t step_ = 0;
  std::optional<Word> unit_;
  path::ClSpline spline_;
};

/// MULTAX/OFF of CAM systems: locations of three numbers behind it have the axis z.
void endAxes(State& state, const runtime::Toggle& toggle);

/// An axis that is not z is written even without MULTAX: CL files of CAM systems have none.
void showAxis(State& state, RecordWriter& writer);

}  // namespace arelem::motion
