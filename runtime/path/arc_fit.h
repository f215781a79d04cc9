#pragma once
#include <memory>

#include "ir/cl/record.h"

namespace arelem::path {

/// Puts arcs, helices and longer lines in the place of cut vectors. Of the band INTOL + OUTTOL in
/// force it spends `share` (0 to 1): the new path is nowhere farther than that from the old one.
///  * Cut vectors in a row that lie on a line become one.
///  * Cut vectors that turn about an axis parallel to x, y or z, at one radius and with an even
///    rise, become points on a circle, with a CIRCLE (axis z) or CYLNDR record before them.
/// Rapid moves, sequences that already have such a record, and moves under a turning axis stay.
class ArcFitter : public cl::RecordSink {
 public:
  /// After the last record.
  virtual void finish() = 0;
};
[[nodiscard]] std::unique_ptr<ArcFitter> makeArcFitter(cl::RecordSink& next, double share);

}  // namespace arelem::path
