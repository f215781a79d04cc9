#pragma once
#include <span>

#include "ir/cl/record.h"
#include "runtime/interpret/action.h"

namespace arelem::motion {

/// Puts the records of one action after another into the stream, points in chunks of
/// path::numbersPerRecord numbers.
class RecordWriter {
 public:
  explicit RecordWriter(cl::RecordSink& sink) : sink_(sink) {}

  /// Everything until the next call belongs to this statement.
  void begin(const runtime::Action& action);
  /// Ends the statement: one that put out nothing still counts on the tape.
  void end();
  void put(cl::Body body);
  void putFeed(double feed) { put(cl::Post{Word::FEDRAT, "", {feed}}); }
  /// Starts a run of locations; `add` them, then `finish`.
  void startPoints(cl::Motion::Kind kind, const std::string& name, int subscript, bool withAxis);
  void add(const Vec3& toolEnd, const Vec3& axis);
  /// The numbers of many locations, as they stand in the records.
  void add(std::span<const double> locations);
  void finishPoints();
  /// The end of an arc or a spline.
  void putCurve(cl::Motion::Way way, const Vec3& end, const Vec3& axis, bool withAxis);
  /// One location with the direction of the tool's own x axis.
  void putPose(const runtime::Locate& locate, const Vec3& axis, const Vec3& side);
  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  void flush();

  cl::RecordSink& sink_;
  cl::Record record_;
  cl::Record points_;
  bool written_ = false;
  int lastIsn_ = -1;
  std::uint64_t count_ = 0;
};

}  // namespace arelem::motion
