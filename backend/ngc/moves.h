#pragma once
#include <optional>
#include <set>
#include <span>
#include <string>

#include "backend/ngc/block.h"
#include "backend/ngc/compensation.h"
#include "backend/robot/turned_move.h"
#include "ir/cl/feed.h"
#include "ir/diag/diagnostic.h"
#include "ir/hole/cycle.h"
#include "ir/hole/cycle_feed.h"

namespace arelem::backend::ngc {

/// The motion of a program: where the tool stands, at what feed, along what.
class Moves {
 public:
  /// `turning` is null for a machine without turning axes.
  Moves(BlockWriter& block,
        const Control& control,
        const robot::Turning* turning,
        DiagnosticSink& sink)
      : block_(block), control_(control), turning_(turning), sink_(sink), compensation_(block) {}

  void setRecord(const cl::Record& record) { record_ = &record; }
  void setUnit(double millimeters) { unit_ = millimeters; }
  void setBand(double band) { band_ = band; }
  void setSurface(const cl::SurfaceValue& surface) { surface_ = surface; }
  void setSpindle(double turns) { turns_ = turns; }
  enum class Spindle { off, clockwise, counterclockwise };
  void setSpindle(Spindle spindle) { spindle_ = spindle; }
  [[nodiscard]] double spindle() const { return turns_; }  ///< turns a minute
  void setCutter(double diameter) { cutter_ = diameter; }
  [[nodiscard]] double cutter() const { return cutter_; }  ///< diameter, part unit
  [[nodiscard]] Compensation& compensation() { return compensation_; }
  void rapid() { rapid_ = true; }
  void feed(const cl::Post& post);
  void cycle(const cl::Post& post);
  void move(const cl::Motion& motion);

 private:
  /// What FEDRAT says; none where it is refused.
  [[nodiscard]] std::optional<cl::Feed> readFeed(const cl::Post& post);
  void points(const cl::Motion& motion);
  void from(const robot::ToolPose& pose);
  void line(const robot::ToolPose& to);
  void straight(const robot::TurnedPlace& to);
  void tellStanding(const std::vector<robot::TurnedPlace>& places);
  [[nodiscard]] std::optional<std::vector<robot::TurnedPlace>> way(const robot::ToolPose& to);
  std::size_t arc(std::span<const Vec3> rest);
  void drill(const robot::ToolPose& at);
  void drill(const robot::ToolPose& at, const hole::Cycle& cycle);
  void approach(const robot::ToolPose& clear, const hole::Cycle& cycle);
  [[nodiscard]] bool cycleAllowed(bool canned);
  void cannedHole(const robot::ToolPose& at, const hole::Cycle& cycle);
  void drilledHole(const robot::ToolPose& at, const hole::Cycle& cycle);
  void endCycle();
  void closeCycle();
  void putFeed(double length);
  void putAxes(const robot::TurnedPlace& to);
  [[nodiscard]] bool standsAt(const Vec3& linear, const robot::Angles& angles) const;
  [[nodiscard]] bool feedIsKnown(const Vec3& to);
  [[nodiscard]] bool turnsAllowed(const Vec3& axis);
  /// Where the linear axes stand for a place of the part, with the angles of now.
  [[nodiscard]] Vec3 onMachine(const Vec3& place) const;
  void report(Failure failure);

  BlockWriter& block_;
  const Control& control_;
  const robot::Turning* turning_;
  DiagnosticSink& sink_;
  Compensation compensation_;
  double cutter_ = 0.0;
  const cl::Record* record_ = nullptr;
  double unit_ = 1.0;
  double band_ = 0.0;  // mm
  double turns_ = 0.0;
  Spindle spindle_ = Spindle::off;
  bool rapid_ = false;
  bool rapidRun_ = false;  // the motion whose records come goes at rapid
  hole::CycleFeed<cl::Feed> feed_;
  hole::Cycles cycles_;
  double share_ = 1.0;  // of a divided move that a line is: it has as much of an inverse time
  bool cycleOpen_ = false;
  bool placed_ = false;  // there was a location
  bool sure_ = false;    // the machine stands there: a move went to it
  robot::TurnedPlace now_;
  std::optional<cl::SurfaceValue> surface_, run_;
  std::set<const DiagRow*> reported_;
};

}  // namespace arelem::backend::ngc
