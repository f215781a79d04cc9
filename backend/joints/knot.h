#pragma once
#include <vector>

#include "backend/robot/objections.h"
#include "backend/robot/pose.h"
#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"

namespace arelem::joints {

/// A location of the CL as the arm must reach it, seen from its base. Lengths mm, angles degrees.
struct Knot {
  Vec3 point = Vec3::Zero();
  double heading = 0.0;  ///< of the tool's side from x, without jumps of more than half a turn
  double tilt = 0.0;
  double speed = 0.0;  ///< of the move to it, mm/s
  bool stop = false;   ///< the tool stands still here
  double dwell = 0.0;  ///< and waits, s
  bool gun = false;    ///< open on the way from here
  std::size_t location = 0;
  Span origin;
};

/// Collects the locations of CL records. Tools that lean otherwise than along their side are told
/// to the sink (E0664), tilts beyond the tilt axis (E0665), feeds without a speed as E0621, waits
/// without an end as E0625, CYCLE as E0673, words without a meaning as W0687.
class KnotReader {
 public:
  KnotReader(const robot::Machine& machine, DiagnosticSink& sink)
      : machine_(machine), sink_(sink) {}

  void accept(const cl::Record& record);
  [[nodiscard]] const std::vector<Knot>& knots() const { return knots_; }
  /// Whether something was told that leaves the path without meaning.
  [[nodiscard]] bool failed() const { return failed_; }
  /// Behind the last record: objections to locations, each kind once.
  void finish() { objections_.report(location_, sink_); }

 private:
  void motion(const cl::Motion& motion, const Span& origin);
  void location(const robot::Pose& pose, const Span& origin);
  void post(const cl::Post& post, const Span& origin);
  void spray(const cl::Post& post);
  [[nodiscard]] std::optional<robot::Objection> objectionToTilt(double tilt,
                                                                const std::string& place) const;
  void object(robot::Objection objection, const Span& origin);
  void without(std::string_view what, const Span& origin);
  void refuse(Failure failure, const Span& origin);
  void stopHere(double seconds);

  const robot::Machine& machine_;
  DiagnosticSink& sink_;
  std::vector<Knot> knots_;
  std::vector<std::string> told_;
  double millimeters_ = 1.0;
  double speed_ = 0.0;
  double turns_ = 0.0;  // of a spindle, a minute
  robot::Objections objections_;
  bool rapid_ = false;
  bool gun_ = false;
  bool failed_ = false;
  std::size_t location_ = 0;
};

}  // namespace arelem::joints
