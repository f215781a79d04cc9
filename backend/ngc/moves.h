#pragma once
#include <optional>
#include <set>
#include <span>
#include <string>

#include "backend/ngc/block.h"
#include "backend/ngc/cycle.h"
#include "ir/diag/diagnostic.h"

namespace arelem::backend::ngc {

/// The motion of a program: where the tool stands, at what feed, along what.
class Moves {
 public:
  Moves(BlockWriter& block, const Machine& machine, DiagnosticSink& sink)
      : block_(block), machine_(machine), sink_(sink) {}

  void setRecord(const cl::Record& record) { record_ = &record; }
  void setUnit(double millimeters) { unit_ = millimeters; }
  void setBand(double band) { band_ = band; }
  void setSurface(const cl::SurfaceValue& surface) { surface_ = surface; }
  void setSpindle(double turns) { turns_ = turns; }
  [[nodiscard]] double spindle() const { return turns_; }  ///< turns a minute
  void rapid() { rapid_ = true; }
  void feed(const cl::Post& post);
  void cycle(const cl::Post& post);
  void move(const cl::Motion& motion);

 private:
  enum class FeedMode { perMinute, perTurn };

  void points(const cl::Motion& motion);
  void from(const Vec3& toolEnd, const Vec3& axis);
  void hole(const Vec3& at);
  void line(const Vec3& to, const Vec3& axis);
  std::size_t arc(std::span<const Vec3> rest, const Vec3& axis);
  void inverseTime(const Vec3& to, const Vec3& axis, const Angles& angles);
  void putFeed();
  void putAxes(const Vec3& toolEnd, const Vec3& axis, const Angles& angles);
  [[nodiscard]] bool turnsAllowed(const Vec3& axis);
  void report(Failure failure);

  BlockWriter& block_;
  const Machine& machine_;
  DiagnosticSink& sink_;
  const cl::Record* record_ = nullptr;
  double unit_ = 1.0;
  double band_ = 0.0;  // mm
  double turns_ = 0.0;
  bool rapid_ = false;
  std::optional<double> feed_;  // mm
  FeedMode feedMode_ = FeedMode::perMinute;
  std::optional<Cycle> cycle_;
  bool cycleOpen_ = false;
  std::optional<Vec3> at_;
  bool sure_ = false;  // the machine stands there: a move went to it
  Vec3 axis_ = Vec3::UnitZ();
  Angles angles_;
  std::optional<cl::SurfaceValue> surface_, run_;
  std::set<const DiagRow*> reported_;
};

}  // namespace arelem::backend::ngc
