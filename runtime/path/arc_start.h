#pragma once
#include <memory>

#include "ir/cl/record.h"

namespace arelem::path {

/// Before TRACUT, INDEX and COPY act: an arc begins where the tool is, and behind such a statement
/// the tool is not where the matrix brings the begin of an arc. A location there makes it so: the
/// tool goes straight to the begin of the moved arc, as it does where arcs are cut vectors.
[[nodiscard]] std::unique_ptr<cl::RecordSink> makeArcStart(cl::RecordSink& next);

}  // namespace arelem::path
