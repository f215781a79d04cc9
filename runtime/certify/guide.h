#pragma once
#include <memory>
#include <string>

#include "ir/limits.h"
#include "runtime/certify/modal.h"
#include "runtime/certify/prove.h"

namespace arelem::certify {

/// A location of the tool.
struct Location {
  Vec3 toolEnd = Vec3::Zero(), axis = Vec3::UnitZ();
};

/// One surface that a motion is to keep to.
struct GuideTask {
  Named surface;
  const tool::Profile* cutter = nullptr;  ///< null: the tool end is to be on the surface
  double thick = 0.0;
  Allowed allowed;
  /// Beyond the band by which the place where a motion begins may be off (spec 4.8).
  double startSlack = 0.0;
};

/// What was proven of a motion along one surface.
struct GuideResult {
  Verdict verdict;    ///< the worst of all cut vectors
  double side = 1.0;  ///< of the surface, by its normal, on which the tool is
  std::size_t leastVector = 0, greatestVector = 0;  ///< cut vectors, counted from 0
  Vec3 leastPlace = Vec3::Zero(), greatestPlace = Vec3::Zero();
  Vec3 firstNormal = Vec3::UnitZ();  ///< of the contact at the beginning
  double startGap = 0.0;             ///< at the place where the motion begins
};

/// Proves the tolerance of one surface along a path whose locations come one after another; its
/// memory does not grow with them. The tool is taken to stand on the side of the surface that it is
/// nearer to at first; where both sides would do, and for a tool end on the surface, on the one
/// that keeps the tolerance.
class GuideStream {
 public:
  /// `first` is where the motion begins. The cutter of the task must stay in place.
  GuideStream(GuideTask task, const Location& first);
  GuideStream(GuideStream&&) noexcept;
  ~GuideStream();
  GuideStream(const GuideStream&) = delete;
  GuideStream& operator=(const GuideStream&) = delete;
  GuideStream& operator=(GuideStream&&) = delete;

  void add(const Location& next);
  /// True where the cut vector to `next` would keep the tolerance; it is not taken.
  [[nodiscard]] bool keeps(const Location& next);
  [[nodiscard]] const GuideTask& task() const { return *task_; }
  [[nodiscard]] const GuideResult& result() const;

 private:
  class Proof;
  std::unique_ptr<GuideTask> task_;
  std::unique_ptr<Proof> proof_, other_;  ///< the other side, as long as it may be the right one
};

/// The contact of the tool at one place with one side of a surface.
struct Touch {
  double low = 0.0, high = 0.0;  ///< the gap lies between
  Vec3 normal = Vec3::UnitZ();
  Vec3 offset = Vec3::Zero();  ///< of the point of the tool from the tool end
};
[[nodiscard]] Touch touch(const surface::AnySurface& surface,
                          const Relation& relation,
                          const Location& at,
                          const Allowed& allowed);

}  // namespace arelem::certify
