#pragma once
#include <optional>
#include <vector>

#include "ir/cl/record.h"
#include "ir/space/vector.h"

namespace arelem::app {

/// A move of a CL file: where the tool goes and how.
struct ClMove {
  Vec3 end = Vec3::Zero();  ///< part unit of the file
  Vec3 axis = Vec3::UnitZ();
  std::optional<Vec3> center;  ///< of an arc
  double feed = 0.0;           ///< of the last FEDRAT; 0 before any
  bool rapid = false;
  cl::Motion::Way way = cl::Motion::Way::straight;
  Span origin;
  int isn = 0;
};

/// Keeps the moves of a stream of records.
class ClMoves : public cl::RecordSink {
 public:
  void accept(const cl::Record& record) override;
  std::vector<ClMove> moves;
  double millimeters = 1.0;  ///< of the part unit; 1 without UNITS
  bool hasUnit = false;

 private:
  bool rapid_ = false;
  double feed_ = 0.0;
  std::optional<Vec3> center_;
};

}  // namespace arelem::app
