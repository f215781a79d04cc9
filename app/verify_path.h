#pragma once
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"
#include "ir/hole/cycle.h"
#include "ir/hole/cycle_feed.h"
#include "ir/space/motion_tolerance.h"
#include "ir/space/vector.h"

namespace arelem::app {

/// One cutter location: where the tool end stands, and the axis where it was written. Lengths in
/// the part unit where nothing else is said.
struct Location {
  Vec3 point;
  std::optional<Vec3> axis;
  std::optional<Vec3> side;
  Span origin;
  std::set<int> on;    ///< outputs that are on when the tool leaves it
  double speed = 0.0;  ///< of the move to it, mm/s; 0: rapid, or unknown
  double wait = 0.0;   ///< of DELAY behind it, s
  std::optional<hole::Cycle> hole = std::nullopt;  ///< drilled there
  bool rapid = false;                              ///< the tool comes to it by RAPID or FROM
  double band = 0.0;                               ///< INTOL + OUTTOL on the way there, part unit
};

/// Keeps the locations of a stream of records and forgets the rest.
class Path : public cl::RecordSink {
 public:
  void accept(const cl::Record& record) override;
  std::vector<Location> locations;
  double millimeters = 1.0;  ///< of the part unit

 private:
  void word(const cl::Post& post);
  void cycle(const cl::Post& post);
  [[nodiscard]] hole::Cycle holeAt(const Vec3& point, const Vec3& axis) const;
  void switchOutput(const cl::Post& post);

  hole::Cycles cycles_;
  std::set<int> on_;
  hole::CycleFeed<double> speed_;
  double turns_ = 0.0;
  bool rapid_ = false;
  double inner_ = 0.0;
  double outer_ = tolerance::defaultOutside;
};

struct Allowed {
  double distance = 1e-6;  ///< part unit
  double degrees = 1e-4;
};

/// Outputs by number, for messages.
[[nodiscard]] std::string listed(const std::set<int>& outputs);
[[nodiscard]] double degreesBetween(const Vec3& a, const Vec3& b);
/// How one location differs from the one at its place in the program.
[[nodiscard]] std::optional<Diagnostic> difference(const Location& wanted,
                                                   const Location& found,
                                                   std::size_t number,
                                                   const std::string& name,
                                                   const Allowed& allowed);
/// The first difference ends the comparison: what follows a wrong location is seldom of use.
[[nodiscard]] std::optional<Diagnostic> firstDifference(const Path& wanted,
                                                        const Path& found,
                                                        const std::string& name,
                                                        const Allowed& allowed);

}  // namespace arelem::app
