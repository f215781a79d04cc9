#pragma once
#include "backend/html/scene.h"
#include "ir/cl/record.h"
#include "ir/text/source_map.h"
#include "runtime/timing/cut_timer.h"

namespace arelem::app {

/// Turns records into the arrays of a scene: locations, how the tool came there, statements, feeds,
/// cutters, and the time of each move.
class PathTrace : public cl::RecordSink {
 public:
  PathTrace(backend::Scene& scene, const SourceMap& sources);

  void accept(const cl::Record& record) override;
  /// After the last record. Without a feed the scene is not timed; moves then take what their
  /// length takes at one speed.
  void finish();
  /// Statement numbers of the stretches of the scene, in order.
  [[nodiscard]] const std::vector<int>& isns() const { return isns_; }

 private:
  void command(const cl::Post& post);
  void move(const cl::Motion& motion, const cl::Record& record);
  void beginStretch(const cl::Record& record);
  void addAxis(const cl::Motion& motion, std::size_t at);

  backend::Scene& scene_;
  const SourceMap& sources_;
  CollectingSink complaints_;
  timing::CutTimer timer_;
  std::vector<std::uint32_t> moves_;  ///< location at the end of each move
  std::vector<int> isns_;
  int isn_ = 0;
  backend::SceneMove kind_ = backend::SceneMove::feed;  ///< of the motion at present
  float feed_ = 0.0F;
  bool changed_ = false;  ///< RAPID or FEDRAT came since the last motion
  bool rapid_ = false, cycle_ = false, arc_ = false, gun_ = false, multax_ = false;
};

}  // namespace arelem::app
