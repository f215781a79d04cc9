#pragma once
#include <optional>

#include "ir/cl/record.h"
#include "runtime/path/affine.h"

/// The frames of CL files. The places behind such a post are in the frame that it names.
namespace arelem::path {

/// Takes places of the frame to the frame in which it is given. MSYS/ origin, x axis, y axis (NX; z
/// completes them), LOCAL_ORIGIN, x, y, z (CATIA turning), CATIA0/ [name,] three rows of four
/// numbers (CATIA). None for other posts, and where numbers are missing or the axes are not square.
[[nodiscard]] std::optional<Affine> frameOf(const cl::Post& post);

/// The turn of ROTABL/ angle,{AAXIS|BAXIS|CAXIS},TABLE,{CCLW|CLW} (CAMWorks): radians, about x, y
/// or z of the frame as it stands, so that the turns of a file follow one another. None for other
/// forms.
[[nodiscard]] std::optional<Affine> turnOf(const cl::Post& post);

/// OPFEATEND of CAMWorks: the operation is over, and so are the turns of its tables, whether the
/// file turns them back or not.
[[nodiscard]] bool endsTurns(const cl::Post& post);

/// The same post where its frame is the one in which it is given.
[[nodiscard]] cl::Post withoutFrame(const cl::Post& post);

/// The frame that holds, told of one post after another. MSYS and CATIA0 begin a new one,
/// LOCAL_ORIGIN shifts it, ROTABL turns it, OPFEATEND ends the turns.
class FrameOfPlaces {
 public:
  /// False when the post names no frame.
  bool take(const cl::Post& post);
  /// Places of the file in the frame of the part.
  [[nodiscard]] Affine toPart() const { return base_.after(shift_.after(turn_)); }

 private:
  Affine base_, shift_, turn_;
};

}  // namespace arelem::path
