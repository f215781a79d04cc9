#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"
#include "runtime/timing/plan.h"

namespace arelem::timing {

/// What is known about the machine. Lengths in mm; MACHLM in the program overrides `limits`.
struct Machine {
  Limits limits{400.0, 4000.0, 20000.0};  ///< mm/s, mm/s2, mm/s3; rapid moves run at `velocity`
  double deviation = 0.01;   ///< mm by which a corner may be rounded; 0: the tool stops in corners
  double toolChange = 10.0;  ///< seconds of each tool change
};

struct TimeTable {
  double cutting = 0.0, rapid = 0.0, dwell = 0.0, toolChanges = 0.0;  ///< seconds
  std::uint64_t moves = 0, changes = 0;
  double cuttingLength = 0.0, rapidLength = 0.0;  ///< mm
  std::map<int, double> statements;               ///< seconds by internal statement number
  [[nodiscard]] double total() const { return cutting + rapid + dwell + toolChanges; }
};

/// Finds the time of a CL path: lines, arcs (points behind a CIRCLE or CYLNDR record) and path
/// splines, with the speed of every place limited by feed, curvature, corners and the machine. The
/// tool stops between rapid and cutting moves, at dwells, stops and tool changes. A location under
/// a CYCLE is a hole: there, down, peck by peck, and up again, all of them pieces of one move.
/// Turning axes of a machine are not looked at: the time is that of the tool end.
class CutTimer : public cl::RecordSink {
 public:
  CutTimer(const Machine& machine, DiagnosticSink& sink);
  ~CutTimer() override;
  CutTimer(CutTimer&&) noexcept;

  /// Told of each move but those of length 0: its number, counted from 0 over all locations behind
  /// the first one, and its seconds. Calls come in order, some records late.
  using PieceCall = std::function<void(std::uint64_t move, double seconds)>;
  void tellPieces(PieceCall call);

  void accept(const cl::Record& record) override;
  /// After the last record.
  [[nodiscard]] TimeTable finish();

 private:
  class Path;
  std::unique_ptr<Path> path_;
};

}  // namespace arelem::timing
